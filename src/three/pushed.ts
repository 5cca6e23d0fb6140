import { Matrix4, Vector3, type Object3D } from 'three';
import { ParameterError } from '../base/errors.ts';
import { POSE_FLOATS } from '../simulator/layout.ts';
import type { RigidPart, SingleShape } from '../simulator/rigid.ts';
import { errorOfOption, type CollideOptions, type Obstacles } from './colliders.ts';
import { Handle } from './handle.ts';
import { worldPose } from './objectParts.ts';
import { meshesIn, newPose, partsOf, poseOf, shapeOf, type Pose } from './shapes.ts';

/** Density of light things such as paper lanterns, kg/m3. */
const LIGHT = 3;
/** Largest distance, in metres and in the components of a quaternion, that is rounding. */
const ROUNDING = 1e-5;

/**
 * A light object that falls, collides and is pushed by smoke. The simulator moves it. Its meshes together are one rigid;
 * those that are no boxes or spheres count as their convex hulls.
 */
export class PushedObject extends Handle {
  private readonly obstacles: Obstacles;
  private readonly options: CollideOptions;
  /** Index of its rigid; -1 while the simulator has no dynamic rigids. */
  private rigid = -1;
  /** Scale of the smoke for which its shape was made. */
  private scale = 1;
  private poses: Float32Array = new Float32Array(POSE_FLOATS);
  /** The poses in the world and in the smoke that the host last saw. Any other pose is a move by the host. */
  private readonly written = newPose();
  private readonly inSmoke = newPose();
  private readonly now = newPose();

  constructor(obstacles: Obstacles, object: Object3D, options: CollideOptions) {
    super('collide', object);
    if (options.proxies)
      throw new ParameterError('collide.proxies', 'proxies', 'no value for an object that feels smoke');
    this.obstacles = obstacles;
    this.options = { ...options };
  }

  override show(blend: number): void {
    const { object, written } = this;
    const { simulator, frame } = this.obstacles;
    if (!this.isActive || this.rigid < 0) return;
    this.poses = simulator.rigidPoses(blend, this.poses);
    const first = POSE_FLOATS * this.rigid;
    written.position.fromArray(this.poses, first);
    written.rotation.fromArray(this.poses, first + 3);
    frame.toWorld(written);
    world.compose(written.position, written.rotation, object.getWorldScale(scale));
    if (object.parent) world.premultiply(own.copy(object.parent.matrixWorld).invert());
    world.decompose(object.position, object.quaternion, object.scale);
    // Read back, so that rounding is no move.
    worldPose(object, written);
    this.note();
  }

  protected start(): void {
    const { feelsSmoke, density = LIGHT, shape: _around, ...surface } = this.options;
    worldPose(this.object, this.written);
    this.note();
    const { position, rotation } = this.inSmoke;
    this.requireSound(this.inSmoke);
    const { simulator } = this.obstacles;
    const shape = { type: 'compound', parts: this.parts() } as const;
    if (!simulator.hasDynamics) return this.obstacles.need('physics');
    const placed = { position: position.toArray(), rotation: rotation.toArray() };
    const push = { feelsSmoke: Number(feelsSmoke), density };
    try {
      this.rigid = simulator.addRigid({ kind: 'dynamic', shape, ...placed, ...surface, ...push });
    } catch (error) {
      throw errorOfOption(error);
    }
  }

  protected override follow(): void {
    const { written, inSmoke, now } = this;
    const { simulator, frame } = this.obstacles;
    if (!simulator.hasDynamics) return;
    if (frame.now.scale !== this.scale || this.rigid < 0) {
      this.stop();
      return this.start();
    }
    const { position, rotation } = worldPose(this.object, now);
    const isWhereItWas = position.equals(written.position) && rotation.equals(written.rotation);
    this.requireSound(frame.toSmoke(now));
    // Local smoke takes it along, if the host does not.
    if (isWhereItWas || (frame.isMoved && isNear(now, inSmoke))) return;
    simulator.moveRigid(this.rigid, position.toArray(), rotation.toArray());
  }

  protected stop(): void {
    if (this.rigid >= 0) this.obstacles.simulator.removeRigid(this.rigid);
    this.rigid = -1;
  }

  private note(): void {
    this.inSmoke.position.copy(this.written.position);
    this.inSmoke.rotation.copy(this.written.rotation);
    this.obstacles.frame.toSmoke(this.inSmoke);
  }

  /** The meshes of the object, in its space without its scale. */
  private parts(): RigidPart[] {
    const { object, written } = this;
    const { scale: size } = this.obstacles.frame.now;
    this.scale = size;
    object.updateWorldMatrix(true, true);
    const sizes = new Vector3(size, size, size);
    const inverse = new Matrix4().compose(written.position, written.rotation, sizes).invert();
    const parts: RigidPart[] = [];
    for (const mesh of meshesIn(object)) {
      if ('isSkinnedMesh' in mesh)
        throw new ParameterError('collide.feelsSmoke', mesh.name || mesh.type, 'an object without skinned meshes');
      for (const { geometry, worldOf } of partsOf('collide', mesh)) {
        poseOf(world.multiplyMatrices(inverse, worldOf()), place, scale);
        const shape = solidOf(shapeOf(geometry, scale.clone()));
        parts.push({ shape, position: place.position.toArray(), rotation: place.rotation.toArray() });
      }
    }
    if (parts.length > 0) return parts;
    throw new ParameterError('collide', object.name || object.type, 'an object that contains a mesh');
  }
}

const world = new Matrix4();
const own = new Matrix4();
const scale = new Vector3();
const place = newPose();

/** Whether two poses differ by rounding only. */
function isNear(one: Pose, other: Pose): boolean {
  const alignment = Math.abs(one.rotation.dot(other.rotation));
  return one.position.distanceTo(other.position) <= ROUNDING && alignment >= 1 - ROUNDING;
}

/** A sheet of triangles has no mass. */
function solidOf(shape: SingleShape): SingleShape {
  return shape.type === 'trimesh' ? { type: 'convexHull', vertices: shape.vertices } : shape;
}
