/** Colliders outside the parameter table, packed for WASM. */
import { poseNumbers, type RigidSurface, type SingleShape } from './rigid.ts';

/** Number of places for colliders outside the parameter table: `COLLIDER_LIMIT` in Rust. */
export const COLLIDER_LIMIT = 256;

/** A shape of a rigid, or the half space where the local y is below 0. */
export type ColliderShape = SingleShape | { type: 'plane' };

const SHAPES: readonly string[] = ['plane', 'ball', 'cuboid', 'capsule'];
const ACTIONS: readonly string[] = ['bounce', 'kill', 'tint'];

/** Whether the simulator without physics has this collider. */
export function isAnalytic({ type }: ColliderShape, { boundaryLayer = 0 }: RigidSurface): boolean {
  return SHAPES.includes(type) && boundaryLayer === 0;
}

/** The numbers of {@link Simulator.setCollider} for a collider at rest. */
export function colliderNumbers(
  shape: ColliderShape,
  position: ArrayLike<number>,
  rotation: ArrayLike<number>,
  { restitution = 0, friction = 0.5, action = 'bounce', tint = 1 }: RigidSurface,
): Float32Array {
  const [x, y, z] = Array.from(halfExtentsOf(shape));
  const radius = 'radius' in shape ? shape.radius : 1;
  const surface = [restitution, friction, ACTIONS.indexOf(action), tint];
  return Float32Array.of(SHAPES.indexOf(shape.type), x, y, z, radius, ...surface, ...poseNumbers(position, rotation));
}

/** Those that a shape does not have are 1. */
function halfExtentsOf(shape: ColliderShape): ArrayLike<number> {
  if (shape.type === 'cuboid') return shape.halfExtents;
  return [1, shape.type === 'capsule' ? shape.halfHeight : 1, 1];
}
