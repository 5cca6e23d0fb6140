/** Seeking in a take and replaying it elsewhere give the same hashes. */
import { Vector3 } from 'three';
import { beforeAll, describe, expect, it } from 'vitest';
import { defaultState, encode, LONGEST_LINK } from '../../../src/parameters/codec.ts';
import { ParameterError, SimulatorError } from '../../../src/base/errors.ts';
import { unpackBytes } from '../../../src/parameters/packing.ts';
import { lamp } from '../../../src/scenes/lamp.ts';
import { wisp } from '../../../src/scenes/wisp.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Drag } from '../../../src/stage/drag.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { noteOf, takeOf } from '../../../src/stage/take.ts';
import { act, follow, LAST_STEP, lampSimulation, live, VALUES } from '../../support/sim/takeScript.ts';
import { TAKE, TAKE_HASH } from '../../support/sim/recordedTake.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('physics');
});

/** Advances to a step as a seek does. */
function seek(simulation: ReturnType<typeof lampSimulation>, step: number): string {
  simulation.approach(step);
  simulation.advance(step - simulation.simulator.steps);
  return simulation.simulator.hash();
}

describe('seeking', () => {
  it.each([1e7, 0])('reaches the hashes of a straight run with %d bytes of history', (historyBytes) => {
    const simulation = lampSimulation(factory, historyBytes);
    const hashes = live(simulation);
    for (const step of [380, 20, 200, 160, 400, 100, 300, 120]) {
      expect(seek(simulation, step), `step ${step}`).toBe(hashes[step / 20 - 1]);
    }
    expect(simulation.valuesIn(VALUES)).toMatchObject({
      'forces.wind.x': 120 / 200 - 1,
      'simulation.maxParticles': 320,
    });
    simulation.dispose();
  });

  it('steps from the nearest saved state', () => {
    const simulation = lampSimulation(factory);
    live(simulation);
    simulation.approach(250);
    expect(simulation.simulator.steps).toBe(240);
    simulation.approach(399);
    expect(simulation.simulator.steps, 'a later state is as good').toBe(360);
    simulation.approach(59);
    expect(simulation.simulator.steps).toBe(0);
    simulation.dispose();
  });

  it('keeps its history within the budget', () => {
    const simulation = lampSimulation(factory, 400_000);
    let most = 0;
    for (let step = 0; step < 60 * 40; step += 60) {
      simulation.advance(60);
      most = Math.max(most, simulation.historyBytes);
    }
    expect(most).toBeLessThanOrEqual(400_000);
    expect(most).toBeGreaterThan(100_000);
    simulation.dispose();
  });

  it('lets the user take over and drops later inputs', () => {
    const simulation = lampSimulation(factory);
    live(simulation);
    seek(simulation, 240);
    simulation.set({ 'emission.rate': 10 });
    expect(simulation.simulator.takeEnd).toBe(240);
    simulation.advance(100);
    const hash = simulation.simulator.hash();
    for (const step of [60, 340, 0, 340]) seek(simulation, step);
    expect(simulation.simulator.hash()).toBe(hash);
    expect(simulation.valuesIn(VALUES)['forces.wind.x']).toBeCloseTo(220 / 200 - 1, 12);
    simulation.dispose();
  });
});

