import { Vector3, type Mesh, type Object3D, type SkinnedMesh } from 'three';
import { ParameterError, requireOptions } from '../base/errors.ts';
import { validate } from '../parameters/values.ts';
import { COLLIDER_LIMIT, colliderNumbers, isAnalytic, type ColliderShape } from '../simulator/collider.ts';
import type { RigidSurface, SingleShape } from '../simulator/rigid.ts';
import type { Simulator } from '../simulator/simulator.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import { Handle } from './handle.ts';
import { boneBalls, worldBall, requireProxies, type BallAt, type ProxyBall } from './proxies.ts';
import { worldPose } from './objectParts.ts';
import {
  SURROUNDING,
  meshesIn,
  newPose,
  partsOf,
  poseOf,
  scaleOf,
  shapeAround,
  shapeOf,
  type Pose,
  type Surrounding,
} from './shapes.ts';

/** Options for collisions with an object. */
export interface CollideOptions extends RigidSurface {
  /**
   * One shape around all meshes of the object instead of their own shapes, which are exact for boxes, spheres and capsules. A
   * capsule stands along the object's y axis. A plane is the widest side of the meshes, and smoke stays in front of it.
   */
  shape?: 'ball' | 'box' | 'capsule' | 'plane';
  /** Balls that replace the object's meshes. */
  proxies?: readonly ProxyBall[];
  /**
   * Whether smoke pushes the object, which then also falls and collides with the other colliders: the simulator moves it.
   * True is as strong as air; a number from 0 to 10 is a factor. Default false: the object moves as the host moves it.
   */
  feelsSmoke?: boolean | number;
  /** Density of an object that feels smoke, 0.01 to 100,000 kg/m3. Default 3, as a paper lantern. */
  density?: number;
}

const SURFACE = ['restitution', 'friction', 'action', 'tint', 'boundaryLayer'];
const OPTIONS = [...SURFACE, 'shape', 'proxies', 'feelsSmoke', 'density'];

/** A shape in the smoke, and where it is in the world. */
interface Solid {
  shape: ColliderShape;
  locate: (into: Pose) => Pose;
}

/** A solid in the simulator. */
interface Follower extends Solid {
  index: number;
  before: Pose;
  now: Pose;
}

/** What the simulator knows of the objects that smoke collides with. */
export interface Obstacles {
  readonly simulator: Simulator;
  readonly frame: SmokeFrame;
  /** Places of colliders that are taken. */
  readonly taken: Set<number>;
  /** Starts to load the simulator with meshes or with physics. @throws UnsupportedError if it must not be loaded */
  need(what: 'meshes' | 'physics'): void;
}

/**
 * A collider of the host's scene: colliders that follow the meshes of an object, or kinematic rigids once the simulator has
 * them, so that rigids collide with them too. Shapes and scales are read when it starts.
 */
export class Collider extends Handle {
  private readonly obstacles: Obstacles;
  private readonly options: CollideOptions;
  private followers: Follower[] = [];
  private areRigids = false;
  /** Scale of the smoke for which its shapes were made. */
  private scale = 1;

  constructor(obstacles: Obstacles, object: Object3D, options: CollideOptions) {
    super('collide', object);
    this.obstacles = obstacles;
    this.options = { ...options };
  }

  /** Moves the obstacles for the next step. */
  override move(_from: number, to: number): void {
    const { simulator } = this.obstacles;
    for (const { index, before, now } of this.followers) {
      if (before.position.equals(now.position) && before.rotation.equals(now.rotation)) continue;
      const position = between.position.lerpVectors(before.position, now.position, to).toArray();
      const rotation = between.rotation.slerpQuaternions(before.rotation, now.rotation, to).toArray();
      if (this.areRigids) simulator.moveRigid(index, position, rotation);
      else simulator.setCollider(index, Float32Array.of(...position, ...rotation));
    }
  }

  /**
   * Adds every mesh of the object: by its shape, by the shape of each instance, or by balls on the bones of its
   * skeleton. Without a simulator that can add them it waits for that.
   * @throws ParameterError when the object contains no mesh, or a shape that the simulator rejects
   */
  protected start(): void {
    const { object, obstacles } = this;
    const { simulator, frame, taken } = obstacles;
    object.updateWorldMatrix(true, true);
    this.scale = frame.now.scale;
    this.areRigids = simulator.hasRigids;
    const solids = this.solids();
    if (solids.length === 0)
      throw new ParameterError('collide', object.name || object.type, 'an object that contains a mesh');
    const arePooled = solids.length + taken.size <= COLLIDER_LIMIT;
    if (!this.areRigids && !(arePooled && solids.every(({ shape }) => isAnalytic(shape, this.options))))
      return obstacles.need('meshes');
    try {
      for (const solid of solids)
        this.add(this.areRigids && solid.shape.type === 'plane' ? slabOf(solid, this.scale) : solid);
    } catch (error) {
      this.stop();
      throw errorOfOption(error);
    }
  }

  protected override follow(): void {
    const { simulator, frame } = this.obstacles;
    if (frame.hasJumped || frame.now.scale !== this.scale || simulator.hasRigids !== this.areRigids) {
      // What moves there would sweep the smoke along, and its shape has the scale of the smoke.
      this.stop();
      return this.start();
    }
    for (const follower of this.followers) {
      [follower.before, follower.now] = [follower.now, follower.before];
      this.requireSound(frame.toSmoke(follower.locate(follower.now)));
    }
  }

