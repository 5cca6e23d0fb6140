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
}

/** Between two readings of the clock: longer than its grain, short enough that others are met in the same state. */
const SLICE = 10;

/**
 * Lets all contestants advance by turns, in slices, with the order turned on from slice to slice, so that whatever else
 * the machine does meets all alike.
 *
 * @param counts How many particles each has, in the order of the contestants.
 */
export async function takeTurns(
  contestants: readonly Contestant[],
  counts: readonly number[],
  plan: Plan,
  title: string,
): Promise<Costs> {
  await say(`${title}, warming`);
  const paces = [];
  for (const contestant of contestants) paces.push(await warm(contestant, plan));
  const costs: Costs = Object.fromEntries(contestants.map(({ name }) => [name, []]));
  for (let round = 0; round < plan.rounds; round++) {
    await say(`${title}, round ${round + 1} of ${plan.rounds}`);
    const sums = await playRound(contestants, paces, round);
    contestants.forEach(({ name }, i) => costs[name].push((sums[i].milliseconds * 1e6) / (sums[i].steps * counts[i])));
  }
  return costs;
}

/** How a contestant spends its share: so many slices of so many steps. */
interface Pace {
  slices: number;
  steps: number;
}

/** Advances until the compilers have done their best, and finds out how much fits into a slice. */
async function warm(contestant: Contestant, { share, warming }: Plan): Promise<Pace> {
  await contestant.restart();
  let [steps, spent, last] = [1, 0, 0];
  while (spent < warming) {
    last = (await contestant.advance(steps)) / steps;
    spent += last * steps;
    steps = paceOf(last, SLICE);
  }
  await contestant.restart();
  return { steps: paceOf(last, SLICE), slices: Math.max(1, Math.round(share / Math.max(SLICE, last))) };
}

function paceOf(milliseconds: number, wanted: number): number {
  return Math.max(1, Math.round(wanted / Math.max(milliseconds, 1e-4)));
}

async function playRound(contestants: readonly Contestant[], paces: readonly Pace[], round: number) {
  const sums = contestants.map(() => ({ milliseconds: 0, steps: 0 }));
  for (const contestant of contestants) await contestant.restart();
  const longest = Math.max(...paces.map(({ slices }) => slices));
  for (let slice = 0; slice < longest; slice++) {
    for (let turn = 0; turn < contestants.length; turn++) {
      const i = (turn + slice + round) % contestants.length;
      if (slice >= paces[i].slices) continue;
      sums[i].milliseconds += await contestants[i].advance(paces[i].steps);
      sums[i].steps += paces[i].steps;
    }
  }
  return sums;
}
