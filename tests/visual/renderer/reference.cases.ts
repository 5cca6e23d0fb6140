/** Frames that the GPU draws, and their descriptions for the reference renderer. */
import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import type { PuffForm } from '../../../src/renderer/gpu/puffTextures.ts';
import { ballMesh } from '../../../src/scenes/models/ball.ts';
import { ALL_PARTICLES } from '../../../src/simulator/view.ts';
import { presetValues } from '../../../src/parameters/presets.ts';
import { drawPuff } from '../../../src/renderer/puffs/drawing/drawPuff.ts';
import { readPuffSheet } from '../../../src/renderer/puffs/sheet/readPuffSheet.ts';
import { writePuffSheet } from '../../../src/renderer/puffs/sheet/writePuffSheet.ts';
import { fitPuff } from '../../../src/renderer/puffs/fit/fitPuff.ts';
import type { PuffShape } from '../../../src/renderer/puffs/shapes.ts';
import { fetchExtras } from '../../../src/renderer/extraPasses.ts';
import { withLooks } from '../../../src/renderer/looks.ts';
import type { Style } from '../../../src/renderer/style.ts';
import { NO_STYLE, numberOfStyle } from '../../../src/simulator/lookStyles.ts';
import type { Drawn } from '../../support/reference.ts';
import { describe, type Shaped, type Shown } from '../description.ts';
import { inputOf, Lab, PLAIN_STYLE, type LabPuff, type LabScene } from '../lab.ts';
import { face, heart, popcorn, torus } from '../puffMeshes.ts';
import { random } from '../random.ts';
import { SceneLab } from '../sceneLab.ts';
import { box, ground } from '../solids.ts';

await fetchExtras({ ...PLAIN_STYLE, hasLooks: true });

const [WIDTH, HEIGHT] = [320, 240];
const BACKDROP = { top: [43, 45, 92], bottom: [214, 110, 122] } as const;

export type SceneName = keyof typeof SCENES;
export type Mode = Partial<Style>;

/** One scene in several modes. */
export async function drawn(scene: SceneName, modes: readonly Mode[], reversedDepth = false): Promise<Drawn[]> {
  const { input, surfaces, backdrop, shapes }: Shown = await SCENES[scene]();
  const size = { width: WIDTH, height: HEIGHT };
  const lab = new Lab({ ...size, puffs: [], capacity: CAPACITY, surfaces, backdrop, shapes, reversedDepth });
  const pictures = modes.map((mode) => {
    const shown = { input: { ...input, style: { ...input.style, ...mode } }, surfaces, backdrop, shapes };
    const { pixels, counts } = lab.drawFrame(shown.input, { readCounts: true });
    const description = describe(shown);
    return { description, pixels: base64(pixels), counts: base64(counts) };
  });
  lab.dispose();
  return pictures;
}

const CAPACITY = 1000;
const SUN = { towardsLight: [-0.5, 0.8, 0.4] } as const;

