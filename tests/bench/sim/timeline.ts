/** sim.timeline: cost of a timeline of 200 keyframes in a step of the default preset. */
import type { Values } from '../../../src/parameters/parameter.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { writeTimeline } from '../../../src/parameters/timeline.ts';
import { fetchTimelineText } from '../../../src/renderer/extraPasses.ts';
import { lamp } from '../../../src/scenes/lamp.ts';
import { loadSimulators } from '../../../src/simulator/load.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { demand, figure, time, type Figure } from '../support/figures.ts';
import { ratios } from '../support/statistics.ts';
import type { Contestant } from './contestant.ts';
import { interleave, type Plan } from './rounds.ts';

/** The smoke has filled its column. */
const FIRST_STEPS = 240;
const KEYFRAMES = 10;
const BETWEEN = 37;

/** Half of the lanes are of the simulator and move in each step; the others are of the picture. */
const KEYS = [
  'emission.rate',
  'emission.lifetime',
  'puff.size',
  'turbulence.speed',
  'turbulence.scale',
  'forces.buoyancy',
  'forces.turbulence',
  'forces.drag',
  'forces.wind.x',
  'forces.wind.z',
  'style.outlineWidth',
  'style.fill',
  'style.rim',
  'style.wash',
  'style.inkLight',
  'light.azimuth',
  'light.elevation',
  'light.intensity',
  'camera.azimuth',
  'camera.distance',
] as const;

/** Keyframes at which a value goes up and down by a hundredth, eased by a Bezier curve. */
function timelineOf(values: Values): string {
  const lanes = KEYS.map((key) => ({
    key,
    keyframes: Array.from({ length: KEYFRAMES }, (_, index) => ({
      step: BETWEEN * index,
      value: (values[key] ?? 1) * (1 + (index % 2) / 100),
      easing: 'ease' as const,
    })),
  }));
  return writeTimeline({ length: BETWEEN * KEYFRAMES, loops: true, lanes, bursts: [] });
}

export async function measureTimeline(quick: boolean): Promise<Figure[]> {
  const values = presetValues(findPreset('lamp')!);
  const factory = await loadSimulators({ physics: true });
  const { timeline } = await fetchTimelineText({ timeline: timelineOf(values) });
  const contestantOf = (name: string, simulation: Simulation): Contestant => ({
    name,
    restart: () => {
      simulation.restart({ ...values, timeline: simulation.startValues.timeline });
      simulation.advance(FIRST_STEPS);
    },
    advance: (steps) => time(() => simulation.advance(steps)),
    dispose: () => simulation.dispose(),
  });
  const plain = new Simulation(factory, lamp(), values, 0);
  const played = new Simulation(factory, lamp(), { ...values, timeline }, 0);
  const contestants = [contestantOf('plain', plain), contestantOf('played', played)];
  for (const contestant of contestants) await contestant.restart();
  const [alive, own] = [plain, played].map(({ simulator }) => simulator.alive);
  demand(plain.simulator.hash() !== played.simulator.hash(), 'the timeline moves nothing');
  demand(Math.abs(own / alive - 1) < 0.02, `${own} particles live instead of ${alive}`);
  const plan: Plan = {
    rounds: quick ? 7 : 15,
    share: quick ? 80 : 200,
    warming: quick ? 200 : 400,
    slice: 8,
    cost: 'cheapest',
  };
  const costs = await interleave(contestants, [alive, own], plan, 'timeline');
  contestants.forEach((contestant) => contestant.dispose());
  return [
    figure(
      'sim.timeline',
      'x',
      ratios(costs.played, costs.plain),
      `a step of the lamp, ${alive} particles, with ${KEYS.length * KEYFRAMES} keyframes in ${KEYS.length} lanes through the step without; half of the lanes are of the simulator and move in each step; goal <= 1.05`,
    ),
  ];
}
