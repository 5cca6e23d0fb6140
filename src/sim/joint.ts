/** Descriptions of joints between rigids, and their packing for WASM. */
import { ParameterError } from '../preset/errors.ts';
import type { Triple } from './pose.ts';

/**
 * A joint between two rigids, referenced by index, in their current relative pose. At least one of them must be
 * dynamic. Joined rigids do not collide with each other.
 */
export type JointDescription = {
  rigids: readonly [number, number];
  /** Anchor points in the local space of each rigid, metres. */
  anchors: readonly [Triple, Triple];
} & (
  | { type: 'fixed' }
  /** All rotations are free. */
  | { type: 'ball' }
  /**
   * Rotates about an axis in the first rigid's local space. Limits are in rad relative to the current pose, -pi to pi.
   * The motor rotates the second rigid at `speed` (rad/s, -200 to 200) with at most `torque` (N m).
   */
  | {
      type: 'hinge';
      axis: Triple;
      limits?: readonly [number, number];
      motor?: { speed: number; torque: number };
    }
  /** Limits the distance between the anchors to `length` (m). */
  | { type: 'rope'; length: number }
  /** A spring with the rest length `length` (m), stiffness in N/m and damping in N s/m. */
  | { type: 'spring'; length: number; stiffness: number; damping: number }
);

const TYPES: readonly string[] = ['fixed', 'ball', 'hinge', 'rope', 'spring'];

/**
 * Packs a joint for `sim-wasm/sim/src/rigids/joints.rs`.
 * @throws ParameterError for an unknown type
 */
export function jointNumbers(joint: JointDescription): Float32Array {
  const type = TYPES.indexOf(joint.type);
  if (type < 0) throw new ParameterError('joint.type', joint.type, `one of ${TYPES.join(', ')}`);
  const [a, b] = joint.anchors;
  return Float32Array.of(type, ...joint.rigids, a[0], a[1], a[2], b[0], b[1], b[2], ...ownNumbers(joint));
}

function ownNumbers(joint: JointDescription): number[] {
  switch (joint.type) {
    case 'hinge': {
      const { axis, limits, motor } = joint;
      return [axis[0], axis[1], axis[2], limits ? 1 : 0, ...(limits ?? [0, 0]), motor?.speed ?? 0, motor?.torque ?? 0];
    }
    case 'rope':
      return [joint.length];
    case 'spring':
      return [joint.length, joint.stiffness, joint.damping];
    default:
      return [];
  }
}
