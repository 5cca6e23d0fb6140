/** Shadows of boxes and of single-lobe puffs (balls) on a ground, compared with analytic results. */
import {
  Box3,
  Matrix4,
  OrthographicCamera,
  PerspectiveCamera,
  Ray,
  Raycaster,
  Vector2,
  Vector3,
  type Camera,
} from 'three';
import type { Color } from '../../../../../src/renderer/gpu/ramps.ts';
import type { SurfaceDescription } from '../../../../../src/renderer/passes/surface.ts';
import type { PuffShape } from '../../../../../src/renderer/puffs/shapes.ts';
import { Lab, takePicture, type LabPicture, type LabPuff, type LabScene } from '../../../lab.ts';
import { random } from '../../../random.ts';
import { box, ground } from '../../../solids.ts';

const [WIDTH, HEIGHT] = [320, 240];
const GROUND_Y = -1;
const GROUND_HALF = 3;
const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];

type Triple = readonly [number, number, number];
type View = { camera: Camera; casters: readonly LabPuff[] } & Pick<LabScene, 'towardsLight' | 'lamp'>;

export interface BallReport {
  /** Ground pixels, and those whose stencil count differs from the number of balls between pixel and light. */
  receiver: number;
  differing: number;
  /** Largest number of balls between one pixel and the light. */
  deepest: number;
}

export const VIEWS = {
  ordinary: () => ({ camera: from([0.5, 1.6, 5]), towardsLight: [-0.5, 0.8, 0.4], casters: cluster() }),
  backlit: () => ({ camera: from([0, 0.6, 4.5], [0, -0.6, 0]), towardsLight: [0, 0.35, -1], casters: cluster() }),
  besideEye: () => besideEye(from([0, -0.2, 0.6])),
  lamp: () => ({ camera: from([0.5, 1.6, 5]), lamp: [-0.6, 1.5, 0.5], casters: cluster() }),
  lampOrthographic: () => ({ camera: orthographic([2, 2.5, 5]), lamp: [0.8, 0.9, 0.9], casters: cluster() }),
} satisfies Record<string, () => View>;

export function compare(name: keyof typeof VIEWS): BallReport {
  const view: View = VIEWS[name]();
  const surfaces = [ground(GROUND_Y, GROUND_HALF)];
  const scene = { width: WIDTH, height: HEIGHT, puffs: [], shapes: BALL, surfaces, readCounts: true };
  const { counts } = takePicture({ ...scene, ...view });
  const report = { receiver: 0, differing: 0, deepest: 0 };
  counts.forEach((count, pixel) => {
    const point = groundPoint(viewRay(pixel, view.camera));
    if (!point) return;
    const expected = view.casters.filter((ball) => hides(ball, point, view)).length;
    report.receiver += 1;
    report.deepest = Math.max(report.deepest, expected);
    if (count !== expected) report.differing += 1;
  });
  return report;
}

/** A box and its world transform. */
interface Crate {
  half: Triple;
  worldFromModel: Matrix4;
}

/** How the ground pixels match their expected shadow steps. */
export interface StepsReport {
  /** Pixels in the first shadow step cast by a model of overlapping boxes, and pixels in the second step. */
  underModel: number;
  deep: number;
  wrongColors: number;
  wrongCounts: number;
}

/** Two balls and a multi-part model above the ground with two shadow steps. All parts together count as one caster. */
export function stepsUnderParts(): StepsReport {
  const view: View = { camera: from([0.5, 2.6, 5]), towardsLight: [-0.3, 0.8, 0.4], casters: OVERLAPPING };
  const floor = ground(GROUND_Y, GROUND_HALF);
  const surfaces = [floor, ...MODEL.map(({ half }, part) => crateOf(half, part))];
  const parts = MODEL.map(({ worldFromModel }) => worldFromModel);
  const style = { shadowSteps: 2, shadowDepth: 2, deepShadow: [128, 64, 255] } as const;
  const scene = { ...view, width: WIDTH, height: HEIGHT, puffs: [], shapes: BALL, surfaces, parts, readCounts: true };
  const lab = new Lab(scene);
  const [lit, dark, steps] = [{ shadows: false }, {}, style].map((shadow) => lab.draw({ ...scene, style: shadow }));
  lab.dispose();
  const report = { underModel: 0, deep: 0, wrongColors: 0, wrongCounts: 0 };
  for (let pixel = 0; pixel < WIDTH * HEIGHT; ++pixel) {
    const point = groundPoint(viewRay(pixel, view.camera));
    if (!point || !isOf(lit, pixel, floor.color)) continue;
    const isUnderModel = MODEL.some((crate) => hidesAsBox(crate, point, view));
    const count = view.casters.filter((ball) => hides(ball, point, view)).length + Number(isUnderModel);
    if (isUnderModel && count === 1) report.underModel += 1;
    if (count > 1) report.deep += 1;
    if (steps.counts[pixel] !== count) report.wrongCounts += 1;
    const shown = count > 0 ? dark : lit;
    const factor = count > 1 ? style.deepShadow : [255, 255, 255];
    const expected = factor.map((share, channel) => (shown.pixels[4 * pixel + channel] * share) / 255);
    const isRight = expected.every((value, channel) => Math.abs(steps.pixels[4 * pixel + channel] - value) <= 1);
    if (!isRight) report.wrongColors += 1;
  }
  return report;
}

