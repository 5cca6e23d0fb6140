/** sim.vsJavaScript: a step of many particles in JavaScript, divided by the same step in our WASM. */
import { loadSimulators } from '../../../src/sim/load.ts';
import type { Simulator } from '../../../src/sim/simulator.ts';
import { demand, figure, say, time, type Figure } from '../support/figures.ts';
import { readMemory, readParticles, withParticles } from '../support/snapshot.ts';
import { SIX_FORCES, seededCloud } from './cloud.ts';
import { largestDifference, TwinSimulator } from './twin.ts';

const COUNT = 100_000;
/** Metres, and what else a particle has: single precision at 5 m over the steps that are compared. */
const TOLERANCE = 1e-4;
const LEAST_MOVE = 0.1;
const COMPARED_STEPS = 20;
/** Enough for both engines to have compiled the loops as well as they can. */
const WARMING_STEPS = 40;

/** Both sides, which start each round from the same particles. */
interface Pair {
  simulator: Simulator;
  twin: TwinSimulator;
  restart(): void;
}

export async function measureAgainstJavaScript(quick: boolean): Promise<Figure[]> {
  const rounds = quick ? 5 : 15;
  const steps = quick ? 12 : 40;
  const pair = await makePair(COUNT);
  const difference = compare(pair);
  alternate(pair, WARMING_STEPS);
  const ours: number[] = [];
  const theirs: number[] = [];
  for (let round = 0; round < rounds; round++) {
    await say(`sim.vsJavaScript, round ${round + 1} of ${rounds}`);
    pair.restart();
    const [wasm, javaScript] = alternate(pair, steps);
    ours.push(wasm);
    theirs.push(javaScript);
  }
  pair.simulator.dispose();
  const work = `${COUNT} particles, six forces, one vortex, one octave of evolving turbulence`;
  return [
    figure(
      'sim.vsJavaScript',
      'x',
      theirs.map((javaScript, round) => javaScript / ours[round]),
      `${work}; after ${COMPARED_STEPS} steps the two differ by ${difference.toExponential(1)} m at most; target >= 4`,
    ),
    figure('sim.wasm', 'ms', ours, `one step of it in WASM; information`),
    figure('sim.javaScript', 'ms', theirs, 'one step of it in JavaScript'),
  ];
}

/** Plain times of our step by number of particles: information, since they say more of the machine than of the code. */
export async function measureSteps(quick: boolean): Promise<Figure[]> {
  const figures = [];
  for (const [count, name] of [
    [1_000, 'sim.step.1000'],
    [10_000, 'sim.step.10000'],
    [100_000, 'sim.step.100000'],
  ] as const) {
    await say(name);
    const { simulator, restart } = await makePair(count);
    const steps = Math.max(4, (quick ? 200_000 : 1_000_000) / count);
    const rounds = Array.from({ length: 5 }, () => {
      restart();
      return time(() => simulator.step(steps)) / steps;
    });
    simulator.dispose();
    figures.push(figure(name, 'ms', rounds, 'the same forces; information'));
  }
  return figures;
}

async function makePair(count: number): Promise<Pair> {
  const factory = await loadSimulators({ physics: false });
  const simulator = factory.create({ capacity: count, seed: 7 });
  simulator.set(SIX_FORCES);
  const start = withParticles(simulator.save(), seededCloud(count, 3));
  const memory = readMemory(start);
  const pair: Pair = {
    simulator,
    twin: new TwinSimulator(SIX_FORCES, memory, readParticles(start)),
    restart() {
      simulator.restore(start);
      pair.twin = new TwinSimulator(SIX_FORCES, memory, readParticles(start));
    },
  };
  pair.restart();
  return pair;
}

/** The largest difference after some steps; throws when it is not the same motion, or none at all. */
function compare(pair: Pair): number {
  const before = readParticles(pair.simulator.save());
  alternate(pair, COMPARED_STEPS);
  const after = readParticles(pair.simulator.save());
  const difference = largestDifference(after, pair.twin.particles);
  demand(difference < TOLERANCE, `WASM and JavaScript differ by ${difference}`);
  demand(pair.twin.alive === after.x.length, 'different numbers of particles live');
  const moved = largestDifference(after, before);
  demand(moved > LEAST_MOVE, `nothing moved farther than ${moved} m`);
  return difference;
}

/**
 * Milliseconds a step of each. They take turns step by step, so that whatever else the machine does meets both alike,
 * and change places, so that neither always finds the caches as the other left them.
 */
function alternate({ simulator, twin }: Pair, steps: number): [ours: number, theirs: number] {
  const ours = () => time(() => simulator.step());
  const theirs = () => time(() => twin.step());
  let [wasm, javaScript] = [0, 0];
  for (let step = 0; step < steps; step++) {
    if (step % 2 === 0) wasm += ours();
    javaScript += theirs();
    if (step % 2 === 1) wasm += ours();
  }
  return [wasm / steps, javaScript / steps];
}
