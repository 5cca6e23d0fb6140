import { Matrix4, Quaternion, Vector3, type Box3, type Camera, type Object3D, type Plane } from 'three';
import { ParameterError } from '../base/errors.ts';
import type { AdditionalLight, Light } from '../renderer/light.ts';
import { newPose, poseOf, type Pose } from './shapes.ts';
import { FactoredCamera, isFactored } from './target/straightCamera.ts';

/** Whether puffs stay in the world when the smoke object moves, or travel with it. */
export type SmokeSpace = 'world' | 'local';

/** What a frame is drawn from: the host's, in the world or in the space of the smoke. */
interface FrameView {
  readonly camera: Camera;
  readonly light: Light;
  readonly lights: readonly AdditionalLight[];
  /** Boxes of what receives shadow. */
  readonly boxes: Box3[];
  /** Planes that cut off puffs. */
  readonly planes: readonly Plane[];
}

/** Where the space of the smoke is in the world. One of its metres is `scale` metres of the world. */
export interface Placement extends Pose {
  scale: number;
}

/** What moves farther in a step, in metres of the world, is there at once and leaves no trail: 120 m/s. */
export const TELEPORT = 2;
/** Largest coordinate of the object in world-space smoke, in metres of the smoke. */
const MAX_COORDINATE = 5000;
const MAX_SCALE = 1000;
/** Largest relative difference of the scales of the axes, and largest cosine between axes. */
const EVEN = 1e-4;
/** Scales this near 1 are 1. */
const ROUNDING = 1e-9;
const UP = new Vector3(0, 1, 0);

/**
 * The transform of a smoke object. The space of the smoke, in which it is simulated, is that of the object for local smoke;
 * for other smoke it is the world, enlarged by the scale of the object.
 */
export class SmokeFrame {
  readonly space: SmokeSpace;
  /** The space of the smoke at the latest look. */
  readonly now = unplaced();
  /** The space of the smoke in the latest picture. */
  readonly drawn = unplaced();
  /** The object in the space of the smoke at the latest look. */
  readonly object = newPose();
  /** Whether the latest look found a jump of the space of the smoke, or another scale. */
  hasJumped = false;
  /** Whether the object has had a transform. */
  isMoved = false;
  private readonly before = unplaced();
  private readonly camera = new FactoredCamera();

  constructor(space: SmokeSpace) {
    this.space = space;
  }

  /**
   * Reads the transform of the smoke object for the next steps. An invalid one leaves the space of the smoke as it is.
   * @param isFirst whether there has been no step yet
   * @throws ParameterError for a transform that is not finite, not uniform, too large or too far away
   */
  look(object: Object3D, steps: number, isFirst = false): void {
    const { before, now } = this;
    copy(before, now);
    this.hasJumped = false;
    object.updateWorldMatrix(true, false);
    const world = placementOf(object);
    const next = this.space === 'local' ? world : scaled(now, world);
    const own = toSmoke(copy(unplaced(), world), next);
    if (this.space === 'world') requireNear(object, own.position);
    this.isMoved ||= !isWorld(world);
    copy(now, next);
    this.object.position.copy(own.position);
    this.object.rotation.copy(own.rotation);
    const way = before.position.distanceTo(now.position);
    const isFar = this.space === 'local' && way > TELEPORT * steps;
    const isElsewhere = way > 0 || !before.rotation.equals(now.rotation);
    this.hasJumped = before.scale !== now.scale || (isFirst ? isElsewhere : isFar);
    if (this.hasJumped) copy(before, now);
  }

  /** Moves a pose from the world to the space of the smoke. */
  toSmoke(pose: Pose): Pose {
    return toSmoke(pose, this.now);
  }

  /** Moves a pose from the space of the smoke to the world. */
  toWorld(pose: Pose): Pose {
    const { position, rotation, scale } = this.now;
    if (isWorld(this.now)) return pose;
    pose.position.multiplyScalar(scale).applyQuaternion(rotation).add(position);
    pose.rotation.premultiply(rotation);
    return pose;
  }

  /** Turns a direction of the world to the space of the smoke. */
  rotate(direction: Vector3): Vector3 {
    return direction.applyQuaternion(inverse.copy(this.now.rotation).invert());
  }

  /**
   * A direction of the world in the space of the smoke between the last two looks; undefined while that is upright.
   * @param share 0 is the look before, 1 the latest
   */
  rotated(direction: Vector3, share: number): Vector3 | undefined {
    const [from, to] = [this.before.rotation, this.now.rotation];
    if (from.w === 1 && to.w === 1) return undefined;
    return direction.clone().applyQuaternion(inverse.slerpQuaternions(from, to, share).invert());
  }

  /** The direction of the world's up, see {@link rotated}. */
  up(share: number): Vector3 | undefined {
    const up = this.rotated(UP, share);
    return up?.y === 1 ? undefined : up;
  }

