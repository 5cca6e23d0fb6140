/** Measures contestants in turns. */
import { say } from '../support/figures.ts';
import type { Contestant } from './contestant.ts';

/** Nanoseconds per particle and step, for each round, by contestant name. */
export type Costs = Record<string, number[]>;

export interface Plan {
  rounds: number;
  /** Milliseconds per contestant in a round, and in the warm-up before; at least one step. */
  share: number;
  warming: number;
  /**
   * Milliseconds between two readings of the clock: longer than its resolution, short enough that load on the machine
   * affects all contestants alike.
   */
  slice: number;
  /**
   * Cost of a round: the mean of its slices, or the cheapest one, because other processes only slow slices down. The
   * latter is only fair for slices of the same duration, so not for contestants whose single step is longer than a
   * slice.
   */
  cost: 'mean' | 'cheapest';
}

/** Milliseconds: less than any step takes, but not zero, which the clock may return. */
const SHORTEST_STEP = 1e-4;

/**
 * Advances all contestants in turns, in slices, with a rotating order, so that load on the machine affects all alike.
 *
 * @param counts Number of particles of each contestant, in the same order.
 */
export async function interleave(
  contestants: readonly Contestant[],
  counts: readonly number[],
  plan: Plan,
  title: string,
): Promise<Costs> {
  await say(`${title}, warming`);
  const paces: Pace[] = [];
  for (const contestant of contestants) paces.push(await warm(contestant, plan));
  const costs: Costs = Object.fromEntries(contestants.map(({ name }) => [name, []]));
  for (let round = 0; round < plan.rounds; round++) {
    await say(`${title}, round ${round + 1} of ${plan.rounds}`);
    const slices = await playRound(contestants, paces, round);
    contestants.forEach(({ name }, i) => {
      costs[name].push((costOf(slices[i], plan) * 1e6) / (paces[i].steps * counts[i]));
    });
  }
  return costs;
}

function costOf(slices: readonly number[], { cost }: Plan): number {
  return cost === 'mean' ? slices.reduce((sum, slice) => sum + slice, 0) / slices.length : Math.min(...slices);
}

/** How a contestant divides its share: number of slices, and steps per slice. */
interface Pace {
  slices: number;
  steps: number;
}

/** Advances until the JIT compilers have optimized the code, and determines the steps per slice. */
async function warm(contestant: Contestant, { share, warming, slice }: Plan): Promise<Pace> {
  await contestant.restart();
  let [steps, spent, last] = [1, 0, 0];
  while (spent < warming) {
    last = (await contestant.advance(steps)) / steps;
    spent += last * steps;
    steps = Math.max(1, Math.round(slice / Math.max(last, SHORTEST_STEP)));
  }
  return { steps, slices: Math.max(1, Math.round(share / Math.max(slice, last))) };
}

/** Milliseconds of each slice, by contestant. */
async function playRound(contestants: readonly Contestant[], paces: readonly Pace[], round: number) {
  const taken: number[][] = contestants.map(() => []);
  for (const contestant of contestants) await contestant.restart();
  const longest = Math.max(...paces.map(({ slices }) => slices));
  for (let slice = 0; slice < longest; slice++) {
    for (let position = 0; position < contestants.length; position++) {
      const i = (position + slice + round) % contestants.length;
      if (slice < paces[i].slices) taken[i].push(await contestants[i].advance(paces[i].steps));
    }
  }
  return taken;
}
