/** `Stage.emit`: counts, takes, saved states and errors. */
import { beforeAll, describe, expect, it } from 'vitest';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaults } from '../../../src/parameters/values.ts';
import { air } from '../../../src/scenes/air.ts';
import { changeNumbers, emissionNumbers, type EmissionOptions } from '../../../src/simulator/emitterOptions.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const VALUES: Values = { ...defaults(), scene: 'air', 'emission.rate': 0, 'emission.lifetime': 10 };
const AT = { position: { x: 0, y: 1, z: 0 } };

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('core');
});

const open = () => new Simulation(factory, air(), VALUES, 0);
const emit = (simulation: Simulation, options: Omit<EmissionOptions, 'position'>) =>
  simulation.emit({ ...AT, ...options });

/** Emissions of all kinds, of which one moves. */
function live(simulation: Simulation): void {
  simulation.advance(5);
  const moving = emit(simulation, { rate: 90, duration: 1 });
  emit(simulation, { count: 20 });
  emit(simulation, { count: 33, duration: 0.5, delay: 0.2, shape: 'box', speed: 3, direction: { x: 0, y: 3, z: 4 } });
  simulation.advance(20);
  simulation.changeEmission(moving, { position: { x: 2, y: 1, z: 0 }, tint: 2 });
  simulation.advance(10);
}

describe('counts', () => {
  it.each([
    ['a burst', { count: 37 }, 1, 37],
    ['a burst after a delay', { count: 37, delay: 0.1 }, 7, 37],
    ['a count over a time', { count: 100, duration: 0.7 }, 42, 100],
    ['a rate', { rate: 90, duration: 0.7 }, 42, 63],
  ])('are exact: %s', (_, options, steps, count) => {
    const simulation = open();
    simulation.advance(11);
    emit(simulation, options);
    simulation.advance(steps - 1);
    expect(simulation.simulator.alive).toBeLessThan(count);
    simulation.advance(1);
    expect(simulation.simulator.alive).toBe(count);
    simulation.advance(60);
    expect(simulation.simulator.alive).toBe(count);
    simulation.dispose();
  });

  it('have no end without a duration, until a change gives one', () => {
    const simulation = open();
    const emission = emit(simulation, { rate: 60 });
    simulation.advance(200);
    simulation.changeEmission(emission, { duration: 0 });
    simulation.advance(50);
    expect(simulation.simulator.alive).toBe(200);
    simulation.dispose();
  });
});

it('is recorded in takes', () => {
  const [first, second] = [open(), open()];
  live(first);
  const { simulator } = first;
  const hashes = [simulator.hash()];
  const take = simulator.take();
  second.replay(take, VALUES);
  second.advance(35);
  expect(second.simulator.hash()).toBe(hashes[0]);
  first.approach(0);
  first.advance(35);
  expect(first.simulator.hash()).toBe(hashes[0]);
  expect(second.simulator.take()).toEqual(take);
  first.dispose();
  second.dispose();
});

it('goes on in a restored state', () => {
  const [first, second] = [open(), open()];
  live(first);
  second.restore(first.simulator.save(), VALUES);
  for (const simulation of [first, second]) simulation.advance(60);
  expect(second.simulator.hash()).toBe(first.simulator.hash());
  expect(second.simulator.alive).toBe(90 + 20 + 33);
  first.dispose();
  second.dispose();
});

it('is limited to the emissions that are not over', () => {
  const simulation = open();
  for (let count = 0; count < 384; count++) emit(simulation, { count: 1 });
  expect(() => emit(simulation, { count: 1 })).toThrow('at most 384 emissions at a time');
  simulation.advance(2);
  expect(emit(simulation, { count: 1 })).toBeGreaterThan(0);
  simulation.dispose();
});

it.each<[string, object]>([
  ['emit.position', { count: 3 }],
  ['emit.position.y', { position: { x: 0, y: NaN, z: 0 }, count: 3 }],
  ['emit.count', AT],
  ['emit.count', { ...AT, count: 2.5 }],
  ['emit.rate', { ...AT, count: 3, rate: 3 }],
  ['emit.rate', { ...AT, rate: -1 }],
  ['emit.duration', { ...AT, rate: 3, duration: 3601 }],
  ['emit.duration', { ...AT, count: 20_000, duration: 0.5 }],
  ['emit.delay', { ...AT, count: 3, delay: -1 }],
  ['emit.direction', { ...AT, count: 3, direction: { x: 0, y: 0, z: 0 } }],
  ['emit.shape', { ...AT, count: 3, shape: 'surface' }],
  ['emit.amount', { ...AT, amount: 3 }],
])('names what it rejects: %s', (key, options) => {
  expect(() => emissionNumbers(options as EmissionOptions)).toThrow(expect.objectContaining({ key }));
});

it.each<[string, object]>([
  ['changeEmission.count', { count: 3 }],
  ['changeEmission.delay', { delay: 3 }],
  ['changeEmission.size', { size: 0 }],
])('names what a change rejects: %s', (key, options) => {
  expect(() => changeNumbers(options)).toThrow(expect.objectContaining({ key }));
});
