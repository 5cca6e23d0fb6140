/** sim.vortexParticles: cost of 1,000 vortex particles in a step of 20,000 particles under the six forces. */
import { demand, figure, type Figure } from '../support/figures.ts';
import { ratios } from '../support/statistics.ts';
import { readParticles, sectionLength, withParticles } from '../support/snapshot.ts';
import { SIX_FORCES, seededCloud } from './cloud.ts';
import { meanDistance, type Contestant } from './contestant.ts';
import { Wasm } from './ours.ts';
import { interleave, type Plan } from './rounds.ts';

const COUNT = 20_000;
const VORTEX_PARTICLES = 1000;
const SHEDDING_STEPS = 30;
/** Per second. */
const RATE = (VORTEX_PARTICLES * 60) / SHEDDING_STEPS;
const FIRST_STEP = Math.floor(RATE / 60);

/**
 * They spawn in a ball of 5.5 m, which the cloud's cube mostly fills. Each has a reach of three cores, so a position is
 * within the reach of six of them on average.
 */
const SHEDDER = {
  'shedders.0.rate': RATE,
  'shedders.0.scatter': 5.5,
  'shedders.0.jitter': 1,
  'shedders.0.strength': 1,
  'shedders.0.perSpeed': 0,
  'shedders.0.coreRadius': 0.335,
  'shedders.0.viscosity': 0,
  'shedders.0.lifetime': 60,
};
const NO_MORE = { 'shedders.0.rate': 0 };

export async function measureVortexParticles(quick: boolean): Promise<Figure[]> {
  const without = await Wasm.create(COUNT);
  const withVortices = await Wasm.create(COUNT, { ...SIX_FORCES, ...SHEDDER });
  const start = shed(withVortices);
  const withThem: Contestant = {
    name: 'withVortices',
    restart: () => withVortices.simulator.restore(start),
    advance: (steps) => withVortices.advance(steps),
    dispose: () => withVortices.dispose(),
  };
  await requireMotion(without, withVortices, withThem);
  const plan: Plan = {
    rounds: quick ? 5 : 11,
    share: quick ? 60 : 150,
    warming: quick ? 200 : 400,
    slice: 10,
    cost: 'cheapest',
  };
  const costs = await interleave([without, withThem], [COUNT, COUNT], plan, 'vortex particles');
  demand(withVortices.simulator.alive === COUNT, `${withVortices.simulator.alive} of ${COUNT} particles live`);
  without.dispose();
  withThem.dispose();
  return [
    figure(
      'sim.vortexParticles',
      'x',
      ratios(costs.withVortices, costs.wasm),
      `a step of ${COUNT} particles, six forces, one octave, with ${VORTEX_PARTICLES} vortex particles through the step without; a place is within the reach of six; goal <= 6`,
    ),
  ];
}

/** Sheds exactly this number, and returns that state with the original cloud. */
function shed({ simulator }: Wasm): Uint8Array {
  const size = () => sectionLength(simulator, 'vort');
  const none = size();
  simulator.step();
  const each = (size() - none) / FIRST_STEP;
  simulator.step(SHEDDING_STEPS - 1);
  simulator.set(NO_MORE);
  const count = (size() - none) / each;
  demand(count === VORTEX_PARTICLES, `${count} vortex particles live`);
  return withParticles(simulator, seededCloud(COUNT, 3));
}

/** Requires an effect: vortex particles without one would also have no cost. */
async function requireMotion(without: Wasm, withVortices: Wasm, withThem: Contestant): Promise<void> {
  await withThem.restart();
  without.restart();
  demand(readParticles(withVortices.simulator).x.length === COUNT, 'the cloud has another size');
  without.advance(5);
  await withThem.advance(5);
  const apart = meanDistance(without.places(), withVortices.places());
  demand(apart > 0.01, `vortex particles move smoke by ${apart} m`);
}
