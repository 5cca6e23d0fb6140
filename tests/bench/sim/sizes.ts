/** sim.linear: whether the cost per particle is independent of their number. */
import { figure, type Figure } from '../support/figures.ts';
import { median, spread } from '../support/statistics.ts';
import type { Contestant } from './contestant.ts';
import { Wasm } from './ours.ts';
import { interleave, type Plan } from './rounds.ts';

const SIZES = [10_000, 30_000, 100_000, 300_000, 1_000_000];

/** Milliseconds of a step with the most particles, so that all slices have the same duration. */
const LONGEST_STEP = 50;

export async function measureSizes(quick: boolean): Promise<Figure[]> {
  const contestants: Contestant[] = [];
  for (const size of SIZES) {
    const wasm = await Wasm.create(size);
    contestants.push({
      name: String(size),
      restart: () => wasm.restart(),
      advance: (steps) => wasm.advance(steps),
      dispose: () => wasm.dispose(),
    });
  }
  const plan: Plan = {
    rounds: quick ? 5 : 9,
    share: quick ? 4 * LONGEST_STEP : 6 * LONGEST_STEP,
    warming: quick ? 100 : 300,
    slice: LONGEST_STEP,
    cost: 'cheapest',
  };
  const costs = await interleave(contestants, SIZES, plan, 'sizes');
  contestants.forEach((contestant) => contestant.dispose());
  const rounds = Array.from({ length: plan.rounds }, (_, round) => spread(SIZES.map((size) => costs[size][round])));
  const list = SIZES.map((size) => `${size}: ${median(costs[size]).toFixed(1)}`).join(', ');
  return [
    figure(
      'sim.linear',
      'x',
      rounds,
      `dearest through cheapest of each round, six forces, ns a particle by number of particles: ${list}; goal <= 1.2`,
    ),
  ];
}
