/** Shadows of billboards of cards on a wall, compared with the silhouettes of their layers. */
import { Matrix4, PerspectiveCamera, Plane, Quaternion, Raycaster, Vector2, Vector3, type Camera } from 'three';
import { finished } from '../../../../../src/base/work.ts';
import { bakingPuffs } from '../../../../../src/renderer/bakedPuffs.ts';
import { samplePuff, type PuffLayers } from '../../../../../src/renderer/puffs/billboards/layers.ts';
import { fitPuff } from '../../../../../src/renderer/puffs/fit/fitPuff.ts';
import type { PuffShape } from '../../../../../src/renderer/puffs/shapes.ts';
import type { Style } from '../../../../../src/renderer/style.ts';
import { Lab, type LabPuff, type LabScene } from '../../../lab.ts';
import { CARDS } from '../../../puffMeshes.ts';
import { random } from '../../../random.ts';
import { box } from '../../../solids.ts';

const [WIDTH, HEIGHT] = [320, 240];
const FIELD_OF_VIEW = 30;
/** Half of the sides of the wall, metres. */
const HALF = [30, 30, 0.01] as const;
/** The least cosine between the wall and the direction of the light, and between the wall and the view. */
const LEAST_COSINE = 0.5;
/** The least cosine between the light and the direction towards the eye: a picture has no shortest turn to its back. */
const LEAST_FRONT = -0.995;

export type Name = keyof typeof CARDS;

/** A puff, a light and a camera in front of a wall on which the shadow is. */
interface Trial extends Pick<LabScene, 'towardsLight' | 'lamp'> {
  readonly puff: LabPuff & { readonly roll: number; readonly variation: number };
  readonly camera: Camera;
  readonly worldFromWall: Matrix4;
  readonly wall: Plane;
}

export interface ShadowReport {
  /** Pixels in the expected shadows, and those where shadow and expectation differ, in all pictures and in the worst one. */
  expected: number;
  differing: number;
  /** The greatest share of differing pixels in a picture. */
  worst: number;
  /** Number of pictures with a light from the back of the billboard, and of layers. */
  backlit: number;
  layers: number;
}

/** Each picture has one puff with a random place, roll and layer, and a random light. */
export async function compareShadows(
  names: readonly Name[],
  light: 'sun' | 'lamp',
  trials: number,
  { sides = 1, style = {} }: { sides?: number; style?: Partial<Style> } = {},
): Promise<ShadowReport> {
  const next = random(38);
  const shapes = await shapesOf(names);
  const { layers } = finished(bakingPuffs(shapes, { sides })).billboards;
  const surfaces = [
    { name: 'wall', mesh: box([0, 0, 0], HALF), color: [222, 170, 110], casts: false, inked: false, part: 0 },
  ] as const;
  const size = { width: WIDTH, height: HEIGHT, puffs: [] };
  const lab = new Lab({ ...size, shapes, sides, surfaces });
  const report = { expected: 0, differing: 0, worst: 0, backlit: 0, layers: layers.count };
  for (let number = 0; number < trials; number++) {
    const trial = trialOf(light, number % layers.count, next);
    const { puff, camera, worldFromWall, ...lighting } = trial;
    const { counts } = lab.draw({
      ...size,
      ...lighting,
      camera,
      surfaces,
      parts: [worldFromWall],
      casters: [puff],
      style: { form: 'billboards', ...style },
      readCounts: true,
    });
    const found = { expected: 0, differing: 0 };
    counts.forEach((count, pixel) => {
      const isExpected = isInShadow(pointOf(pixel, trial), trial, layers);
      if (isExpected) found.expected++;
      if (isExpected !== count > 0) found.differing++;
    });
    report.expected += found.expected;
    report.differing += found.differing;
    report.worst = Math.max(report.worst, found.differing / found.expected);
    if (frontOf(trial) < 0) report.backlit++;
  }
  lab.dispose();
  return report;
}

