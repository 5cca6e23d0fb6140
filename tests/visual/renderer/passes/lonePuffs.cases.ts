/** Puffs without other casters keep all of their light. */
import { type Camera, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { colorAt, type Color } from '../../../../src/renderer/gpu/ramps.ts';
import type { PuffForm } from '../../../../src/renderer/gpu/puffTextures.ts';
import { MAX_LOBES } from '../../../../src/base/constants.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { CARTOON_KNOBS, proceduralPuff } from '../../../../src/renderer/puffs/procedural.ts';
import type { PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { parseStops, plainColorOf, rampOf } from '../../../../src/renderer/palette.ts';
import type { Style } from '../../../../src/renderer/style.ts';
import { Lab, PLAIN_STYLE, type LabPuff } from '../../lab.ts';
import { pageDevice } from '../../pageDevice.ts';
import { random } from '../../random.ts';
import { ground } from '../../solids.ts';
import { colors, differing } from './puffs.cases.ts';

const [WIDTH, HEIGHT] = [240, 180];

/**
 * Minimum distance of the puffs of a picture as seen from the light, in sums of their radii, so that none shades
 * another.
 */
const APART = 1.4;

/** Attempts to find a position for one more puff. */
const TRIES = 40;

/** A ramp with an early first stop, a fill light and a rim: none of its tones may start behind the shadow volume. */
export const EARLY: Partial<Style> = {
  stops: parseStops('0:3a3f6b,.3:7a6fa8,.8:fff4d8'),
  isBlended: true,
  fill: 0.4,
  rim: 0.5,
};

/**
 * Puffs without other casters, with random lights, orientations and cameras, up to 35 degrees off the axis: lit pixels
 * that the puff's own shadow volume masks. Each picture has as many of the `trials` puffs as fit without shading each
 * other.
 */
export function selfMasked(
  form: PuffForm,
  light: 'sun' | 'lamp',
  trials: number,
  shapes: readonly PuffShape[] = LOBE_SHAPES,
  toning: Partial<Style> = { tones: 3 },
): { lit: number; masked: number } {
  const next = random(2006);
  const lab = new Lab({ width: WIDTH, height: HEIGHT, puffs: [], shapes, capacity: trials });
  const result = { lit: 0, masked: 0 };
  for (let drawn = 0; drawn < trials;) {
    const camera = rotatedCamera(next);
    const { puffs, ...lighting } = (light === 'sun' ? sunny : aroundLamp)(camera, trials - drawn, next);
    for (const puff of puffs) puff.variation = drawn++ % shapes.length;
    const scene = { width: WIDTH, height: HEIGHT, puffs, camera, ...lighting };
    const masked = lab.draw({ ...scene, style: { form, ...toning } });
    const free = lab.draw({ ...scene, style: { form, ...toning, shadows: false } });
    result.lit += litPixels(colors(free), toning);
    result.masked += differing(masked, free);
  }
  lab.dispose();
  return result;
}

/**
 * A puff with the most lobes that is half dissolved, on a GPU with a number of varyings.
 * @returns pixels that differ from the whole puff, and the WebGL error
 */
export function bittenPixels(maxVaryings: number): { differing: number; error: number } {
  const { capabilities } = pageDevice().renderer;
  const real = capabilities.maxVaryings;
  capabilities.maxVaryings = maxVaryings;
  const scene = { width: WIDTH, height: HEIGHT, shapes: [proceduralPuff('most', 5, CARTOON_KNOBS, MAX_LOBES)] };
  const lab = new Lab({ ...scene, puffs: [], surfaces: [ground(-1, 3)] });
  const [whole, bitten] = [0, 0.5].map((erosion) =>
    lab.draw({ ...scene, puffs: [{ place: [0, 0, 0], radius: 0.8, erosion }], style: { isEroded: true } }),
  );
  const { error } = lab;
  lab.dispose();
  capabilities.maxVaryings = real;
  return { differing: differing(whole, bitten), error };
}

type Random = () => number;
type Triple = [number, number, number];

function rotatedCamera(next: Random): Camera {
  const camera = new PerspectiveCamera(78, WIDTH / HEIGHT, 0.1, 50);
  camera.quaternion.copy(new Quaternion(next() - 0.5, next() - 0.5, next() - 0.5, next() - 0.5).normalize());
  camera.updateMatrixWorld();
  return camera;
}

function direction(next: Random): Vector3 {
  return new Vector3().setFromSphericalCoords(1, Math.acos(2 * next() - 1), next() * 2 * Math.PI);
}

/** Puffs in front of a camera whose lines along the light direction do not intersect. */
function sunny(camera: Camera, max: number, next: Random): { puffs: LabPuff[]; towardsLight: Triple } {
  const towards = direction(next);
  const across = (puff: LabPuff) => new Vector3(...puff.place).projectOnPlane(towards);
  const distance = (a: LabPuff, b: LabPuff) => across(a).distanceTo(across(b)) / (a.radius + b.radius);
  const puffs = spacedApart(max, distance, () => rotatedPuff(next, seenPlace(camera, next), 0.35 + 0.25 * next()));
  return { puffs, towardsLight: towards.toArray() };
}

/** Puffs around a lamp, each two radii away from it. */
function aroundLamp(camera: Camera, max: number, next: Random): { puffs: LabPuff[]; lamp: Triple } {
  const lamp = new Vector3(next() - 0.5, next() - 0.5, -2).applyMatrix4(camera.matrixWorld);
  const towards = (puff: LabPuff) => new Vector3(...puff.place).sub(lamp).normalize();
  // The radius is half the distance, so the sum of two radii is 1 on the unit sphere around the lamp.
  const distance = (a: LabPuff, b: LabPuff) => towards(a).distanceTo(towards(b));
  const puffs = spacedApart(max, distance, () => {
    const radius = 0.35 + 0.25 * next();
    return rotatedPuff(
      next,
      direction(next)
        .multiplyScalar(2 * radius)
        .add(lamp),
      radius,
    );
  });
  return { puffs, lamp: lamp.toArray() };
}

/** One to `max` puffs. @param distance distance of two puffs as seen from the light, in sums of their radii */
function spacedApart(max: number, distance: (a: LabPuff, b: LabPuff) => number, seek: () => LabPuff): LabPuff[] {
  const puffs: LabPuff[] = [];
  for (let tries = 0; tries < TRIES && puffs.length < max; ++tries) {
    const puff = seek();
    if (puffs.every((other) => distance(puff, other) > APART)) puffs.push(puff);
  }
  return puffs;
}

/** A random position up to 35 degrees off the camera's axis. */
function seenPlace(camera: Camera, next: Random): Vector3 {
  const slope = Math.tan((35 * Math.PI) / 180) * Math.sqrt(next());
  const angle = next() * 2 * Math.PI;
  const depth = 1.6 + 1.4 * next();
  const place = new Vector3(Math.cos(angle) * slope * depth, Math.sin(angle) * slope * depth, -depth);
  return place.applyMatrix4(camera.matrixWorld);
}

function rotatedPuff(next: Random, place: Vector3, radius: number): LabPuff {
  const [roll, seed] = [next() * 2 * Math.PI, Math.floor(next() * 256)];
  // Read only by styles with erosion; from the seed, because the places of all puffs follow from the random numbers.
  return { place: place.toArray(), radius, roll, seed, erosion: ((seed * 97) % 256) / 255 };
}

/** Pixels that are not ink, page or the darkest tone, which receives no light. */
function litPixels(found: Record<string, number>, toning: Partial<Style>): number {
  const dark = darkestOf({ ...PLAIN_STYLE, ...toning }).join();
  const isLit = (color: string) =>
    color !== '0,0,0,0' && ![dark, PLAIN_STYLE.inkColor.join()].some((other) => color.startsWith(other));
  return Object.entries(found).reduce((sum, [color, count]) => sum + (isLit(color) ? count : 0), 0);
}

function darkestOf(style: Style): Color {
  return colorAt(rampOf(plainColorOf(style), style).unlit, 0);
}