/** Overlapping boxes. */
const MODEL: readonly Crate[] = [0, 1, 2, 3].map((part) => ({
  half: [0.4, 0.2 - 0.03 * part, 0.25],
  worldFromModel: new Matrix4().setPosition(0.3 + 0.2 * part, -0.6 + 0.25 * part, 0.1 * part),
}));

/** One ball shades the shadow of the other ball and of the model. */
const OVERLAPPING: readonly LabPuff[] = [
  { place: [-0.6, -0.3, 0.3], radius: 0.4 },
  { place: [-0.1, -0.1, 0.2], radius: 0.4 },
];

function crateOf(half: Triple, part?: number): SurfaceDescription {
  return { name: 'crate', mesh: box([0, 0, 0], half), color: [219, 64, 92], casts: true, inked: false, part };
}

function isOf({ pixels }: LabPicture, pixel: number, color: Color): boolean {
  return color.every((value, channel) => pixels[4 * pixel + channel] === value);
}

function from(place: Triple, at: Triple = [0, -0.4, 0]): Camera {
  return looking(new PerspectiveCamera(45, WIDTH / HEIGHT, 0.1, 100), place, at);
}

function orthographic(place: Triple): Camera {
  return looking(new OrthographicCamera(-3, 3, 2.25, -2.25, 0.1, 100), place, [0, -0.4, 0]);
}

function looking(camera: Camera, place: Triple, at: Triple): Camera {
  camera.position.set(...place);
  camera.lookAt(...at);
  camera.updateMatrixWorld();
  return camera;
}

/** Seeded casters above the ground. */
function cluster(): LabPuff[] {
  const next = random(77);
  return Array.from({ length: 12 }, () => ({
    place: [next() * 2 - 1, next() * 1.2 - 0.5, next() * 2 - 1],
    radius: 0.12 + 0.25 * next(),
  }));
}

/** All casters are beside or behind the eye, most of them close to the near plane. The sun is behind the eye, too. */
function besideEye(camera: Camera): View {
  const next = random(5);
  const casters = Array.from({ length: 24 }, (_, index): LabPuff => {
    const z = index % 3 ? 0.1 * (next() - 0.7) : next();
    const place = new Vector3(0.4 + 0.8 * next(), 0.5 * next() - 0.2, z).applyMatrix4(camera.matrixWorld);
    return { place: place.toArray(), radius: 0.05 + 0.1 * next() };
  });
  return { camera, casters, towardsLight: [0.6, 0.5, 0.6] };
}

function viewRay(pixel: number, camera: Camera): Ray {
  const [x, y] = [pixel % WIDTH, Math.floor(pixel / WIDTH)];
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2((2 * x + 1) / WIDTH - 1, (2 * y + 1) / HEIGHT - 1), camera);
  return caster.ray;
}

function groundPoint({ origin, direction }: Ray): Vector3 | undefined {
  const distance = (GROUND_Y - origin.y) / direction.y;
  if (!(distance > 0)) return undefined;
  const point = origin.clone().addScaledVector(direction, distance);
  return Math.max(Math.abs(point.x), Math.abs(point.z)) > GROUND_HALF ? undefined : point;
}

/** Unit vector from a point to the light. */
function towardsLightFrom(point: Vector3, { lamp, towardsLight }: View): Vector3 {
  return (lamp ? new Vector3(...lamp).sub(point) : new Vector3(...towardsLight!)).normalize();
}

/** Whether a box intersects the ray from a point towards the light. The light is beyond all boxes. */
function hidesAsBox({ half, worldFromModel }: Crate, point: Vector3, view: View): boolean {
  const ray = new Ray(point.clone(), towardsLightFrom(point, view)).applyMatrix4(worldFromModel.clone().invert());
  const corner = new Vector3(...half);
  return ray.intersectsBox(new Box3(corner.clone().negate(), corner));
}

/** Whether a ball is between a point and the light. */
function hides({ place, radius }: LabPuff, point: Vector3, view: View): boolean {
  const towards = towardsLightFrom(point, view);
  const offset = new Vector3(...place).sub(point);
  const along = offset.dot(towards);
  return along > 0 && offset.addScaledVector(towards, -along).length() <= radius;
}
