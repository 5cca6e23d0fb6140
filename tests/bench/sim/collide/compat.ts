/**
 * Rapier's JavaScript bindings as a page would use them to query the position of each particle, with minimal overhead.
 */
import RAPIER from '@dimforge/rapier3d-compat';
import type { RigidShape } from '../../../../src/simulator/rigid.ts';
import { poseAt, type Swing } from './obstacles.ts';

/** Rapier's own world with the same rigids. */
export class CompatWorld {
  private readonly world: RAPIER.World;
  private readonly bodies: RAPIER.RigidBody[];
  private readonly swings: readonly Swing[];
  private readonly point = { x: 0, y: 0, z: 0 };
  /** Reused for each query, so that the bindings allocate no result object. */
  private readonly answer: RAPIER.PointColliderProjection;

  private constructor(swings: readonly Swing[], seconds: number) {
    this.swings = swings;
    this.world = new RAPIER.World({ x: 0, y: 0, z: 0 });
    this.world.timestep = 1 / 60;
    this.bodies = swings.map((swing) => this.add(swing, seconds));
    this.world.step();
    const collider = this.bodies[0].collider(0);
    this.answer = new RAPIER.PointColliderProjection(collider, { x: 0, y: 0, z: 0 }, false);
  }

  static async create(swings: readonly Swing[], seconds: number): Promise<CompatWorld> {
    await RAPIER.init();
    return new CompatWorld(swings, seconds);
  }

  /** Moves the rigids to their poses after some seconds, as the simulator does: with one step of the world. */
  moveTo(seconds: number): void {
    this.bodies.forEach((body, index) => {
      const { position, rotation } = poseAt(this.swings[index], seconds);
      body.setNextKinematicTranslation(vector(position));
      body.setNextKinematicRotation(quaternion(rotation));
    });
    this.world.step();
  }

  /** x, y, z of the rigid. */
  placeOf(index: number): [number, number, number] {
    const { x, y, z } = this.bodies[index].translation();
    return [x, y, z];
  }

  /**
   * One query per particle, without further processing of the result.
   *
   * @param place rows of x, y, z and radius
   * @returns number of centres inside a rigid
   */
  projectAll(place: Float32Array, count: number): number {
    let inside = 0;
    for (let row = 0; row < count; row++) {
      if (this.project(place[4 * row], place[4 * row + 1], place[4 * row + 2]).isInside) inside++;
    }
    return inside;
  }

  /** Signed distance from a point to the nearest surface, metres; negative inside. */
  distance(x: number, y: number, z: number): number {
    const { point, isInside } = this.project(x, y, z);
    const distance = Math.hypot(point.x - x, point.y - y, point.z - z);
    return isInside ? -distance : distance;
  }

  dispose(): void {
    this.world.free();
  }

  private project(x: number, y: number, z: number): RAPIER.PointColliderProjection {
    const { world, point } = this;
    point.x = x;
    point.y = y;
    point.z = z;
    const { broadPhase, narrowPhase, bodies, colliders } = world;
    const [none, absent] = [undefined, NO_FILTER];
    broadPhase.projectPoint(
      narrowPhase,
      bodies,
      colliders,
      point,
      false,
      none,
      none,
      absent,
      absent,
      none,
      this.answer,
    );
    return this.answer;
  }

  private add(swing: Swing, seconds: number): RAPIER.RigidBody {
    const { position, rotation } = poseAt(swing, seconds);
    const description = RAPIER.RigidBodyDesc.kinematicPositionBased()
      .setTranslation(...position)
      .setRotation(quaternion(rotation));
    const body = this.world.createRigidBody(description);
    this.world.createCollider(colliderOf(swing.shape), body);
    return body;
  }
}

// The bindings use null for a missing handle, against their type declarations.
const NO_FILTER = null as unknown as undefined;

function colliderOf(shape: RigidShape): RAPIER.ColliderDesc {
  const { ColliderDesc } = RAPIER;
  switch (shape.type) {
    case 'ball':
      return ColliderDesc.ball(shape.radius);
    case 'cuboid':
      return ColliderDesc.cuboid(shape.halfExtents[0], shape.halfExtents[1], shape.halfExtents[2]);
    case 'capsule':
      return ColliderDesc.capsule(shape.halfHeight, shape.radius);
    case 'cylinder':
      return ColliderDesc.cylinder(shape.halfHeight, shape.radius);
    default:
      throw new Error(`The bench has no ${shape.type}.`);
  }
}

function vector([x, y, z]: readonly [number, number, number]): RAPIER.Vector3 {
  return new RAPIER.Vector3(x, y, z);
}

function quaternion([x, y, z, w]: readonly [number, number, number, number]): RAPIER.Quaternion {
  return new RAPIER.Quaternion(x, y, z, w);
}