const SCENES = {
  perspective: () => cluster(looking(perspective(), [0.5, 1.3, 4.6], [0, -0.1, 0]), SUN),
  offAxis: () => cluster(looking(offAxis(), [0.5, 1.6, 3.4], [0, -0.2, 0]), SUN),
  looks: () => withLooksOf(cluster(looking(perspective(), [0.5, 1.3, 4.6], [0, -0.1, 0]), SUN, 0, look)),
  deformed: () => cluster(looking(perspective(), [0.5, 1.3, 4.6], [0, -0.1, 0]), SUN, 0, deformation),
  deformedByLamp: () =>
    cluster(looking(perspective(), [0.5, 1.6, 5], [0, -0.1, 0]), { lamp: [-0.6, 1.5, 0.5] }, 0, deformation),
  eyeInsideDeformed: () =>
    cluster(looking(perspective(), [0.1, -0.1, 0.5], [0, -0.4, -0.8]), { towardsLight: [0.1, 1, 0.1] }, 0, deformation),
  eroded: () => cluster(looking(perspective(), [0.5, 1.3, 4.6], [0, -0.1, 0]), SUN, 0, erosion),
  erodedByLamp: () =>
    cluster(
      looking(perspective(), [0.5, 1.6, 5], [0, -0.1, 0]),
      { lamp: [-0.6, 1.5, 0.5], falloff: { decay: 1.5, scale: 1.2 } },
      0,
      erosion,
    ),
  erodedAndDeformed: () =>
    cluster(looking(perspective(), [0.5, 1.3, 4.6], [0, -0.1, 0]), SUN, 0, (next) => ({
      ...deformation(next),
      ...erosion(next),
    })),
  orthographic: () => cluster(looking(orthographic(), [2, 2.5, 5], [0, -0.2, 0]), SUN),
  eyeInside: () => cluster(looking(perspective(), [0.1, -0.1, 0.5], [0, -0.4, -0.8]), { towardsLight: [0.1, 1, 0.1] }),
  backlit: () => cluster(looking(perspective(), [0, 0.6, 4.5], [0, -0.2, 0]), { towardsLight: [0.1, 0.35, -1] }),
  touching: () => cluster(looking(perspective(), [0.4, 0.4, 3.6], [0, -0.7, 0]), SUN, -0.6),
  byLamp: () =>
    cluster(looking(perspective(), [0.5, 1.6, 5], [0, -0.1, 0]), { lamp: [-0.6, 1.5, 0.5], falloff: { decay: 2 } }),
  byLampAmongPuffs: () => cluster(looking(orthographic(), [2, 2.5, 5], [0, -0.2, 0]), { lamp: [0.3, 0.1, -0.2] }),
  lampAmongPuffs: () =>
    cluster(looking(perspective(), [0.1, -0.55, 1.2], [0, -0.9, -0.5]), { lamp: [0.3, 0.55, -0.2] }),
  besideEye: () => beside(looking(perspective(), [0, -0.2, 0.6], [0, -0.4, 0])),
  meshes: async () => shaped(await meshShapes()),
  meshesByLamp: async () => shaped(await meshShapes(), true),
  drawings: () => shaped(drawnShapes()),
  drawingsByLamp: () => shaped(drawnShapes(), true),
  sheet: async () => shaped(await readPuffSheet(await writePuffSheet(await meshShapes()))),
  coincident: () => coincident(looking(perspective(), [0.5, 1.6, 5], [0, -0.4, 0])),
  underParts: () => underParts(looking(perspective(), [0.5, 1.6, 5], [0, -0.4, 0])),
  lampRising: () => lampAfter(90),
  lampFull: () => lampAfter(240),
  eyeInPlume: () => lampAfter(240, true),
} satisfies Record<string, () => Shown | Promise<Shown>>;

function perspective(): PerspectiveCamera {
  return new PerspectiveCamera(45, WIDTH / HEIGHT, 0.1, 100);
}

function offAxis(): PerspectiveCamera {
  const camera = perspective();
  camera.setViewOffset(2 * WIDTH, 2 * HEIGHT, 0.6 * WIDTH, 0.7 * HEIGHT, WIDTH, HEIGHT);
  return camera;
}

function orthographic(): OrthographicCamera {
  return new OrthographicCamera(-2, 2, 1.5, -1.5, 0.1, 100);
}

function looking(camera: Camera, from: [number, number, number], at: [number, number, number]): Camera {
  camera.position.set(...from);
  camera.lookAt(...at);
  camera.updateMatrixWorld();
  return camera;
}

/**
 * Puffs with all tints, ages and variations above a ground, `raised` metres higher, with a ball and a box among them.
 */
