/** Takes and saved states show the looks of their emitters, also in another page. */
import { afterEach, beforeAll, describe, expect, it, vi } from 'vitest';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaults } from '../../../src/parameters/values.ts';
import { air } from '../../../src/scenes/air.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const RED = '0:400000,.5:ff4030';
const BLUE = '0:000040,.5:4030ff';
const PLAIN: Values = { ...defaults(), scene: 'air', 'emission.rate': 60 };
const VALUES: Values = {
  ...PLAIN,
  'emitters.0.share': 1,
  'emitters.0.look.colors': BLUE,
  'emitters.0.look.lifetime': 2,
};
const BURST = { position: { x: 0, y: 1, z: 0 }, count: 20, look: { colors: RED, inkWeight: 3 } };
/** An emission that starts after the state was saved. */
const LATER = { ...BURST, delay: 1, look: { heatColors: RED } };

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('core');
});
afterEach(() => vi.resetModules());

/** The modules of another page, which knows no style. */
async function elsewhere() {
  vi.resetModules();
  const [styles, stage, sim] = await Promise.all([
    import('../../../src/simulator/lookStyles.ts'),
    import('../../../src/stage/simulation.ts'),
    import('../../support/sim/simWasm.ts'),
  ]);
  const other = await sim.loadVariant('core');
  return { ...styles, open: (values: Values) => new stage.Simulation(other, air(), values, 0) };
}

/** The looks of a simulation's puffs outside the table, by their styles. */
function stylesIn({ simulator }: Pick<Simulation, 'simulator'>, styleOf: (number: number) => unknown): unknown[] {
  const numbers = simulator.lookStyles();
  const size = numbers.length / 15;
  return [...numbers].filter((number, at) => at % size === 0 && number > 8).map(styleOf);
}

const RED_INK = { colors: RED, ageColors: '', heatColors: '', inkWeight: 3 };
const RED_HEAT = { colors: '', ageColors: '', heatColors: RED, inkWeight: 1 };

function live(): Simulation {
  const simulation = new Simulation(factory, air(), VALUES, 0);
  simulation.advance(10);
  simulation.emit(BURST);
  simulation.advance(5);
  simulation.emit(LATER);
  simulation.advance(20);
  return simulation;
}

describe('another page', () => {
  it('shows the looks of a saved state, and of what starts after it', async () => {
    const simulation = live();
    const bytes = simulation.simulator.save(VALUES);
    simulation.advance(60);
    const hash = simulation.simulator.hash();
    simulation.dispose();

    const { open, styleOfNumber } = await elsewhere();
    const other = open(PLAIN);
    const values = other.restore(bytes, PLAIN);
    expect(values).toMatchObject({ 'emitters.0.look.colors': BLUE, 'emitters.0.look.lifetime': 2 });
    expect(stylesIn(other, styleOfNumber)).toEqual([RED_INK]);
    other.advance(60);
    expect(other.simulator.hash()).toBe(hash);
    expect(stylesIn(other, styleOfNumber)).toEqual(expect.arrayContaining([RED_INK, RED_HEAT]));
    // Saved again, they are still there.
    const again = await elsewhere();
    const third = again.open(PLAIN);
    third.restore(other.simulator.save(values), PLAIN);
    expect(stylesIn(third, again.styleOfNumber)).toEqual(expect.arrayContaining([RED_INK, RED_HEAT]));
    other.dispose();
    third.dispose();
  });

  it('replays a take with its looks to the same hash', async () => {
    const simulation = live();
    simulation.advance(60);
    const take = simulation.take();
    const hash = simulation.simulator.hash();
    const { steps } = simulation.simulator;
    simulation.dispose();

    const { open, styleOfNumber } = await elsewhere();
    const other = open(PLAIN);
    expect(other.playTake(take)).toMatchObject({ 'emitters.0.look.colors': BLUE });
    other.advance(steps);
    expect(other.simulator.hash()).toBe(hash);
    expect(stylesIn(other, styleOfNumber)).toEqual(expect.arrayContaining([RED_INK, RED_HEAT]));
    // The take is recorded on.
    expect(other.readTake(other.take()).toBytes().length).toBeGreaterThan(take.length - 100);
    expect(other.simulator.styles.size).toBe(2);
    other.dispose();
  });
});

it('a state without looks has the bytes of the simulator only', () => {
  const simulation = new Simulation(factory, air(), PLAIN, 0);
  simulation.advance(10);
  expect(simulation.simulator.save(PLAIN)).toEqual(simulation.simulator.save());
  expect(JSON.parse(factory.readTake(simulation.take()).note)).not.toHaveProperty('looks');
  simulation.dispose();
});

it('the colours of a look leave the hash alone, other parts of it do not', () => {
  const hashOf = (values: Values) => {
    const simulation = new Simulation(factory, air(), { ...VALUES, ...values }, 0);
    simulation.advance(30);
    const hash = simulation.simulator.hash();
    simulation.dispose();
    return hash;
  };
  const plain = hashOf({});
  expect(hashOf({ 'emitters.0.look.colors': RED })).toBe(plain);
  expect(hashOf({ 'emitters.0.look.ageColors': RED, 'emitters.0.look.inkWeight': 2 })).toBe(plain);
  expect(hashOf({ 'emitters.0.look.gravity': 2 })).not.toBe(plain);
});

it('an emission with the sixteenth look is an error that names it, and changes nothing', () => {
  const simulation = new Simulation(factory, air(), PLAIN, 0);
  const emit = (gravity: number) => simulation.emit({ ...BURST, look: { gravity } });
  for (let index = 2; index < 17; index++) emit(index / 2 + 1);
  const one = simulation.emit({ position: BURST.position, rate: 60, look: { gravity: 2 } });
  simulation.advance(1);
  const hash = simulation.simulator.hash();
  expect(() => emit(0.3)).toThrow(/^emit\.look cannot be 16: it takes at most 15 different looks/);
  expect(() => simulation.changeEmission(one, { look: { gravity: 0.5 } })).toThrow(
    /^changeEmission\.look cannot be 16/,
  );
  expect(() => simulation.set({ 'emitters.3.look.drag': 2, 'emission.rate': 7 })).toThrow(/look cannot be 16/);
  expect(simulation.simulator.hash()).toBe(hash);
  simulation.dispose();
});