describe('a take', () => {
  it('replays to the same hashes', () => {
    const first = lampSimulation(factory);
    const hashes = live(first);
    const bytes = first.simulator.take(noteOf({ values: first.startValues }));
    const second = lampSimulation(factory);
    second.set({ 'forces.drag': 4 });
    second.advance(77);
    second.replay(bytes, VALUES);
    expect(follow(second)).toEqual(hashes);
    expect(second.simulator.take(noteOf({ values: VALUES }))).toEqual(bytes);
    first.dispose();
    second.dispose();
  });

  it('describes itself', () => {
    const simulation = lampSimulation(factory);
    live(simulation);
    const bytes = simulation.simulator.take(noteOf({ values: simulation.startValues }));
    const take = takeOf(bytes, factory.readTake(bytes));
    expect(take).toMatchObject({ seed: 1, start: 0, steps: LAST_STEP, isTruncated: false, values: VALUES });
    expect(take.inputs).toBe(simulation.simulator.inputCount);
    expect(take.toBytes()).toEqual(bytes);
    simulation.dispose();
  });

  it('replays changed values, the density curve among them', () => {
    const density = { 'emission.density': '0:.5,0.5:1,1:0' };
    const first = lampSimulation(factory);
    first.advance(10);
    first.set(density);
    first.advance(10);
    const second = lampSimulation(factory);
    second.replay(first.simulator.take(noteOf({ values: first.startValues })), VALUES);
    second.advance(20);
    expect(second.simulator.hash()).toBe(first.simulator.hash());
    expect(second.valuesIn(VALUES)['emission.density']).toBe('0:.5,.5:1,1:0');
    expect(first.valuesIn({ ...VALUES, ...density })['emission.density'], 'as it was written').toBe('0:.5,0.5:1,1:0');
    expect(lampSimulation(factory).valuesIn(VALUES)).toEqual(VALUES);
    first.dispose();
    second.dispose();
  });

  it('has the required capacity', () => {
    const simulation = lampSimulation(factory);
    const roomOf = (bytes: Uint8Array) => factory.readTake(bytes).mostParticles;
    expect(roomOf(simulation.simulator.take())).toBe(300);
    simulation.input((simulator) => simulator.inputCapacity(70_000));
    simulation.advance(1);
    simulation.input((simulator) => simulator.inputCapacity(100));
    expect(roomOf(simulation.simulator.take())).toBe(70_000);
    expect(factory.readTake(simulation.simulator.take()).isFresh).toBe(true);
    simulation.restore(simulation.simulator.save(), VALUES);
    expect(factory.readTake(simulation.simulator.take()).isFresh).toBe(false);
    simulation.dispose();
  });

  it('of half a minute of dragging fits into a link', async () => {
    const simulation = lampSimulation(factory);
    const drag = new Drag(simulation, lamp().handle!);
    const place = new Vector3(0, 1.5, 0);
    for (let step = 0; step < 30 * 60; ++step) {
      // Simulates the tremor of a hand, some millimetres. Multiples of irrational numbers make it reproducible.
      place.x += 0.02 * Math.sin(step / 17) + 0.004 * ((step * Math.SQRT2) % 1);
      place.y += 0.015 * Math.cos(step / 23) - 0.004 * ((step * Math.E) % 1);
      drag.moveTo(place);
      simulation.advance(1);
    }
    const bytes = simulation.simulator.take(noteOf({ values: simulation.startValues }));
    const link = await encode(defaultState(), Uint8Array.from(bytes));
    expect(link.length).toBeLessThan(LONGEST_LINK);
    simulation.dispose();
  });

  it('can start with a restored state', () => {
    const first = lampSimulation(factory);
    const drag = new Drag(first, lamp().handle!);
    for (let step = 0; step < 150; ++step) {
      act(first, drag, step);
      first.advance(1);
    }
    first.restore(first.simulator.save(), VALUES);
    first.set({ 'forces.wind.z': 2 });
    first.advance(50);
    const second = lampSimulation(factory);
    second.replay(first.simulator.take(noteOf({ values: first.startValues })), first.startValues);
    expect(second.simulator.steps).toBe(150);
    second.advance(50);
    expect(second.simulator.hash()).toBe(first.simulator.hash());
    expect(seek(first, 20), 'nothing is known of what came before').toBe(seek(second, 150));
    first.dispose();
    second.dispose();
  });

  it('that was recorded earlier plays to the same end, and its recording too', async () => {
    const { bytes } = await unpackBytes(TAKE, 1e5);
    const core = await loadVariant('core');
    const take = takeOf(bytes, core.readTake(bytes));
    expect(take).toMatchObject({ steps: 60, inputs: 2 });
    const simulation = new Simulation(core, wisp(), take.values, 1e6);
    simulation.replay(bytes, take.values);
    simulation.advance(60);
    expect(simulation.simulator.hash()).toBe(TAKE_HASH);
    const again = simulation.simulator.take(noteOf({ values: take.values }));
    expect(core.readTake(again)).toEqual(core.readTake(bytes));
    simulation.replay(again, take.values);
    simulation.advance(60);
    expect(simulation.simulator.hash()).toBe(TAKE_HASH);
    simulation.dispose();
  });

  it('of a later version is rejected with a message', () => {
    const simulation = lampSimulation(factory);
    const bytes = simulation.simulator.take(noteOf({ values: VALUES }));
    bytes[4] = 4;
    const words = /the take has format 4, this version reads 1 only/;
    expect(() => factory.readTake(bytes)).toThrow(words);
    expect(() => simulation.replay(bytes, VALUES)).toThrow(words);
    simulation.dispose();
  });

  it('is rejected if damaged or of another scene, without a change of the state', async () => {
    const simulation = lampSimulation(factory);
    simulation.advance(90);
    const bytes = simulation.simulator.take(noteOf({ values: VALUES }));
    const before = simulation.simulator.hash();
    for (let place = 0; place < bytes.length; place += 97) {
      const damaged = bytes.slice();
      damaged[place] ^= 64;
      expect(() => simulation.replay(damaged, VALUES)).toThrow(SimulatorError);
      expect(() => factory.readTake(damaged)).toThrow(SimulatorError);
    }
    const bare = (await loadVariant('core')).create({ capacity: 10, seed: 1 });
    bare.record();
    expect(() => simulation.replay(bare.take(), VALUES)).toThrow(/another scene/);
    expect(() => bare.replay(bytes)).toThrow(/another scene/);
    expect(simulation.simulator.hash()).toBe(before);
    expect(simulation.simulator.steps).toBe(90);
    bare.dispose();
    simulation.dispose();
  });

  it.each([
    ['no note', '', /not recorded by a stage/],
    ['a note of something else', '{"values":7}', /not recorded by a stage/],
    ['a value that the table does not take', '{"values":{"emission.rate":-4}}', /emission\.rate/],
  ])('is rejected with %s', (_, note, message) => {
    const simulator = factory.create({ capacity: 10, seed: 1 });
    simulator.record();
    const bytes = simulator.take(note);
    expect(() => takeOf(bytes, factory.readTake(bytes))).toThrow(message);
    simulator.dispose();
  });
});