  /**
   * What a frame is drawn from, in the space of the smoke. Picture and window depths are those of the host's camera.
   * @param object the smoke object. Local smoke is drawn where it is now, since the host may move it after `update`
   */
  view(object: Object3D, { camera, light, lights, boxes, planes }: FrameView): FrameView {
    const placement = copy(this.drawn, this.space === 'local' ? shownAt(object, this.now) : this.now);
    if (isWorld(placement) && isFactored(camera)) return { camera, light, lights, boxes, planes };
    const { position, rotation, scale } = placement;
    const world = new Matrix4().compose(position, rotation, new Vector3(scale, scale, scale));
    const shown = this.camera.copyHost(camera, world, scale);
    world.invert();
    return {
      camera: shown,
      light: lightIn(light, placement),
      lights: lights.map((each) => ({ ...each, light: lightIn(each.light, placement) })),
      boxes: boxes.map((box) => box.applyMatrix4(world)),
      planes: planes.map((plane) => plane.clone().applyMatrix4(world)),
    };
  }
}

/** Moves a pose from the world to a space of smoke. */
export function toSmoke<Kind extends Pose>(pose: Kind, placement: Placement): Kind {
  if (isWorld(placement)) return pose;
  const { position, rotation, scale } = placement;
  inverse.copy(rotation).invert();
  pose.position.sub(position).applyQuaternion(inverse).divideScalar(scale);
  pose.rotation.premultiply(inverse);
  return pose;
}

const inverse = new Quaternion();

function unplaced(): Placement {
  return { ...newPose(), scale: 1 };
}

function copy(into: Placement, from: Placement): Placement {
  into.position.copy(from.position);
  into.rotation.copy(from.rotation);
  into.scale = from.scale;
  return into;
}

function isWorld({ position, rotation, scale }: Placement): boolean {
  return scale === 1 && rotation.w === 1 && position.lengthSq() === 0;
}

/** The world enlarged by the scale of an object, whose origin stays where it is in the smoke. */
function scaled(now: Placement, { position, scale }: Placement): Placement {
  const next = copy(unplaced(), now);
  if (scale === now.scale) return next;
  next.position
    .sub(position)
    .multiplyScalar(scale / now.scale)
    .add(position);
  next.scale = scale;
  return next;
}

/** @throws ParameterError for a matrix that no {@link Placement} describes */
function placementOf(object: Object3D): Placement {
  const axes = axesOf(object);
  const [x, y, z] = axes.map((axis) => axis.length());
  const cosines = axes.map((axis, index) => Math.abs(axis.dot(axes[(index + 1) % 3])));
  const isUniform = Math.max(Math.abs(y - x), Math.abs(z - x)) <= EVEN * x && Math.max(...cosines) <= EVEN * x * x;
  const isUsable = isUniform && x >= 1 / MAX_SCALE && x <= MAX_SCALE && object.matrixWorld.determinant() > 0;
  const into = unplaced();
  poseOf(object.matrixWorld, into);
  // NaN fails every comparison.
  if (!(isUsable && into.position.length() < Infinity)) throw invalid(object);
  into.scale = Math.abs(x - 1) < ROUNDING ? 1 : x;
  return into;
}

function axesOf({ matrixWorld }: Object3D): Vector3[] {
  return [0, 1, 2].map((column) => new Vector3().setFromMatrixColumn(matrixWorld, column));
}

function shownAt(object: Object3D, otherwise: Placement): Placement {
  try {
    return placementOf(object);
  } catch {
    return otherwise;
  }
}

function requireNear(object: Object3D, { x, y, z }: Vector3): void {
  if (!(Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= MAX_COORDINATE)) throw invalid(object);
}

function invalid(object: Object3D): ParameterError {
  const { name, type, matrixWorld } = object;
  const at = new Vector3().setFromMatrixPosition(matrixWorld).toArray();
  const scales = axesOf(object).map((axis) => Number(axis.length().toFixed(4)));
  const mirror = matrixWorld.determinant() < 0 ? ', mirrored' : '';
  const shown = `${name || type} at ${at.join(', ')} with the scale ${scales.join(', ')}${mirror}`;
  const accepted = `a finite transform without shear, with one scale from ${1 / MAX_SCALE} to ${MAX_SCALE}`;
  return new ParameterError('smoke.transform', shown, `${accepted}, within ${MAX_COORDINATE} m for smoke in the world`);
}

function lightIn(light: Light, placement: Placement): Light {
  const turned = (axis: Vector3) => axis.applyQuaternion(inverse.copy(placement.rotation).invert());
  if (light.kind === 'sun') return { kind: 'sun', towards: turned(light.towards) };
  const { place, falloff } = light;
  const cone = falloff?.cone && { ...falloff.cone, axis: turned(falloff.cone.axis) };
  return {
    kind: 'lamp',
    place: toSmoke({ ...newPose(), position: place }, placement).position,
    falloff: falloff && { ...falloff, cone, scale: placement.scale },
  };
}
