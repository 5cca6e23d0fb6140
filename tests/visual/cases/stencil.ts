/**
 * The stencil count against a CPU reference: each pixel of a ground plane asks how many volumes hold its point. The
 * reference shares nothing with the shaders but the definition of a volume.
 */
import { type Camera, OrthographicCamera, PerspectiveCamera, type Ray, Raycaster, Vector2, Vector3 } from 'three';
import type { PuffForm } from '../../../src/device/puffTextures.ts';
import type { SurfaceDescription } from '../../../src/passes/surfaces.ts';
import { takePicture, type LabPuff, type LabScene } from '../lab.ts';
import { box, ground } from '../solids.ts';
import { random } from '../random.ts';
import { holds, towardsLightOf, volumeOf, type View } from '../shadowVolume.ts';

export interface StencilReport {
  receiver: number;
  differing: number;
  wronglyLit: number;
  deepest: number;
}

export const [WIDTH, HEIGHT] = [320, 240];
export const GROUND_Y = -1;
export const GROUND_HALF = 3;

export function lightOf({ towardsLight, lamp, reversedDepth }: View): Partial<LabScene> {
  return { towardsLight: towardsLight?.toArray(), lamp: lamp?.toArray(), reversedDepth };
}

function looking(camera: Camera, from: [number, number, number], at: [number, number, number]): Camera {
  camera.position.set(...from);
  camera.lookAt(...at);
  camera.updateMatrixWorld();
  return camera;
}

function perspective(): PerspectiveCamera {
  return new PerspectiveCamera(45, WIDTH / HEIGHT, 0.1, 100);
}

function offAxis(): PerspectiveCamera {
  const camera = perspective();
  camera.setViewOffset(2 * WIDTH, 2 * HEIGHT, 0.6 * WIDTH, 0.7 * HEIGHT, WIDTH, HEIGHT);
  return camera;
}

function orthographic(): OrthographicCamera {
  return new OrthographicCamera(-3, 3, 2.25, -2.25, 0.1, 100);
}

export const VIEWS: Record<string, () => View> = {
  ordinary: () => ({
    camera: looking(perspective(), [0.5, 1.6, 5], [0, -0.4, 0]),
    towardsLight: new Vector3(-0.5, 0.8, 0.4),
  }),
  offAxis: () => ({
    camera: looking(offAxis(), [0.5, 1.6, 3.4], [0, -0.4, 0]),
    towardsLight: new Vector3(-0.5, 0.8, 0.4),
  }),
  eyeInside: () => ({
    camera: looking(perspective(), [0.1, -0.55, 1.2], [0, -0.9, -0.5]),
    towardsLight: new Vector3(0.1, 1, 0.1),
  }),
  backlit: () => ({
    camera: looking(perspective(), [0, 0.6, 4.5], [0, -0.6, 0]),
    towardsLight: new Vector3(0, 0.35, -1),
  }),
  orthographic: () => ({
    camera: looking(orthographic(), [2, 2.5, 5], [0, -0.4, 0]),
    towardsLight: new Vector3(-0.5, 0.8, 0.4),
  }),
  reversedDepth: () => ({
    camera: looking(perspective(), [0.5, 1.6, 5], [0, -0.4, 0]),
    towardsLight: new Vector3(-0.5, 0.8, 0.4),
    reversedDepth: true,
  }),
  reversedDepthOrthographic: () => ({
    camera: looking(orthographic(), [2, 2.5, 5], [0, -0.4, 0]),
    towardsLight: new Vector3(-0.5, 0.8, 0.4),
    reversedDepth: true,
  }),
  lamp: () => ({
    camera: looking(perspective(), [0.5, 1.6, 5], [0, -0.4, 0]),
    lamp: new Vector3(-0.6, 1.5, 0.5),
  }),
  lampAmongPuffs: () => ({
    camera: looking(perspective(), [0.1, -0.55, 1.2], [0, -0.9, -0.5]),
    lamp: new Vector3(0.3, 0.55, -0.2),
  }),
  lampOrthographic: () => ({
    camera: looking(orthographic(), [2, 2.5, 5], [0, -0.4, 0]),
    lamp: new Vector3(0.8, 0.9, 0.9),
  }),
};

