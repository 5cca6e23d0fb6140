import { Matrix4, Quaternion, Vector3, type Mesh, type Object3D } from 'three';
import { ParameterError } from '../preset/errors.ts';
import { POSE_FLOATS } from '../sim/layout.ts';
import type { RigidPart, SingleShape } from '../sim/rigid.ts';
import type { Simulator } from '../sim/simulator.ts';
import { errorOfOption, type CollideOptions } from './colliders.ts';
import { Handle } from './handle.ts';
import { worldPose } from './riders.ts';
import { poseOf, requireGeometry, shapeOf, type Pose } from './shapes.ts';

/** Density of light things such as paper lanterns, kg/m3. */
const LIGHT = 3;

/**
 * A light object that falls, collides and is pushed by smoke. The simulator moves it. Its meshes together are one rigid;
 * those that are no boxes or spheres count as their convex hulls.
 */
export class PushedObject extends Handle {
  private readonly simulator: Simulator;
  private readonly options: CollideOptions;
  private rigid = -1;
  private poses: Float32Array = new Float32Array(POSE_FLOATS);
  /** The pose that the host last saw. Any other pose is a move by the host. */
  private readonly written = newPose();
  private readonly now = newPose();

  constructor(simulator: Simulator, object: Object3D, options: CollideOptions) {
    super('collide', object);
    if (options.proxies)
      throw new ParameterError('collide.proxies', 'proxies', 'no value for an object that feels smoke');
    this.simulator = simulator;
    this.options = { ...options };
  }

  override show(blend: number): void {
    const { object, written } = this;
    if (!this.isActive) return;
    this.poses = this.simulator.rigidPoses(blend, this.poses);
    const first = POSE_FLOATS * this.rigid;
    written.position.fromArray(this.poses, first);
    written.rotation.fromArray(this.poses, first + 3);
    world.compose(written.position, written.rotation, object.getWorldScale(scale));
    if (object.parent) world.premultiply(own.copy(object.parent.matrixWorld).invert());
    world.decompose(object.position, object.quaternion, object.scale);
    // Read back, so that rounding is no move.
    worldPose(object, written);
  }

  protected start(): void {
    const { feelsSmoke, density = LIGHT, ...surface } = this.options;
    const { position, rotation } = worldPose(this.object, this.now);
    this.requireSound(this.now);
    const shape = { type: 'compound', parts: this.parts() } as const;
    const placed = { position: position.toArray(), rotation: rotation.toArray() };
    const push = { feelsSmoke: Number(feelsSmoke), density };
    try {
      this.rigid = this.simulator.addRigid({ kind: 'dynamic', shape, ...placed, ...surface, ...push });
    } catch (error) {
      throw errorOfOption(error);
    }
    this.written.position.copy(position);
    this.written.rotation.copy(rotation);
  }

  protected override follow(): void {
    const { position, rotation } = worldPose(this.object, this.now);
    this.requireSound(this.now);
    if (position.equals(this.written.position) && rotation.equals(this.written.rotation)) return;
    this.simulator.moveRigid(this.rigid, position.toArray(), rotation.toArray());
  }

  protected stop(): void {
    this.simulator.removeRigid(this.rigid);
  }

  /** The meshes of the object, in its space without its scale. */
  private parts(): RigidPart[] {
    const { object, now } = this;
    object.updateWorldMatrix(true, true);
    const inverse = new Matrix4().compose(now.position, now.rotation, new Vector3(1, 1, 1)).invert();
    const parts: RigidPart[] = [];
    object.traverse((part) => {
      if (!('isMesh' in part)) return;
      const mesh = part as Mesh;
      requireGeometry('collide', mesh);
      poseOf(world.multiplyMatrices(inverse, mesh.matrixWorld), place, scale);
      const shape = solidOf(shapeOf(mesh.geometry, scale.clone()));
      parts.push({ shape, position: place.position.toArray(), rotation: place.rotation.toArray() });
    });
    if (parts.length > 0) return parts;
    throw new ParameterError('collide', object.name || object.type, 'an object that contains a mesh');
  }
}

const world = new Matrix4();
const own = new Matrix4();
const scale = new Vector3();
const place = newPose();

function newPose(): Pose {
  return { position: new Vector3(), rotation: new Quaternion() };
}

/** A sheet of triangles has no mass. */
function solidOf(shape: SingleShape): SingleShape {
  return shape.type === 'trimesh' ? { type: 'convexHull', vertices: shape.vertices } : shape;
}
