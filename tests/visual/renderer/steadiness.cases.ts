/** Whole scenes, picture by picture: nothing pops over time or jumps while the camera orbits. */
import { Vector3, type PerspectiveCamera } from 'three';
import { readParticles } from '../../bench/support/snapshot.ts';
import type { LabPicture } from '../lab.ts';
import { suddenChange, suddenPixels } from '../motion.ts';
import { SceneLab } from '../sceneLab.ts';

const SIZE = { width: 200, height: 200 };
/** No part of a scene is closer to the eye than this while the camera orbits, as a share of the camera distance. */
const NEAREST = 0.6;
/** Added to the motion: the width of a pixel, and rounding. */
const SLACK = 2;
/** Largest distance of a visible object's centre from the centre of the picture, in half sizes of the picture. */
const BESIDE = 1.3;

export interface Steadiness {
  /** Pixels of the largest area that appears or vanishes between two pictures, and the number of the picture. */
  largest: number;
  at: number;
  /** Largest number of pixels of all such areas of one picture. */
  all: number;
  /** Largest allowed motion, pixels. */
  motion: number;
  pictures: number;
  /** Pictures that are not counted: smoke may appear at once. */
  sudden: number;
  /** Mean per picture: a rocket before ignition has none. */
  bodies: number;
  /** Mean number of pixels of a picture that smoke, its lines and its shadow change. */
  smoke: number;
}

/**
 * Pictures of successive steps. Self-rotating parts, such as a propeller, are stopped.
 * @param sudden steps at which smoke may appear at once
 */
export async function timePassing(
  scene: string,
  fromStep: number,
  steps: number,
  sudden: readonly number[] = [],
): Promise<Steadiness> {
  const lab = await SceneLab.create(scene, { ...SIZE, holdsRotations: true });
  lab.step(fromStep);
  let corners = surfaceCorners(lab);
  const report = await watch(lab, lab.camera(), steps, () => {
    lab.step(1);
    const [before, camera] = [corners, lab.camera()];
    corners = surfaceCorners(lab);
    const motion = Math.max(longestWay(before, corners, camera), longestWay(...particlePaths(lab), camera));
    return { camera, motion, isSudden: sudden.includes(lab.simulator.steps) };
  });
  lab.dispose();
  return report;
}

/** Pictures one degree apart, with stopped time, at a distance that keeps smoke away from the eye. */
export async function orbiting(scene: string, atStep: number, degrees: number): Promise<Steadiness> {
  const lab = await SceneLab.create(scene, { ...SIZE, holdsRotations: true });
  lab.step(atStep);
  const { azimuth, distance: own, target } = lab.scene.camera;
  const [, particles] = particlePaths(lab);
  const extent = Math.max(...particles.map((place) => place.distanceTo(new Vector3(...target))));
  const distance = Math.max(own, extent / (1 - NEAREST));
  const step = Math.PI / 180;
  const report = await watch(lab, lab.camera({ distance }), degrees, (degree) => ({
    camera: lab.camera({ azimuth: azimuth + degree * step, distance }),
    motion: (1 - NEAREST) * distance * step * lab.pixelsPerMetre(NEAREST * distance),
  }));
  lab.dispose();
  return report;
}

type Next = (picture: number) => { camera: PerspectiveCamera; motion: number; isSudden?: boolean };

async function watch(lab: SceneLab, first: PerspectiveCamera, pictures: number, next: Next): Promise<Steadiness> {
  const report: Steadiness = { largest: 0, at: 0, all: 0, motion: 0, pictures, sudden: 0, bodies: 0, smoke: 0 };
  let before = look(lab, first, SLACK);
  for (let picture = 1; picture <= pictures; picture++) {
    const { camera, motion, isSudden } = next(picture);
    const [reach, strip] = [Math.ceil(motion) + SLACK, { width: Math.ceil(motion), ink: lab.ink }];
    const now = look(lab, camera, reach);
    const paling = { where: now.paling.map((isPaling, pixel) => isPaling | before.paling[pixel]), ink: lab.ink };
    const besides = surfacesAlone(before.bare, now.bare, reach);
    const { all, largest } = suddenChange(before.picture, now.picture, { reach, strip, paling, besides });
    if (isSudden) report.sudden++;
    else if (largest > report.largest) Object.assign(report, { largest, at: picture });
    report.all = Math.max(report.all, all);
    report.motion = Math.max(report.motion, motion);
    report.bodies += now.bodies / pictures;
    report.smoke += differing(now.picture, now.bare) / pictures;
    before = now;
  }
  return report;
}

