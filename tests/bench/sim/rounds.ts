/** Contestants measured by turns. */
import { say } from '../support/figures.ts';
import type { Contestant } from './contestant.ts';

/** Nanoseconds for a particle and a step, of each round, by the contestant's name. */
export type Costs = Record<string, number[]>;

export interface Plan {
  rounds: number;
  /** Milliseconds that each contestant is to take in a round, and before the first; one step is the least. */
  share: number;
  warming: number;
  /**
   * Milliseconds between two readings of the clock: longer than its grain, short enough that others are met in the
   * same state.
   */
  slice: number;
  /**
   * What a round costs: the mean of its slices, or the cheapest of them, since others on the machine only ever slow
   * down. The latter is fair only among slices of one length, so to none whose single step takes longer than a slice.
   */
  cost: 'mean' | 'cheapest';
}

/** Milliseconds; less than any step takes, but not nothing, as the clock may say. */
const SHORTEST_STEP = 1e-4;

/**
 * Lets all contestants advance by turns, in slices, with the order turned on from slice to slice, so that whatever else
 * the machine does meets all alike.
 *
 * @param counts How many particles each has, in the order of the contestants.
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

/** How a contestant spends its share: so many slices of so many steps. */
interface Pace {
  slices: number;
  steps: number;
}

/** Advances until the compilers have done their best, and finds out how much fits into a slice. */
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