describe('inputs', () => {
  it('are rejected by name and change nothing', () => {
    const { simulator } = lampSimulation(factory);
    const before = [simulator.hash(), simulator.inputCount];
    const blow = { origin: [0, 0, 0], ray: [0, 0, 1], velocity: [0, 0, 0], radius: 0.5, seconds: 1 };
    const rejected: [() => void, string][] = [
      [() => simulator.inputSteer(8, 0), 'steer.channel'],
      [() => simulator.inputSteer(-1, 0), 'steer.channel'],
      [() => simulator.inputSteer(0, 1.01), 'steer.value'],
      [() => simulator.inputBlow({ ...blow, seconds: 0 }), 'blow.seconds'],
      [() => simulator.inputBlow({ ...blow, velocity: [0, NaN, 0] }), 'blow.velocity.y'],
      [() => simulator.inputPose(1, [0, 0, 0]), 'rigid.index'],
      [() => simulator.inputPose(0, [0, 2000, 0]), 'rigid.position.y'],
      [() => simulator.inputValues({ 'emission.rate': 1e9 }), 'emission.rate'],
      [() => simulator.inputCapacity(0), 'simulation.maxParticles'],
    ];
    for (const [action, key] of rejected) {
      expect(action).toThrow(ParameterError);
      expect(action).toThrow(expect.objectContaining({ key }));
    }
    expect([simulator.hash(), simulator.inputCount]).toEqual(before);
    expect(simulator.control(2)).toBe(0);
    simulator.inputSteer(2, -0.5);
    expect(simulator.control(2)).toBeCloseTo(-0.5, 4);
    simulator.dispose();
  });
});
