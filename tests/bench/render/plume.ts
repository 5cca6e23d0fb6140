/** The smoke of the render suite: seeded and independent of the demo's scenes, so that results stay comparable. */
import { emptyParticles, type Particles } from '../support/snapshot.ts';
import { random } from '../../visual/random.ts';

/**
 * Lifetime of the plume's particles, seconds. The last tenth is not drawn, because the puffs are almost transparent
 * there.
 */
const LIFETIME = 6;
const OLDEST = 0.9;
const VARIATIONS = 4;

/**
 * A column of smoke that rises from the origin to 3.7 m, widens and drifts 4.5 m to the right, out of the view of a
 * camera at its lower part. Requires `emission.growthTime` 0 and the paper's integrator.
 */
export function seededPlume(count: number, seed: number): Particles {
  const next = random(seed);
  const ownNumber = random(seed + 1);
  const particles = emptyParticles(count);
  for (let i = 0; i < count; i++) {
    const age = OLDEST * next();
    const reach = (0.06 + 0.75 * age) * Math.sqrt(next());
    const angle = 2 * Math.PI * next();
    particles.x[i] = 0.1 + 5.5 * age * age + reach * Math.cos(angle);
    particles.y[i] = 0.2 + 3.8 * age ** 0.8 + 0.3 * (next() - 0.5);
    particles.z[i] = reach * Math.sin(angle);
    particles.age[i] = age * LIFETIME;
    particles.size[i] = (0.06 + 0.36 * age) * (0.7 + 0.6 * next());
    const attributes = Math.floor(VARIATIONS * next()) + 2 ** 16 * Math.floor(2 ** 12 * next());
    particles.attributes[i] = attributes + 2 ** 8 * Math.floor(2 ** 8 * ownNumber());
  }
  for (const axis of ['x', 'y', 'z'] as const) particles[`p${axis}`].set(particles[axis]);
  particles.lifetime.fill(LIFETIME);
  return particles;
}

/** Radius, height and position of the column, and the mean radius of its puffs; metres. */
const COLUMN = { radius: 0.55, height: 3.4, x: -1.3, size: 0.2 };

/**
 * A column so dense that additional puffs are almost invisible: upright in front of the benchmark's camera, with the
 * same distribution of puffs at all heights.
 */
export function saturatedColumn(count: number, seed: number): Particles {
  const next = random(seed);
  const particles = emptyParticles(count);
  for (let i = 0; i < count; i++) {
    const reach = COLUMN.radius * Math.sqrt(next());
    const angle = 2 * Math.PI * next();
    particles.x[i] = COLUMN.x + reach * Math.cos(angle);
    particles.y[i] = 0.1 + COLUMN.height * next();
    particles.z[i] = reach * Math.sin(angle);
    particles.size[i] = COLUMN.size * (0.7 + 0.6 * next());
    const attributes = Math.floor(VARIATIONS * next()) + 2 ** 16 * Math.floor(2 ** 12 * next());
    particles.attributes[i] = attributes + 2 ** 8 * Math.floor(2 ** 8 * next());
  }
  for (const axis of ['x', 'y', 'z'] as const) particles[`p${axis}`].set(particles[axis]);
  particles.lifetime.fill(LIFETIME);
  return particles;
}
