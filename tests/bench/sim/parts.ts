/** Time of a step by part: the same cloud with more and more forces enabled, compared with the memory pass. */
import { figure, type Figure } from '../support/figures.ts';
import { ratios, slope } from '../support/statistics.ts';
import { SIX_FORCES } from './cloud.ts';
import type { Contestant } from './contestant.ts';
import { Memory } from './limits.ts';
import { Wasm } from './ours.ts';
import { interleave, type Costs, type Plan } from './rounds.ts';

const COUNT = 100_000;

const NO_TURBULENCE = { ...SIX_FORCES, 'turbulence.octaves': 0 };
const NO_VORTEX = { ...NO_TURBULENCE, 'vortices.0.circulation': 0 };
const STILL = {
  ...NO_VORTEX,
  'gravity.acceleration': 0,
  'buoyancy.acceleration': 0,
  'drag.rate': 0,
  'forces.wind.x': 0,
  'forces.wind.z': 0,
};

const OCTAVES = [1, 2, 3, 4];
const CASES: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  still: STILL,
  uniform: NO_VORTEX,
  smooth: NO_TURBULENCE,
  ...Object.fromEntries(
    OCTAVES.map((octaves) => [`octaves${octaves}`, { ...SIX_FORCES, 'turbulence.octaves': octaves }]),
  ),
};

export async function measureParts(quick: boolean): Promise<Figure[]> {
  const contestants: Contestant[] = [await Memory.create(COUNT)];
  for (const [name, forces] of Object.entries(CASES)) {
    const wasm = await Wasm.create(COUNT, forces);
    contestants.push({
      name,
      restart: () => wasm.restart(),
      advance: (steps) => wasm.advance(steps),
      dispose: () => wasm.dispose(),
    });
  }
  const plan: Plan = {
    rounds: quick ? 5 : 11,
    share: quick ? 40 : 120,
    warming: quick ? 100 : 300,
    slice: 4,
    cost: 'cheapest',
  };
  const counts = contestants.map(() => COUNT);
  const costs = await interleave(contestants, counts, plan, 'parts of a step');
  contestants.forEach((contestant) => contestant.dispose());
  return figures(costs);
}

function figures(costs: Costs): Figure[] {
  const octave = costs.memory.map((_, round) => slope(OCTAVES.map((octaves) => costs[`octaves${octaves}`][round])));
  const less = (more: string, fewer: string) => costs[more].map((cost, round) => cost - costs[fewer][round]);
  const unit = 'ns/particle';
  return [
    figure(
      'sim.vsMemory',
      'x',
      ratios(costs.smooth, costs.memory),
      'a step without turbulence, its other five forces on, through a pass that reads and writes the same columns; goal <= 3',
    ),
    figure(
      'sim.octave',
      'passes',
      ratios(octave, costs.memory),
      'memory passes for each octave, by least squares through steps with 1 to 4; goal <= 20',
    ),
    figure(
      'sim.vsMemory.noVortex',
      'x',
      ratios(costs.uniform, costs.memory),
      'the same without the vortex: gravity, buoyancy, drag and wind; information, as what follows',
    ),
    figure('sim.part.memory', unit, costs.memory, 'the memory pass'),
    figure('sim.part.life', unit, costs.still, 'a step without forces: following the slip, ageing, cooling, deaths'),
    figure('sim.part.uniform', unit, less('uniform', 'still'), 'gravity, buoyancy, drag and wind on top'),
    figure('sim.part.vortex', unit, less('smooth', 'uniform'), 'one vortex on top'),
    figure('sim.part.firstOctave', unit, less('octaves1', 'smooth'), 'one octave of evolving turbulence on top'),
    figure('sim.part.octave', unit, octave, 'each octave, by least squares'),
  ];
}
