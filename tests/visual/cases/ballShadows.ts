/** Shadows of puffs of one lobe on a ground: those of balls, which are known exactly. */
import { OrthographicCamera, PerspectiveCamera, Raycaster, Vector2, Vector3, type Camera, type Ray } from 'three';
import type { PuffShape } from '../../../src/puffs/shapes.ts';
import { takePicture, type LabPuff, type LabScene } from '../lab.ts';
import { random } from '../random.ts';
import { ground } from '../solids.ts';

const [WIDTH, HEIGHT] = [320, 240];
const GROUND_Y = -1;
const GROUND_HALF = 3;
const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];

type Triple = readonly [number, number, number];
type View = { camera: Camera; casters: readonly LabPuff[] } & Pick<LabScene, 'towardsLight' | 'lamp'>;

export interface BallReport {
  /** Pixels of the ground, and those whose count is not that of the balls before the light. */
  receiver: number;
  differing: number;
  /** The most balls before the light of one pixel. */
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

/** Seeded casters over the ground. */
function cluster(): LabPuff[] {
  const next = random(77);
  return Array.from({ length: 12 }, () => ({
    place: [next() * 2 - 1, next() * 1.2 - 0.5, next() * 2 - 1],
    radius: 0.12 + 0.25 * next(),
  }));
}

/** All casters beside the eye and behind it, most of them hardly before or behind the near plane, and the sun too. */
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

/** Whether a ball stands between a point and the light. */
function hides({ place, radius }: LabPuff, point: Vector3, { lamp, towardsLight }: View): boolean {
  const towards = lamp ? new Vector3(...lamp).sub(point) : new Vector3(...towardsLight!);
  const offset = new Vector3(...place).sub(point);
  const along = offset.dot(towards.normalize());
  return along > 0 && offset.addScaledVector(towards, -along).length() <= radius;
}