function differing(one: LabPicture, other: LabPicture): number {
  const [a, b] = [one, other].map(({ pixels }) => new Uint32Array(pixels.buffer));
  return a.reduce((sum, color, pixel) => sum + (color === b[pixel] ? 0 : 1), 0);
}

/** A picture with smoke and one without. The light of hot smoke on surfaces is left out: its rings flash with a burst. */
function look(lab: SceneLab, camera: PerspectiveCamera, reach: number) {
  const picture = lab.draw({ camera, hasLamps: false });
  const bodies = lab.report!.bodiesDrawn;
  const paling = palingLines(lab, camera, reach);
  return { picture, bodies, paling, bare: lab.draw({ camera, isBare: true }) };
}

/** Pixels at which surfaces alone appear or vanish, such as one that sinks into another faster than it moves. */
function surfacesAlone(before: LabPicture, now: LabPicture, reach: number): Set<number> {
  return new Set([...suddenPixels(before, now, { reach }), ...suddenPixels(now, before, { reach })]);
}

/**
 * Pixels around puffs of the latest picture with a radius of one to three line widths: there the formula of
 * shaders/lib/ink.glsl blends the line into smoke.
 */
function palingLines(lab: SceneLab, camera: PerspectiveCamera, reach: number): Uint8Array {
  const where = new Uint8Array(SIZE.width * SIZE.height);
  const line = lab.widestLine;
  for (const { place, radius } of lab.bodies()) {
    const pixels = (radius * lab.pixelsPerMetre(1)) / -place.clone().applyMatrix4(camera.matrixWorldInverse).z;
    if (pixels < line || pixels > 3 * line) continue;
    const { x, y } = place.project(camera);
    markDisc(where, [(0.5 + x / 2) * SIZE.width, (0.5 + y / 2) * SIZE.height], pixels + line + reach);
  }
  return where;
}

function markDisc(where: Uint8Array, [left, below]: [number, number], radius: number): void {
  const rows = { first: Math.max(0, Math.floor(below - radius)), last: Math.min(SIZE.height - 1, below + radius) };
  for (let y = rows.first; y <= rows.last; y++) {
    const half = Math.sqrt(Math.max(0, radius ** 2 - (y + 0.5 - below) ** 2));
    where.fill(1, y * SIZE.width + clampColumn(left - half), y * SIZE.width + clampColumn(left + half));
  }
}

function clampColumn(x: number): number {
  return Math.min(SIZE.width, Math.max(0, Math.round(x)));
}

/** Positions of particles before and after the latest step. */
function particlePaths({ simulator }: SceneLab): [before: Vector3[], now: Vector3[]] {
  const { x, y, z, px, py, pz } = readParticles(simulator);
  const placesOf = (xs: Float32Array, ys: Float32Array, zs: Float32Array) =>
    Array.from(xs, (_, i) => new Vector3(xs[i], ys[i], zs[i]));
  return [placesOf(px, py, pz), placesOf(x, y, z)];
}

/** The corners of the surfaces of a scene, static and moving. */
function surfaceCorners(lab: SceneLab): Vector3[] {
  return lab
    .surfaceBoxes()
    .flatMap(({ min, max }) =>
      Array.from(
        { length: 8 },
        (_, corner) => new Vector3(...[0, 1, 2].map((axis) => ((corner >> axis) & 1 ? max : min).getComponent(axis))),
      ),
    );
}

/** Largest distance between two positions of the same visible point on the screen, pixels. */
function longestWay(before: Vector3[], now: Vector3[], camera: PerspectiveCamera): number {
  const half = new Vector3(SIZE.width / 2, SIZE.height / 2, 0);
  const ways = now.map((place, i) => {
    const [from, to] = [before[i], place].map((one) => one.clone().project(camera));
    const isSeen = Math.abs(to.x) < BESIDE && Math.abs(to.y) < BESIDE && Math.abs(to.z) < 1;
    return isSeen ? to.sub(from).setZ(0).multiply(half).length() : 0;
  });
  return Math.max(0, ...ways);
}