/** Counts for a view of a seeded cluster of casters, optionally with a box-shaped mesh among them. */
export function compare(form: PuffForm, viewName: string, withMesh: boolean): StencilReport {
  const view = VIEWS[viewName]();
  const casters = cluster(viewName === 'eyeInside' ? 60 : 45);
  const mesh = box([0.7, -0.2, 0.2], [0.25, 0.3, 0.2]);
  const surfaces: SurfaceDescription[] = [ground(GROUND_Y, GROUND_HALF)];
  if (withMesh) surfaces.push({ name: 'box', mesh, color: [200, 60, 60], casts: true, inked: false });
  const { counts } = takePicture({
    width: WIDTH,
    height: HEIGHT,
    puffs: [],
    casters,
    surfaces,
    camera: view.camera,
    ...lightOf(view),
    style: { form },
    readCounts: true,
  });
  return report(form, view, casters, withMesh, counts);
}

/** `count` casters on one place: how many pixels of their common shadow came out lit. */
export function coincident(count: number): { shadowed: number; lit: number } {
  const view = VIEWS.ordinary();
  const one: LabPuff = { place: [0, 0, 0], radius: 0.5 };
  const draw = (casters: LabPuff[]) =>
    takePicture({
      width: WIDTH,
      height: HEIGHT,
      puffs: [],
      casters,
      surfaces: [ground(GROUND_Y, GROUND_HALF)],
      camera: view.camera,
      ...lightOf(view),
      readCounts: true,
    }).counts;
  const single = draw([one]);
  const many = draw(Array.from({ length: count }, () => one));
  const shadowed = single.filter((value) => value > 0).length;
  return { shadowed, lit: single.filter((value, pixel) => value > 0 && many[pixel] === 0).length };
}

/** Seeded casters over the ground. */
export function cluster(count: number): LabPuff[] {
  const next = random(77);
  return Array.from({ length: count }, () => ({
    place: [next() * 2 - 1, next() * 1.2 - 0.5, next() * 2 - 1],
    radius: 0.12 + 0.25 * next(),
    roll: next() * 2 * Math.PI,
    variation: Math.floor(next() * 4),
    seed: Math.floor(next() * 256),
  }));
}

function report(
  form: PuffForm,
  view: View,
  casters: readonly LabPuff[],
  withMesh: boolean,
  counts: Uint8Array,
): StencilReport {
  const volumes = casters.map((caster) => volumeOf(form, caster, view));
  const result: StencilReport = { receiver: 0, differing: 0, wronglyLit: 0, deepest: 0 };
  for (let pixel = 0; pixel < WIDTH * HEIGHT; ++pixel) {
    const ray = viewRay(pixel, view.camera);
    const point = groundPoint(ray, withMesh);
    if (!point) continue;
    const inMesh = withMesh && liesInBoxShadow(point, view);
    const expected = volumes.filter((volume) => holds(volume, ray, point)).length + (inMesh ? 1 : 0);
    result.receiver += 1;
    result.deepest = Math.max(result.deepest, expected);
    if (counts[pixel] !== expected) result.differing += 1;
    if (counts[pixel] > 0 !== expected > 0) result.wronglyLit += 1;
  }
  return result;
}

/** Whether the box of `compare` stands between a point and the light. */
function liesInBoxShadow(point: Vector3, view: View): boolean {
  return boxHides(point, towardsLightOf(view, point), view.lamp?.distanceTo(point));
}

export function viewRay(pixel: number, camera: Camera): Ray {
  const at = new Vector2(
    (((pixel % WIDTH) + 0.5) / WIDTH) * 2 - 1,
    ((Math.floor(pixel / WIDTH) + 0.5) / HEIGHT) * 2 - 1,
  );
  const caster = new Raycaster();
  caster.setFromCamera(at, camera);
  return caster.ray;
}

export function groundPoint({ origin, direction }: Ray, withMesh: boolean): Vector3 | undefined {
  const distance = (GROUND_Y - origin.y) / direction.y;
  if (!(distance > 0)) return undefined;
  const point = origin.clone().addScaledVector(direction, distance);
  if (Math.abs(point.x) > GROUND_HALF || Math.abs(point.z) > GROUND_HALF) return undefined;
  return withMesh && boxHides(point, direction.clone().negate()) ? undefined : point;
}

/** Whether the ray from a point in a direction meets the box of `compare` within a distance. */
function boxHides(point: Vector3, direction: Vector3, distance = Infinity): boolean {
  const [centre, half] = [
    [0.7, -0.2, 0.2],
    [0.25, 0.3, 0.2],
  ];
  let [enter, leave] = [0, distance];
  (['x', 'y', 'z'] as const).forEach((axis, index) => {
    const ends = [-1, 1].map((side) => (centre[index] + side * half[index] - point[axis]) / direction[axis]);
    enter = Math.max(enter, Math.min(...ends));
    leave = Math.min(leave, Math.max(...ends));
  });
  return enter < leave;
}
