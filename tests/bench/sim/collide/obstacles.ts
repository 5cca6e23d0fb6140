/** The rigids of both sides of collide.vsCompat, and the smoke among them. */
import { emptyParticles, type Particles } from '../../support/snapshot.ts';
import { random } from '../../../visual/random.ts';
import type { RigidShape } from '../../../../src/simulator/rigid.ts';

export const RIGIDS = 100;

/** Half side of the box with particles and rigids, metres. The rigids fill about 5 % of it. */
const HALF_SIDE = 1.5;

/** A rigid that oscillates around its position and rotates around an axis. */
export interface Swing {
  shape: RigidShape;
  place: readonly [number, number, number];
  /** Angular rate of the oscillation, rad/s, and its initial phase. */
  pace: number;
  phase: number;
}

/** Position (m) and unit quaternion x, y, z, w. */
export interface Pose {
  position: [number, number, number];
  rotation: [number, number, number, number];
}

/** Seeded rigids of four shapes. Their size decreases with their number, so that they fill the same volume. */
export function seededSwings(seed: number, count = RIGIDS): Swing[] {
  const next = random(seed);
  const spot = () => (2 * next() - 1) * HALF_SIDE;
  const scale = Math.cbrt(RIGIDS / count);
  return Array.from({ length: count }, (_, index) => ({
    shape: shapeOf(index % 4, scale * (0.08 + 0.1 * next())),
    place: [spot(), spot(), spot()] as const,
    pace: 0.5 + next(),
    phase: 2 * Math.PI * next(),
  }));
}

function shapeOf(kind: number, size: number): RigidShape {
  if (kind === 0) return { type: 'ball', radius: 1.2 * size };
  if (kind === 1) return { type: 'cuboid', halfExtents: [size, 1.5 * size, 0.7 * size] };
  if (kind === 2) return { type: 'capsule', halfHeight: 1.5 * size, radius: 0.6 * size };
  return { type: 'cylinder', halfHeight: size, radius: 0.9 * size };
}

/** Pose of a rigid after some seconds; at most 0.5 m/s and 1.5 rad/s. */
export function poseAt({ place: [x, y, z], pace, phase }: Swing, seconds: number): Pose {
  const angle = phase + pace * seconds;
  return {
    position: [x + 0.3 * Math.cos(angle), y + 0.2 * Math.sin(2 * angle), z + 0.3 * Math.sin(angle)],
    rotation: [Math.sin(angle / 2) * 0.6, Math.sin(angle / 2) * 0.8, 0, Math.cos(angle / 2)],
  };
}

/** Small particles distributed evenly in the box. */
export function seededSmoke(count: number, seed: number): Particles {
  const next = random(seed);
  const particles = emptyParticles(count);
  for (const axis of ['x', 'y', 'z'] as const) {
    for (let i = 0; i < count; i++) particles[axis][i] = (2 * next() - 1) * HALF_SIDE;
    particles[`p${axis}`].set(particles[axis]);
  }
  for (let i = 0; i < count; i++) particles.size[i] = 0.04 + 0.04 * next();
  particles.lifetime.fill(1000);
  particles.temperature.fill(0.4);
  return particles;
}
