/** sim.flow: what a flow adds to a step of 20,000 particles, relative to what a vortex adds. */
import { loadMeshes } from '../../../src/simulator/meshes.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { random } from '../../visual/random.ts';
import { demand, figure, type Figure } from '../support/figures.ts';
import { ratios } from '../support/statistics.ts';
import { seededCloud } from './cloud.ts';
import { Wasm } from './ours.ts';
import { interleave, type Plan } from './rounds.ts';

const COUNT = 20_000;
const GOAL = 1.3;

/** Drag only. What is at rest then stays there. */
const STILL = {
  'emission.rate': 0,
  'emission.growthTime': 0,
  'buoyancy.acceleration': 0,
  'turbulence.octaves': 0,
  'drag.rate': 1.5,
};
const VORTEX = { 'vortices.0.circulation': 2, 'vortices.0.reach': 20 };
/** A closed stroke of six points, so that smoke stays in it. */
const POINTS = [
  [4, 0, 0],
  [2, 3, 1],
  [-2, 3, -1],
  [-4, 0, 0],
  [-2, -3, 1],
  [2, -3, -1],
];
const FLOW = simulatorValues({
  'flows.0.points': POINTS.map((point) => point.join(':')).join(),
  'flows.0.closed': 'ring',
  'flows.0.speed': 1,
  'flows.0.inflow': 0.3,
  'flows.0.radius': 1.5,
});
const SWIRL = { 'flows.0.swirl': 1 };
const ELSEWHERE = { 'flows.0.position.x': 1000 };

/** The seeded cloud at random places along the stroke, up to 0.6 m away along each axis. */
function cloudInFlow() {
  const particles = seededCloud(COUNT, 3);
  const next = random(5);
  for (let i = 0; i < COUNT; i++) {
    const at = next() * POINTS.length;
    const [from, to] = [POINTS[Math.floor(at)], POINTS[Math.ceil(at) % POINTS.length]];
    (['x', 'y', 'z'] as const).forEach((axis, part) => {
      particles[axis][i] = from[part] + (at % 1) * (to[part] - from[part]) + 1.2 * next() - 0.6;
    });
  }
  for (const axis of ['x', 'y', 'z'] as const) particles[`p${axis}`].set(particles[axis]);
  return particles;
}

export async function measureFlows(quick: boolean): Promise<Figure[]> {
  const factory = await loadMeshes();
  const cloud = cloudInFlow();
  const contestant = (name: string, values: Readonly<Record<string, number>>) =>
    Wasm.of(factory, name, cloud, { ...STILL, ...values });
  const contestants = [
    contestant('without', {}),
    contestant('vortex', VORTEX),
    contestant('flow', FLOW),
    contestant('swirl', { ...FLOW, ...SWIRL }),
    contestant('outside', { ...FLOW, ...ELSEWHERE }),
  ];
  const plan: Plan = {
    rounds: quick ? 5 : 11,
    share: quick ? 200 : 400,
    warming: quick ? 200 : 400,
    slice: 5,
    cost: 'cheapest',
  };
  const counts = contestants.map(() => COUNT);
  const costs = await interleave(contestants, counts, plan, 'flows');
  for (const each of contestants) requireMotion(each, ['vortex', 'flow', 'swirl'].includes(each.name) ? 0.99 : 0);
  for (const each of contestants) each.dispose();
  const added = (name: string) => costs[name].map((cost, round) => cost - costs.without[round]);
  const what = (smoke: string) => `what a flow of ${POINTS.length} points ${smoke} adds to a step of ${COUNT} particles, through what a vortex adds`; // prettier-ignore
  const over = (name: string) => ratios(added(name), added('vortex'));
  return [
    figure('sim.flow', 'x', over('flow'), `${what('with speed and inflow, all smoke in it,')}; goal <= ${GOAL}`),
    figure('sim.flow.swirl', 'x', over('swirl'), `${what('with speed, inflow and swirl, all smoke in it,')}; information`), // prettier-ignore
    figure('sim.flow.outside', 'x', over('outside'), `${what('that no smoke is in')}; information`),
  ];
}

/** Requires that at least this share of the particles moves, or that none does. */
function requireMotion(contestant: Wasm, share: number): void {
  const before = contestant.places();
  contestant.advance(1);
  const after = contestant.places();
  let moving = 0;
  for (let i = 0; i < before.length; i += 3) {
    if ([0, 1, 2].some((axis) => after[i + axis] !== before[i + axis])) moving++;
  }
  demand(
    share > 0 ? moving >= share * COUNT : moving === 0,
    `${moving} of ${COUNT} particles move in ${contestant.name}`,
  );
}