  protected stop(): void {
    const { simulator, taken } = this.obstacles;
    for (const { index } of this.followers) {
      if (this.areRigids) simulator.removeRigid(index);
      else {
        simulator.setCollider(index, NOTHING);
        taken.delete(index);
      }
    }
    this.followers = [];
  }

  private solids(): Solid[] {
    const { object } = this;
    const { proxies, shape } = this.options;
    if (proxies) return proxies.map((proxy) => this.ballOf(worldBall(proxy), proxy.follows));
    if (shape) return this.solidAround(shape);
    return meshesIn(object).flatMap((mesh) => this.solidsOf(mesh));
  }

  private solidsOf(mesh: Mesh): Solid[] {
    const parts = partsOf('collide', mesh);
    if ('isSkinnedMesh' in mesh)
      return boneBalls(mesh as SkinnedMesh).map((proxy) => this.ballOf(worldBall(proxy), proxy.follows));
    return parts.map(({ geometry, worldOf }) => ({
      shape: shapeOf(geometry, scaleOf(worldOf()).divideScalar(this.scale)),
      locate: (into) => poseOf(worldOf(), into),
    }));
  }

  private ballOf(ballAt: BallAt, follows: Object3D): Solid {
    const locate = (into: Pose) => {
      follows.updateWorldMatrix(true, false);
      into.position.copy(ballAt().center);
      into.rotation.identity();
      return into;
    };
    return { shape: { type: 'ball', radius: ballAt().radius / this.scale }, locate };
  }

  private solidAround(kind: Surrounding): Solid[] {
    const placed = shapeAround(kind, this.object, this.scale);
    if (!placed) return [];
    const locate = (into: Pose) => {
      worldPose(this.object, into);
      into.position.add(offset.copy(placed.position).applyQuaternion(into.rotation));
      into.rotation.multiply(placed.rotation);
      return into;
    };
    return [{ shape: placed.shape, locate }];
  }

  private add(solid: Solid): void {
    const { simulator, frame, taken } = this.obstacles;
    const { shape, locate } = solid;
    const { proxies: _balls, feelsSmoke: _push, shape: _around, ...surface } = this.options;
    const now = frame.toSmoke(locate(newPose()));
    this.requireSound(now);
    const [position, rotation] = [now.position.toArray(), now.rotation.toArray()];
    let index = 0;
    if (this.areRigids)
      index = simulator.addRigid({ kind: 'kinematic', shape: shape as SingleShape, position, rotation, ...surface });
    else {
      while (taken.has(index)) index++;
      simulator.setCollider(index, colliderNumbers(shape, position, rotation, surface));
      taken.add(index);
    }
    this.followers.push({ ...solid, index, before: newPose(), now });
  }
}

/** Half extents of the slab that is a half space to rigids, in metres of the smoke. */
const SLAB = [1000, 100, 1000] as const;

function slabOf({ locate }: Solid, scale: number): Solid {
  const below = (pose: Pose) => {
    locate(pose).position.add(offset.set(0, -scale * SLAB[1], 0).applyQuaternion(pose.rotation));
    return pose;
  };
  return { shape: { type: 'cuboid', halfExtents: SLAB }, locate: below };
}

const NOTHING = new Float32Array();
const offset = new Vector3();
const between = newPose();

/** @throws ParameterError for an unknown option or an invalid value */
export function requireCollideOptions(options: CollideOptions): void {
  requireOptions('collide', options, OPTIONS);
  const { shape, proxies, feelsSmoke = false, boundaryLayer = 0, density = 1, ...surface } = options;
  requireProxies('collide', proxies);
  if (shape !== undefined && !SURROUNDING.includes(shape))
    throw new ParameterError('collide.shape', shape, SURROUNDING.join(', '));
  if (shape !== undefined && (proxies || feelsSmoke))
    throw new ParameterError('collide.shape', shape, 'no value for an object with proxies, or one that feels smoke');
  if (typeof feelsSmoke !== 'boolean' && !isWithin(feelsSmoke, 0, 10))
    throw new ParameterError('collide.feelsSmoke', feelsSmoke, 'true, false or a number from 0 to 10');
  if (!isWithin(boundaryLayer, 0, 10)) throw new ParameterError('collide.boundaryLayer', boundaryLayer, '0 to 10');
  if (!isWithin(density, 0.01, 1e5)) throw new ParameterError('collide.density', density, '0.01 to 100000');
  const given = Object.entries(surface).filter(([, value]) => value !== undefined);
  try {
    validate(Object.fromEntries(given.map(([key, value]) => [`colliders.0.${key}`, value])));
  } catch (error) {
    throw errorOfOption(error);
  }
}

function isWithin(value: number, min: number, max: number): boolean {
  return typeof value === 'number' && value >= min && value <= max;
}

/** The error with the name that the caller gave: options of `collide` are those of a rigid or of an obstacle of the table. */
export function errorOfOption(error: unknown): unknown {
  const key = error instanceof ParameterError ? error.key.replace(/^(rigid|colliders\.0)\./, 'collide.') : undefined;
  return error instanceof ParameterError && key !== error.key
    ? new ParameterError(key!, error.value, error.accepted)
    : error;
}
