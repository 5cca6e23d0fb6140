/** The smoke of all contestants, and its forces. */
import type { Particles } from '../support/snapshot.ts';
import { emptyParticles } from '../support/snapshot.ts';
import { random } from '../../visual/random.ts';

/** Six forces, one vortex, one octave of evolving turbulence; no emission, no rigids. */
export const SIX_FORCES = {
  'emission.rate': 0,
  'emission.growthTime': 0,
  'gravity.acceleration': 0.4,
  'buoyancy.acceleration': 1.5,
  'buoyancy.coolingTime': 4,
  'drag.rate': 1.5,
  'forces.wind.x': 0.5,
  'forces.wind.z': -0.2,
  'turbulence.speed': 0.6,
  'turbulence.scale': 1,
  'turbulence.octaves': 1,
  'turbulence.evolution': 0.3,
  'vortices.0.circulation': 6,
  'vortices.0.coreRadius': 0.8,
  'vortices.0.reach': 20,
  'vortices.0.position.x': 0.3,
  'vortices.0.axis.x': 0.2,
  'vortices.0.axis.y': 0.5,
  'vortices.0.axis.z': 1,
} as const;

const HALF_SIDE = 5;
/** Seconds. No particle expires during a measurement. */
const LIFETIME = 1000;

/** Seeded particles in a cube of 10 m, at rest relative to the air. */
export function seededCloud(count: number, seed: number): Particles {
  const next = random(seed);
  const particles = emptyParticles(count);
  for (const axis of ['x', 'y', 'z'] as const) {
    for (let i = 0; i < count; i++) particles[axis][i] = (2 * next() - 1) * HALF_SIDE;
    particles[`p${axis}`].set(particles[axis]);
  }
  for (let i = 0; i < count; i++) particles.temperature[i] = 0.5 + next();
  for (let i = 0; i < count; i++) particles.lifetime[i] = LIFETIME * (0.5 + next());
  for (let i = 0; i < count; i++) particles.attributes[i] = next() * 2 ** 32;
  particles.size.fill(0.2);
  return particles;
}
