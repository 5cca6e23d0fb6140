/**
 * collide.near, .far, .vsNaive and .rigids1 to .rigids1000: cost of collisions, compared with Rapier's queries in the
 * same WASM.
 */
import { demand, figure, say, type Figure } from '../../support/figures.ts';
import { median, ratios } from '../../support/statistics.ts';
import { compareWork } from './check.ts';
import { loadMeasured } from './module.ts';
import { COUNT, Scene } from './scene.ts';
import { RIGIDS } from './obstacles.ts';

/** Metres. No particle is larger, so one whose centre is farther away from all rigids overlaps none. */
const LIMIT = 0.08;
const EVERYWHERE = 1e30;
const CROWDS = [1, 10, 100, 1000];

/** Milliseconds of a round's fastest step: all steps do the same work, and other processes only make them slower. */
interface Round {
  near: number;
  withFar: number;
  touched: number;
  naive: number;
}

export async function measureCollisions(quick: boolean): Promise<Figure[]> {
  const make = await loadMeasured();
  const [near, withFar] = [new Scene(make, RIGIDS), new Scene(make, RIGIDS, true)];
  const work = compareWork(make, LIMIT);
  const tenths = tenthsOf(COUNT);
  const rounds: Round[] = [];
  const [wanted, steps] = quick ? [5, 15] : [9, 40];
  // The first round is a warm-up.
  for (let round = 0; round <= wanted; round++) {
    await say(`collisions among ${RIGIDS} rigids, round ${round} of ${wanted}`);
    const result = playRound(near, withFar, tenths, steps);
    if (round > 0) rounds.push(result);
  }
  near.dispose();
  withFar.dispose();
  const of = (name: keyof Round) => rounds.map((round) => round[name]);
  const cost = `${COUNT} particles among ${RIGIDS} moving rigids, all of a step's collisions but Rapier's own step`;
  return [
    figure(
      'collide.near',
      'x',
      ratios(of('near'), of('touched')),
      `${cost}, against project_point in the same WASM for only the ${work.asked} whose box touches a rigid's, up to ` +
        `${LIMIT} m; ${work.overlapping} overlap, ${work.pushed} were pushed; goal <= 1.5`,
    ),
    figure(
      'collide.far',
      'x',
      ratios(of('withFar'), of('near')),
      `${cost}, with ${COUNT} more particles far away against without; those near move alike to the bit; goal <= 1.1`,
    ),
    figure(
      'collide.vsNaive',
      'x',
      ratios(of('naive'), of('near')),
      `project_point in the same WASM for each particle, unlimited, against ${cost}; goal >= 3`,
    ),
    ...(await measureCrowds(make, quick)),
  ];
}

/**
 * All numbers below `count` in ten lists: a run with all queries is so long that other processes always interrupt it.
 */
function tenthsOf(count: number): Uint32Array[] {
  const size = count / 10;
  return Array.from({ length: 10 }, (_, tenth) => Uint32Array.from({ length: size }, (__, i) => tenth * size + i));
}

function playRound(near: Scene, withFar: Scene, tenths: readonly Uint32Array[], steps: number): Round {
  near.restart();
  withFar.restart();
  const { rapier } = near.measured;
  const min: Round = { near: Infinity, withFar: Infinity, touched: Infinity, naive: 0 };
  const minOfTenths = tenths.map(() => Infinity);
  for (let step = 0; step < steps; step++) {
    const scenes = step % 2 === 0 ? [near, withFar] : [withFar, near];
    const costs = new Map(scenes.map((scene) => [scene, scene.step().collision]));
    min.near = Math.min(min.near, costs.get(near) ?? Infinity);
    min.withFar = Math.min(min.withFar, costs.get(withFar) ?? Infinity);
    min.touched = Math.min(min.touched, rapier.projectionTime(rapier.findInTouchedBoxes(), LIMIT));
    tenths.forEach((asked, tenth) => {
      minOfTenths[tenth] = Math.min(minOfTenths[tenth], rapier.projectionTime(asked, EVERYWHERE));
    });
  }
  requireAlike(near, withFar);
  return { ...min, naive: minOfTenths.reduce((sum, cost) => sum + cost, 0) };
}

function requireAlike(near: Scene, withFar: Scene): void {
  const [one, other] = [near.particles, withFar.particles];
  for (const axis of ['x', 'y', 'z'] as const) {
    const alike = one[axis].every((value, i) => value === other[axis][i]);
    demand(alike && other[axis].length === 2 * COUNT, `${axis} of the particles near differs with others far away`);
  }
}

async function measureCrowds(make: Awaited<ReturnType<typeof loadMeasured>>, quick: boolean): Promise<Figure[]> {
  const figures: Figure[] = [];
  for (const rigids of CROWDS) {
    await say(`collisions among ${rigids} rigids`);
    const scene = new Scene(make, rigids);
    const steps = quick ? 10 : 30;
    const costs: number[] = [];
    const worlds: number[] = [];
    for (let round = 0; round < (quick ? 5 : 9); round++) {
      scene.restart();
      const parts = Array.from({ length: steps }, () => scene.step());
      costs.push(Math.min(...parts.map(({ collision }) => collision)));
      worlds.push(Math.min(...parts.map(({ world }) => world)));
    }
    scene.dispose();
    const note = `${COUNT} particles, rigids that fill as much as ${RIGIDS} do; a step without Rapier's own, which takes ${median(worlds).toFixed(3)} ms`;
    figures.push(figure(`collide.rigids${rigids}`, 'ms', costs, note));
  }
  return figures;
}
