import { Matrix4, Quaternion, Vector3, type InstancedMesh, type Mesh, type Object3D } from 'three';
import { ParameterError } from '../preset/errors.ts';
import type { RigidSurface, SingleShape } from '../sim/rigid.ts';
import type { Simulator } from '../sim/simulator.ts';
import { boneBalls, follow, type BallAt, type ProxyBall } from './proxies.ts';
import { poseOf, scaleOf, shapeOf, type Pose } from './shapes.ts';

/** Options for collisions with an object. */
export interface CollideOptions extends RigidSurface {
  /** Balls that replace the object's meshes. */
  proxies?: readonly ProxyBall[];
}

/** A rigid of the simulator that follows an object of the host's scene. */
interface Follower {
  rigid: number;
  locate: (into: Pose) => Pose;
  before: Pose;
  now: Pose;
}

/** Colliders of the host's scene: kinematic rigids that follow its objects. Their scale is read once. */
export class Colliders {
  private readonly simulator: Simulator;
  private readonly followers: Follower[] = [];
  private readonly between = newPose();

  constructor(simulator: Simulator) {
    this.simulator = simulator;
  }

  /**
   * Adds every mesh of an object: by its shape, by the shape of each instance, or by balls on the bones of its
   * skeleton.
   * @throws ParameterError when the object contains no mesh, or a shape that the simulator rejects
   */
  add(object: Object3D, { proxies, ...surface }: CollideOptions): void {
    object.updateWorldMatrix(true, true);
    const before = this.followers.length;
    if (proxies) for (const proxy of proxies) this.addBall(follow(proxy), proxy.follows, surface);
    else object.traverse((part) => ('isMesh' in part ? this.addMesh(part as Mesh, surface) : undefined));
    if (this.followers.length === before)
      throw new ParameterError('collide', object.name || object.type, 'an object that contains a mesh');
  }

  /** Reads the current poses. The next steps interpolate towards them. */
  look(): void {
    for (const follower of this.followers) {
      [follower.before, follower.now] = [follower.now, follower.before];
      follower.locate(follower.now);
    }
  }

  /**
   * Moves the rigids for the next step.
   * @param share fraction of the way between the poses of the last two `look` calls
   */
  move(share: number): void {
    const { between } = this;
    for (const { rigid, before, now } of this.followers) {
      if (before.position.equals(now.position) && before.rotation.equals(now.rotation)) continue;
      between.position.lerpVectors(before.position, now.position, share);
      between.rotation.slerpQuaternions(before.rotation, now.rotation, share);
      this.simulator.moveRigid(rigid, between.position.toArray(), between.rotation.toArray());
    }
  }

  private addMesh(mesh: Mesh, surface: CollideOptions): void {
    if ('isSkinnedMesh' in mesh) {
      for (const proxy of boneBalls(mesh as never)) this.addBall(follow(proxy), proxy.follows, surface);
    } else if ('isInstancedMesh' in mesh) {
      this.addInstances(mesh as InstancedMesh, surface);
    } else {
      const locate = (into: Pose) => {
        mesh.updateWorldMatrix(true, false);
        return poseOf(mesh.matrixWorld, into);
      };
      this.addRigid(shapeOf(mesh.geometry, scaleOf(mesh.matrixWorld)), locate, surface);
    }
  }

  private addInstances(mesh: InstancedMesh, surface: CollideOptions): void {
    const world = new Matrix4();
    const worldOf = (index: number) => {
      mesh.updateWorldMatrix(true, false);
      mesh.getMatrixAt(index, world);
      return world.premultiply(mesh.matrixWorld);
    };
    for (let index = 0; index < mesh.count; ++index) {
      const shape = shapeOf(mesh.geometry, scaleOf(worldOf(index)));
      this.addRigid(shape, (into) => poseOf(worldOf(index), into), surface);
    }
  }

  private addBall(ballAt: BallAt, follows: Object3D, surface: CollideOptions): void {
    const locate = (into: Pose) => {
      follows.updateWorldMatrix(true, false);
      into.position.copy(ballAt().center);
      return into;
    };
    this.addRigid({ type: 'ball', radius: ballAt().radius }, locate, surface);
  }

  private addRigid(shape: SingleShape, locate: Follower['locate'], surface: CollideOptions): void {
    const now = locate(newPose());
    const position = now.position.toArray();
    const rotation = now.rotation.toArray();
    const rigid = this.simulator.addRigid({ kind: 'kinematic', shape, position, rotation, ...surface });
    this.followers.push({ rigid, locate, before: newPose(), now });
  }
}

function newPose(): Pose {
  return { position: new Vector3(), rotation: new Quaternion() };
}
