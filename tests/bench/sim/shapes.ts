/** sim.shapes: cost of a shape of 2,000 puffs, relative to a step of 10,000 particles. */
import { loadMeshes } from '../../../src/simulator/meshes.ts';
import { demand, figure, type Figure } from '../support/figures.ts';
import { SIX_FORCES, seededCloud } from './cloud.ts';
import { meanDistance } from './contestant.ts';
import { Wasm } from './ours.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { interleave, type Plan } from './rounds.ts';

const [PUFFS, MANY] = [2_000, 10_000];
const GOAL = 0.1;

/** The word TEA over the cloud. */
const SHAPE = simulatorValues({
  'shapes.0.outline': 'AJU5g4g5gg4Hgg1g2g1IggLgKgLHg.GJU9g9gg2PgOggr8gg2Eggrygxgg2DgDg.MhU6gp9q-p9IgcRGgcvIg.NVqkwkwQg',
  'shapes.0.speed': 2,
  'shapes.0.size': 8,
  'shapes.0.depth': 0.5,
});

export async function measureShapes(quick: boolean): Promise<Figure[]> {
  const factory = await loadMeshes();
  const contestant = (name: string, count: number, values: Readonly<Record<string, number>>) =>
    Wasm.of(factory, name, seededCloud(count, 3), { ...SIX_FORCES, ...values });
  const many = contestant('many', MANY, {});
  const without = contestant('without', PUFFS, {});
  const shaped = contestant('shaped', PUFFS, SHAPE);
  for (const each of [without, shaped]) {
    each.restart();
    each.advance(5);
  }
  const apart = meanDistance(without.places(), shaped.places());
  demand(apart > 0.02, `the shape moves smoke by ${apart} m`);
  const plan: Plan = {
    rounds: quick ? 5 : 11,
    share: quick ? 60 : 150,
    warming: quick ? 200 : 400,
    slice: 5,
    cost: 'cheapest',
  };
  const contestants = [many, without, shaped];
  const costs = await interleave(contestants, [MANY, PUFFS, PUFFS], plan, 'shapes');
  for (const each of contestants) each.dispose();
  const milliseconds = (name: string, count: number) => costs[name].map((cost) => (cost * count) / 1e6);
  const step = milliseconds('many', MANY);
  const [less, more] = [milliseconds('without', PUFFS), milliseconds('shaped', PUFFS)];
  const added = more.map((cost, round) => cost - less[round]);
  const what = `what a shape of ${PUFFS} puffs adds to a step, six forces, one octave`;
  return [
    figure('sim.shapes', 'x', added.map((cost, round) => cost / step[round]), `${what}, through a step of ${MANY}; goal <= ${GOAL}`), // prettier-ignore
    figure('sim.shapes.ms', 'ms', added, `${what}; a step of ${MANY} takes ${step[0].toFixed(3)} ms`),
  ];
}
