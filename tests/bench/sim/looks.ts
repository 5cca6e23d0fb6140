/** sim.looks: cost of looks of emitters in a step of 20,000 particles under the six forces. */
import { loadSimulators } from '../../../src/simulator/load.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { demand, figure, time, type Figure } from '../support/figures.ts';
import { ratios } from '../support/statistics.ts';
import { SIX_FORCES } from './cloud.ts';
import type { Contestant } from './contestant.ts';
import { interleave, type Plan } from './rounds.ts';

const COUNT = 20_000;
const EMITTERS = 8;
/** Each emits in each of these steps, so that particles of all looks are next to each other. */
const EMITTING_STEPS = 60;
const SEED = 7;

/** The look of an emitter; without a number it has none. */
function lookOf(emitter: number, number: number | undefined): Record<string, number> {
  const key = `emitters.${emitter}`;
  const place = { [`${key}.position.x`]: emitter - 4, [`${key}.lifetime`]: 20, [`${key}.lifetimeVariation`]: 0 };
  if (number === undefined) return place;
  return {
    ...place,
    [`${key}.look.drag`]: 0.5 + 0.2 * number,
    [`${key}.look.buoyancy`]: 1.2 - 0.1 * number,
    [`${key}.look.gravity`]: 0.3 * number,
    [`${key}.look.growthTime`]: 1 + number,
  };
}

/** Advances from the state after the births. */
class Looks implements Contestant {
  readonly name: string;
  readonly #simulator: Simulator;
  readonly #start: Uint8Array;

  private constructor(name: string, simulator: Simulator) {
    this.name = name;
    this.#simulator = simulator;
    this.#start = simulator.save();
  }

  static async create(name: string, looks: number): Promise<Looks> {
    const factory = await loadSimulators({ physics: false });
    const simulator = factory.create({ capacity: COUNT, seed: SEED });
    simulator.set({ ...SIX_FORCES, 'emission.lifetime': 60, 'emission.rate': (COUNT * 60) / EMITTING_STEPS });
    for (let emitter = 0; emitter < EMITTERS; emitter++)
      simulator.set(lookOf(emitter, looks ? emitter % looks : undefined));
    simulator.step(EMITTING_STEPS);
    simulator.set({ 'emission.rate': 0 });
    demand(simulator.alive === COUNT, `${simulator.alive} of ${COUNT} particles live`);
    demand(simulator.hasLooks === looks > 0, `${looks} looks were asked for`);
    return new Looks(name, simulator);
  }

  restart(): void {
    this.#simulator.restore(this.#start);
  }

  advance(steps: number): number {
    return time(() => this.#simulator.step(steps));
  }

  hash(): string {
    return this.#simulator.hash();
  }

  dispose(): void {
    this.#simulator.dispose();
  }
}

export async function measureLooks(quick: boolean): Promise<Figure[]> {
  const contestants = [
    await Looks.create('none', 0),
    await Looks.create('one', 1),
    await Looks.create('eight', EMITTERS),
  ];
  const hashes = contestants.map((contestant) => contestant.hash());
  demand(new Set(hashes).size === contestants.length, 'looks have no effect');
  const plan: Plan = {
    rounds: quick ? 5 : 11,
    share: quick ? 60 : 150,
    warming: quick ? 200 : 400,
    slice: 10,
    cost: 'cheapest',
  };
  const counts = contestants.map(() => COUNT);
  const costs = await interleave(contestants, counts, plan, 'looks');
  contestants.forEach((contestant) => contestant.dispose());
  return [
    figure(
      'sim.looks.eight',
      'x',
      ratios(costs.eight, costs.one),
      `a step of ${COUNT} particles of eight looks, six forces, through the same step with one look; goal <= 1.05`,
    ),
    figure(
      'sim.looks.one',
      'x',
      ratios(costs.one, costs.none),
      'with one look through the step without looks; information',
    ),
  ];
}
