/** The contest for four numbers of particles, and the resulting ratios. */
import { figure, type Figure } from '../support/figures.ts';
import { ratios } from '../support/statistics.ts';
import { compareQuarks, hold } from './contest.ts';
import type { Costs, Plan } from './rounds.ts';

const JUDGED = 100_000;
const SIZES = [1_000, 10_000, JUDGED, 1_000_000];

/** Descriptions of the measured work. */
const CONTESTANTS: Readonly<Record<string, string>> = {
  wasm: 'step() of this simulator in WASM',
  native: 'the same crate natively, with SSE4.1 and without FMA as in WASM; ends in the same fingerprint',
  memory: 'a pass in WASM that reads and writes the columns that a step reads and writes',
  nativeMemory: 'the same pass natively',
  quarks: "three.quarks' update of a system with six behaviours, no renderer",
};

/** Differences between the behaviours of three.quarks and ours. */
const UNEQUAL = 'its turbulence has divergence, its vortex turns all at one rate, its buoyancy does not cool';

export async function measureAgainstOthers(quick: boolean): Promise<Figure[]> {
  const figures: Figure[] = [];
  const way = await compareQuarks();
  for (const size of SIZES) {
    const costs = await hold(size, planFor(size, quick));
    if (size === JUDGED) figures.unshift(...judge(costs, way));
    for (const [name, note] of Object.entries(CONTESTANTS)) {
      figures.push(figure(`sim.cost.${name}.${size}`, 'ns/particle', costs[name], note));
    }
  }
  return figures;
}

function planFor(size: number, quick: boolean): Plan {
  const rounds = quick || size === SIZES[3] ? 5 : 9;
  return { rounds, share: quick ? 30 : 100, warming: quick ? 300 : 600, slice: 10, cost: 'mean' };
}

function judge(costs: Costs, way: number): Figure[] {
  const work = `${JUDGED} particles, six forces, one octave`;
  const quarks = `${CONTESTANTS.quarks}, through ours; ${UNEQUAL}, its particles go ${way.toPrecision(2)} times as far`;
  return [
    figure('sim.vsQuarks', 'x', ratios(costs.quarks, costs.wasm), `${work}; ${quarks}; goal >= 20`),
    figure('sim.vsNative', 'x', ratios(costs.wasm, costs.native), `${work}; ${CONTESTANTS.native}; goal <= 1.6`),
  ];
}
