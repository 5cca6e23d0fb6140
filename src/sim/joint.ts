/**
 * Joints between rigids as a caller describes them, and as they cross into WASM.
 */
import { ParameterError } from '../preset/errors.ts';
import type { Triple } from './pose.ts';

/** Two rigids by their index, at least one of them dynamic, joined as they stand. They do not collide with each other. */
export type JointDescription = {
  rigids: readonly [number, number];
  /** Where it is fastened, in each rigid's own space; metres. */
  anchors: readonly [Triple, Triple];
} & (
  | { type: 'fixed' }
  /** All turning is free. */
  | { type: 'ball' }
  /**
   * Turns about an axis of the first rigid's space; limits in rad from how the two stand now, -pi to pi. The motor
   * turns the second rigid at a speed (rad/s, -200 to 200) with at most a torque (N m).
   */
  | {
      type: 'hinge';
      axis: Triple;
      limits?: readonly [number, number];
      motor?: { speed: number; torque: number };
    }
  /** Free within a length (m). */
  | { type: 'rope'; length: number }
  /** A spring draws the anchors to a length (m): stiffness in N/m, damping in N s/m. */
  | { type: 'spring'; length: number; stiffness: number; damping: number }
);

const TYPES: readonly string[] = ['fixed', 'ball', 'hinge', 'rope', 'spring'];

/** The numbers of `sim/src/rigids/joints.rs`. */
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
