import type { Matrix4, Mesh, Object3D, SkinnedMesh, Vector3 } from 'three';
import { ParameterError, requireOptions } from '../base/errors.ts';
import { accepted as acceptedBy } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import type { RigidSurface, SingleShape } from '../simulator/rigid.ts';
import type { Simulator } from '../simulator/simulator.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import { Handle } from './handle.ts';
import { boneBalls, worldBall, requireProxies, type BallAt, type ProxyBall } from './proxies.ts';
import { meshesIn, newPose, partsOf, poseOf, scaleOf, shapeOf, type Pose } from './shapes.ts';

/** Options for collisions with an object. */
export interface CollideOptions extends RigidSurface {
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

const OPTIONS = ['restitution', 'friction', 'action', 'tint', 'boundaryLayer', 'proxies', 'feelsSmoke', 'density'];

/** A rigid of the simulator that follows an object of the host's scene. */
interface Follower {
  rigid: number;
  locate: (into: Pose) => Pose;
  before: Pose;
  now: Pose;
}

/**
 * A collider of the host's scene: kinematic rigids that follow the meshes of an object. Their shapes and scales are read
 * when it starts.
 */
export class Collider extends Handle {
  private readonly simulator: Simulator;
  private readonly frame: SmokeFrame;
  private readonly options: CollideOptions;
  private followers: Follower[] = [];
  /** Scale of the smoke for which its shapes were made. */
  private scale = 1;

  constructor(simulator: Simulator, frame: SmokeFrame, object: Object3D, options: CollideOptions) {
    super('collide', object);
    this.simulator = simulator;
    this.frame = frame;
    this.options = { ...options };
  }

  /** Moves the rigids for the next step. */
  override move(_from: number, to: number): void {
    for (const { rigid, before, now } of this.followers) {
      if (before.position.equals(now.position) && before.rotation.equals(now.rotation)) continue;
      between.position.lerpVectors(before.position, now.position, to);
      between.rotation.slerpQuaternions(before.rotation, now.rotation, to);
      this.simulator.moveRigid(rigid, between.position.toArray(), between.rotation.toArray());
    }
  }

  /**
   * Adds every mesh of the object: by its shape, by the shape of each instance, or by balls on the bones of its
   * skeleton.
   * @throws ParameterError when the object contains no mesh, or a shape that the simulator rejects
   */
  protected start(): void {
    const { object } = this;
    const { proxies, feelsSmoke: _push, ...surface } = this.options;
    object.updateWorldMatrix(true, true);
    this.scale = this.frame.now.scale;
    try {
      if (proxies) for (const proxy of proxies) this.addBall(worldBall(proxy), proxy.follows, surface);
      else for (const mesh of meshesIn(object)) this.addMesh(mesh, surface);
    } catch (error) {
      this.stop();
      throw errorOfOption(error);
    }
    if (this.followers.length === 0)
      throw new ParameterError('collide', object.name || object.type, 'an object that contains a mesh');
  }

  protected override follow(): void {
    if (this.frame.hasJumped || this.frame.now.scale !== this.scale) {
      // A rigid that moves there would sweep the smoke along, and its shape has the scale of the smoke.
      this.stop();
      return this.start();
    }
    for (const follower of this.followers) {
      [follower.before, follower.now] = [follower.now, follower.before];
      this.requireSound(this.frame.toSmoke(follower.locate(follower.now)));
    }
  }

  protected stop(): void {
    for (const { rigid } of this.followers) this.simulator.removeRigid(rigid);
    this.followers = [];
  }

  private addMesh(mesh: Mesh, surface: RigidSurface): void {
    const parts = partsOf('collide', mesh);
    if ('isSkinnedMesh' in mesh) {
      for (const proxy of boneBalls(mesh as SkinnedMesh)) this.addBall(worldBall(proxy), proxy.follows, surface);
      return;
    }
    for (const { geometry, worldOf } of parts)
      this.addRigid(shapeOf(geometry, this.scaleIn(worldOf())), (into) => poseOf(worldOf(), into), surface);
  }

  private addBall(ballAt: BallAt, follows: Object3D, surface: RigidSurface): void {
    const locate = (into: Pose) => {
      follows.updateWorldMatrix(true, false);
      into.position.copy(ballAt().center);
      into.rotation.identity();
      return into;
    };
    this.addRigid({ type: 'ball', radius: ballAt().radius / this.frame.now.scale }, locate, surface);
  }

  private scaleIn(world: Matrix4): Vector3 {
    return scaleOf(world).divideScalar(this.frame.now.scale);
  }

  private addRigid(shape: SingleShape, locate: Follower['locate'], surface: RigidSurface): void {
    const now = this.frame.toSmoke(locate(newPose()));
    this.requireSound(now);
    const position = now.position.toArray();
    const rotation = now.rotation.toArray();
    const rigid = this.simulator.addRigid({ kind: 'kinematic', shape, position, rotation, ...surface });
    this.followers.push({ rigid, locate, before: newPose(), now });
  }
}

const between = newPose();

/** @throws ParameterError for an unknown option, a proxy without a radius or an invalid strength of the push */
export function requireCollideOptions(options: CollideOptions): void {
  requireOptions('collide', options, OPTIONS);
  requireProxies('collide', options.proxies);
  const { feelsSmoke = false } = options;
  const isStrength = typeof feelsSmoke === 'number' && feelsSmoke >= 0 && feelsSmoke <= 10;
  if (typeof feelsSmoke !== 'boolean' && !isStrength)
    throw new ParameterError('collide.feelsSmoke', feelsSmoke, 'true, false or a number from 0 to 10');
}

/** The simulator's error with the name that the caller gave: options of `collide` are those of a rigid. */
export function errorOfOption(error: unknown): unknown {
  if (!(error instanceof ParameterError) || !error.key.startsWith('rigid.')) return error;
  const accepted = error.key === 'rigid.tint' ? acceptedBy(findParameter('colliders.0.tint')!) : error.accepted;
  return new ParameterError(error.key.replace('rigid', 'collide'), error.value, accepted);
}