function shapesOf(names: readonly Name[]): Promise<PuffShape[]> {
  return Promise.all(names.map(async (name) => (await fitPuff(CARDS[name](), { lobes: 8 })).shape));
}

type Random = () => number;

function direction(next: Random): Vector3 {
  return new Vector3().setFromSphericalCoords(1, Math.acos(2 * next() - 1), next() * 2 * Math.PI);
}

/** A shadow in the middle of the picture. */
function trialOf(light: 'sun' | 'lamp', variation: number, next: Random): Trial {
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, WIDTH / HEIGHT, 0.1, 100);
  camera.quaternion.copy(new Quaternion(next() - 0.5, next() - 0.5, next() - 0.5, next() - 0.5).normalize());
  camera.position.copy(direction(next));
  camera.updateMatrixWorld();
  const back = new Vector3(0, 0, 1).transformDirection(camera.matrixWorld);
  for (;;) {
    const [towards, normal] = [direction(next), direction(next)];
    const [radius, roll] = [0.8 + 0.3 * next(), next() * 2 * Math.PI];
    const middle = camera.position.clone().addScaledVector(back, -4 - next());
    const place = middle.clone().addScaledVector(towards, (4 + 2 * next()) * radius);
    const lamp = place.clone().addScaledVector(towards, (4 + 3 * next()) * radius);
    const isSeen =
      normal.dot(back) > LEAST_COSINE &&
      Math.abs(normal.dot(towards)) > LEAST_COSINE &&
      towards.dot(back) > LEAST_FRONT &&
      place.distanceTo(camera.position) > 3 * radius;
    if (!isSeen) continue;
    const turned = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), normal);
    return {
      puff: { place: place.toArray(), radius, roll, variation },
      camera,
      worldFromWall: new Matrix4().makeRotationFromQuaternion(turned).setPosition(middle),
      wall: new Plane().setFromNormalAndCoplanarPoint(normal, middle.addScaledVector(normal, HALF[2])),
      ...(light === 'sun' ? { towardsLight: towards.toArray() } : { lamp: lamp.toArray() }),
    };
  }
}

/** The place of the wall that a pixel shows. */
function pointOf(pixel: number, { camera, wall }: Trial): Vector3 | undefined {
  const [x, y] = [pixel % WIDTH, Math.floor(pixel / WIDTH)];
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2((2 * x + 1) / WIDTH - 1, (2 * y + 1) / HEIGHT - 1), camera);
  return caster.ray.intersectPlane(wall, new Vector3()) ?? undefined;
}

function towardsLightOf({ puff, lamp, towardsLight }: Trial): Vector3 {
  return (lamp ? new Vector3(...lamp).sub(new Vector3(...puff.place)) : new Vector3(...towardsLight!)).normalize();
}

function frontOf(trial: Trial): number {
  return new Vector3(0, 0, 1).transformDirection(trial.camera.matrixWorld).dot(towardsLightOf(trial));
}

/** Whether the silhouette of the billboard, turned the shortest way from the eye to the light, is before a point. */
function isInShadow(point: Vector3 | undefined, trial: Trial, layers: PuffLayers): boolean {
  if (!point) return false;
  const { puff, camera, lamp } = trial;
  const towards = towardsLightOf(trial);
  const centre = new Vector3(...puff.place);
  const isBehind = point.clone().sub(centre).dot(towards) < 0;
  const ray = lamp ? new Vector3(...lamp).sub(point) : towards;
  const share = centre.clone().sub(point).dot(towards) / ray.dot(towards);
  const offset = point.addScaledVector(ray, share).sub(centre);
  const toView = camera.getWorldQuaternion(new Quaternion()).invert();
  const inView = towards.clone().applyQuaternion(toView);
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), inView);
  const roll = new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), puff.roll);
  const { x, y } = offset.applyQuaternion(toView).applyQuaternion(turn.multiply(roll).invert());
  return isBehind && samplePuff(layers, puff.variation, x / puff.radius, y / puff.radius).distance < 0;
}