function cluster(
  camera: Camera,
  light: Pick<LabScene, 'towardsLight' | 'lamp' | 'falloff'>,
  raised = 0,
  change: (next: () => number) => Partial<LabPuff> = () => ({}),
): Shown {
  const next = random(77);
  const puffs = Array.from({ length: 40 }, (_, index) => ({
    place: [next() * 2 - 1, next() * 1.3 - 0.7 + raised, next() * 2 - 1] as const,
    radius: 0.12 + 0.22 * next(),
    roll: next() * 2 * Math.PI,
    variation: index % 4,
    seed: Math.floor(next() * 256),
    tint: index % 5,
    age: next(),
    temperature: (index % 7) / 6,
    ...change(next),
  }));
  const surfaces = [ground(-1, 3), ball([-1.1, -0.5, 0.5], 0.35), cube([0.92, -0.6, 0.6], [0.25, 0.4, 0.2])];
  const input = inputOf({ width: WIDTH, height: HEIGHT, puffs, surfaces, camera, ...light });
  return { input, surfaces, backdrop: BACKDROP };
}

/** The cluster of puffs of these shapes, in the sun or by a lamp behind it. */
function shaped(shapes: readonly PuffShape[], byLamp = false): Shown {
  const [height, light] = byLamp ? [1.6, { lamp: [-0.6, 1.5, -0.9] as const }] : [1.3, SUN];
  return { ...cluster(looking(perspective(), [0.5, height, byLamp ? 5 : 4.6], [0, -0.1, 0]), light), shapes };
}

/** A heart with a dark belly, popcorn, a painted face and a torus. */
function meshShapes(): Promise<PuffShape[]> {
  const { positions, indices } = heart();
  const colors = Array.from(
    positions,
    (_, at) => 1 - (0.6 - 0.2 * (at % 3)) * Math.max(0, -positions[at - (at % 3) + 1]),
  );
  const meshes = [{ positions, indices, colors }, popcorn(), face(), torus()];
  return Promise.all(meshes.map(async (mesh) => (await fitPuff(mesh, { lobes: 8 })).shape));
}

/** A heart, a leaf with folds, popcorn and a woodcut cloud. */
function drawnShapes(): PuffShape[] {
  const presets = ['wisp-hearts', 'air-leaves', 'campfire-popcorn', 'cloudscape-woodcut'] as const;
  return presets.map((name) => drawPuff(presetValues(name)['puff.drawing']!));
}

/** Any turn, and any stretch up to a ratio of 3. */
function deformation(next: () => number): Pick<LabPuff, 'deformation'> {
  const bits = (max: number): number => Math.floor(next() * max);
  // The highest bit is flipped, and each component is at most 300 / 720.
  const component = (): number => (212 + bits(600)) ^ 512;
  const [quaternionX, quaternionY, quaternionZ] = [component(), component(), component()];
  const rotation = { quaternionX, quaternionY, quaternionZ, quaternionLargest: bits(4) };
  return { deformation: { ...rotation, stretchU: bits(255), stretchV: bits(255), stretch: bits(170) } };
}

/** Three looks and smoke without one. */
function look(next: () => number): Pick<LabPuff, 'look' | 'tint'> {
  return { look: Math.floor(4 * next()), tint: 0 };
}

/** Three looks with a ramp of two to four tones each. */
function withLooksOf(shown: Shown): Shown {
  const { style } = shown.input;
  const colors = ['0:301050,.3:9040a0,.6:ffd0f0', '0:104020,.55:50d070', '0:402000,.2:a05010,.5:f0a030,.8:fff0a0'];
  const numbers = new Float64Array(45);
  colors.forEach((ramp, index) => numbers.set([numberOfStyle({ ...NO_STYLE, colors: ramp })], 3 * index));
  const looks = withLooks(style, {}, { lookStyles: () => numbers }, style);
  return { ...shown, input: { ...shown.input, style: looks } };
}

/** Whole puffs and puffs with one to three bites. */
function erosion(next: () => number): Pick<LabPuff, 'erosion'> {
  return { erosion: Math.max(0, 1.2 * next() - 0.2) };
}

/** Shadows of puffs beside and behind the eye, most of them close to the near plane. */
function beside(camera: Camera): Shown {
  const next = random(5);
  const casters = Array.from({ length: 30 }, (_, index) => {
    const z = index % 3 ? 0.1 * (next() - 0.7) : next();
    const place = new Vector3(0.4 + 0.8 * next(), 0.5 * next() - 0.2, z).applyMatrix4(camera.matrixWorld);
    const rotation = { roll: next() * 2 * Math.PI, variation: index % 4, seed: Math.floor(next() * 256) };
    return { place: place.toArray(), radius: 0.05 + 0.1 * next(), ...rotation };
  });
  return shadowsOnly(camera, casters, [0.6, 0.5, 0.6]);
}

/** More coincident puffs than a stencil can count. */
function coincident(camera: Camera): Shown {
  const one = { place: [0, 0, 0], radius: 0.5 } as const;
  return shadowsOnly(
    camera,
    Array.from({ length: 512 }, () => one),
    SUN.towardsLight,
  );
}

/** Two parts of a model, one in the other's shadow, and puffs beside and above it. */
function underParts(camera: Camera): Shown {
  const casters = [-0.5, -0.1, 0.4].map((x, variation) => ({ place: [x, 0.3, 0.2] as const, radius: 0.35, variation }));
  const parts = [-0.2, 0.2].map((y) => cube([0.6, y, 0.2], [0.4, 0.05, 0.3]));
  return shadowsOnly(camera, casters, SUN.towardsLight, parts);
}

function shadowsOnly(
  camera: Camera,
  casters: LabPuff[],
  towardsLight: LabScene['towardsLight'],
  solids = [cube([0.7, -0.7, 0.2], [0.25, 0.3, 0.2])],
): Shown {
  const surfaces = [ground(-1, 3), ...solids];
  const input = inputOf({ width: WIDTH, height: HEIGHT, puffs: [], casters, surfaces, camera, towardsLight });
  return { input, surfaces, backdrop: BACKDROP };
}

function ball(center: [number, number, number], radius: number): Shaped {
  const mesh = ballMesh(radius, 60);
  mesh.positions.forEach((value, index) => (mesh.positions[index] = value + center[index % 3]));
  const solid = { type: 'ball', center, radius } as const;
  return { name: 'ball', mesh, color: [64, 190, 178], casts: true, inked: false, solid };
}

function cube(center: [number, number, number], half: [number, number, number]): Shaped {
  const solid = { type: 'box', center, half } as const;
  return { name: 'box', mesh: box(center, half), color: [219, 64, 92], casts: true, inked: false, solid };
}

/**
 * A preset after a simulated time, drawn without the edge filter, and its number of bodies and casters. Its puffs are the
 * built-in ones. The reference has no lamps at smoke that glows: the picture is drawn without them.
 */
export async function drawnPreset(
  preset: string,
  form: PuffForm,
  seconds: number,
): Promise<Drawn & { bodies: number; casters: number }> {
  const lab = await SceneLab.create(preset, {
    width: WIDTH,
    height: HEIGHT,
    values: { 'puff.form': form, 'puff.drawing': '' },
  });
  lab.step(60 * seconds);
  // The bounds are those of the previous frame.
  lab.draw();
  const { pixels, counts } = lab.draw({ cull: false, readCounts: true, hasLamps: false });
  const { bodiesDrawn, castersDrawn } = lab.report!;
  const description = describe({ ...lab.scene, input: lab.frame({ cull: false }) });
  lab.dispose();
  return { description, pixels: base64(pixels), counts: base64(counts), bodies: bodiesDrawn, casters: castersDrawn };
}

/** The lamp with its camera and light, and its surfaces as triangles, after some steps of the real simulator. */
async function lampAfter(steps: number, isInPlume = false): Promise<Shown> {
  const lab = await SceneLab.create('lamp', { width: WIDTH, height: HEIGHT });
  lab.step(steps);
  const { min, max } = lab.simulator.arrange({ ...ALL_PARTICLES, blend: 1 }).bounds;
  const target = new Vector3(...min).lerp(new Vector3(...max), 0.5).toArray();
  const camera = isInPlume ? lab.camera({ target, distance: 0.3 }) : lab.camera();
  // A culled frame has no shadows of covered particles, but the reference counts all of them. culling.ts compares
  // culled and unculled pictures.
  return { ...lab.scene, input: lab.frame({ camera, cull: false }) };
}

function base64(bytes: Uint8Array): string {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}
