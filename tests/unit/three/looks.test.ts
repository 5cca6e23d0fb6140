/** Looks, puffs per metre and the promises of bursts, of emitters outside the parameter table and of handles of the table. */
import { Object3D } from 'three';
import { beforeAll, expect, test } from 'vitest';
import { ParameterError } from '../../../src/base/errors.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { NO_STYLE, numberOfStyle } from '../../../src/simulator/lookStyles.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { HandledSmoke } from '../../support/handledSmoke.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('core');
});

const RESTING = { speed: 0, shape: 'point' } as const;
const ALIKE = { ...RESTING, lifetimeVariation: 0 } as const;
const RED = '0:400000,.5:ff4030';
const AT = { position: { x: 0, y: 0, z: 0 } };

/** The styles of all looks. */
function stylesIn(simulator: Simulator): number[] {
  const numbers = simulator.lookStyles();
  const size = numbers.length / 15;
  return [...numbers].filter((number, at) => at % size === 0 && number > 0);
}

/** Whether a promise has resolved. */
async function isDone(promise: Promise<void>): Promise<boolean> {
  return Promise.race([promise.then(() => true), Promise.resolve().then(() => Promise.resolve(false))]);
}

test('a look reaches the simulator: its puffs end by their lifetime, and the style is that of the colours', () => {
  const smoke = new HandledSmoke(factory);
  const emitter = smoke.emitFrom(smoke.put(new Object3D()), {
    ...ALIKE,
    rate: 60,
    look: { lifetime: 0.5, colors: RED },
  });
  smoke.emitFrom(smoke.put(new Object3D()), { ...ALIKE, rate: 60 });
  smoke.frames(100);
  const { simulator } = smoke;
  expect(simulator.hasLooks).toBe(true);
  expect(stylesIn(simulator)).toEqual([numberOfStyle({ ...NO_STYLE, colors: RED })]);
  expect(Math.abs(simulator.alive - 130)).toBeLessThan(3);
  emitter.set({ look: {} });
  smoke.frames(60);
  expect(Math.abs(simulator.alive - 220)).toBeLessThan(3);
  simulator.dispose();
});

test('equal looks are one; the sixteenth is an error, and changes nothing', () => {
  const smoke = new HandledSmoke(factory);
  const { simulator } = smoke;
  const look = (index: number) => ({ colors: RED, gravity: index / 10 });
  const options = (index: number) => ({ ...ALIKE, rate: 60, look: look(index) });
  for (let round = 0; round < 2; round++)
    for (let index = 0; index < 15; index++) smoke.emitFrom(smoke.put(new Object3D()), options(index));
  smoke.frames(3);
  const before = simulator.hash();
  const one = smoke.emitFrom(smoke.put(new Object3D()), { ...ALIKE, rate: 60, look: look(3) });
  smoke.frame();
  const tooMany = /look cannot be 16: it takes at most 15 different looks/;
  const object = smoke.put(new Object3D());
  expect(() => smoke.emitFrom(object, options(15))).toThrow(ParameterError);
  expect(() => smoke.emitFrom(object, options(15))).toThrow(/^emitFrom\./);
  expect(() => one.set({ look: look(15) })).toThrow(tooMany);
  expect(() => void smoke.pool.burst({ ...AT, count: 3, look: look(15) })).toThrow(/^burst\.look cannot be 16/);
  const alive = simulator.alive;
  smoke.frame();
  expect(simulator.alive).toBe(alive + 31);
  expect(simulator.hash()).not.toBe(before);
  // The rejected ones have left their places.
  for (let index = 31; index < 128; index++) smoke.emitFrom(object, { ...ALIKE, rate: 0 });
  expect(() => smoke.emitFrom(object, {})).toThrow(/at most 128/);
  simulator.dispose();
});

test('errors name the part of the look', () => {
  const smoke = new HandledSmoke(factory);
  const object = smoke.put(new Object3D());
  const wrong = (look: unknown) => () => smoke.emitFrom(object, { look } as object);
  expect(wrong({ colour: RED })).toThrow(/emitFrom\.look\.colour cannot be .*lifetime, growthTime.*colors/);
  expect(wrong({ colors: 'red' })).toThrow(
    /emitFrom\.look\.colors cannot be “red”: it takes nothing, or 2 to 16 stops/,
  );
  expect(wrong({ sizeCurve: '0:2,1:0' })).toThrow(/emitFrom\.look\.sizeCurve/);
  expect(wrong({ inkWeight: NaN })).toThrow(/emitFrom\.look\.inkWeight cannot be NaN: it takes a number from 0 to 4/);
  expect(wrong({ dissolve: 'melt' })).toThrow(/it takes smoke, shrink, erode, tear, thin/);
  expect(wrong(5)).toThrow(/emitFrom\.look cannot be 5/);
  expect(wrong(null)).toThrow(/emitFrom\.look cannot be null/);
  expect(() => smoke.emitFrom(object, 2).set({ look: { lifetime: -1 } })).toThrow(/emitFrom\.look\.lifetime/);
  smoke.simulator.dispose();
});

test('the promise of a burst resolves in the step in which its last puff ends', async () => {
  const smoke = new HandledSmoke(factory);
  const emitter = smoke.emitFrom(smoke.put(new Object3D()), { ...ALIKE, rate: 0, look: { lifetime: 1.25 } });
  const table = smoke.emitFrom(smoke.put(new Object3D()), 1);
  table.set({ lifetimeVariation: 0, look: { lifetime: 2 } });
  const bursts = [
    smoke.pool.burst({ ...AT, count: 50, lifetimeVariation: 1, look: { lifetime: 0.5 } }),
    emitter.burst(1),
    table.burst(4),
  ];
  // The lifetime is that of their birth.
  smoke.frame();
  emitter.set({ look: { lifetime: 0.1 } });
  const ends = [0, 0, 0];
  let steps = 1;
  const alive = [55, 55];
  while (steps < 150) {
    smoke.frame();
    steps++;
    alive.push(smoke.simulator.alive);
    for (const [index, burst] of bursts.entries()) if (!ends[index] && (await isDone(burst))) ends[index] = steps;
  }
  // Puffs are removed in the step after that in which they end.
  const lastShown = (left: number) => alive.findIndex((number) => number <= left) - 1;
  expect(ends).toEqual([lastShown(5), lastShown(4), lastShown(0)]);
  expect(ends.slice(1)).toEqual([1 + 75, 1 + 120]);
  smoke.simulator.dispose();
});

test('the promise resolves when the emitter pauses before the births, and at once while it is paused', async () => {
  const smoke = new HandledSmoke(factory, undefined, 10);
  const object = smoke.put(new Object3D());
  const emitter = smoke.emitFrom(object, { ...RESTING, rate: 0 });
  // More than there is room for.
  const burst = emitter.burst(30);
  smoke.frames(5);
  expect(await isDone(burst)).toBe(false);
  emitter.enabled = false;
  smoke.frame();
  expect(await isDone(burst)).toBe(true);
  expect(await isDone(emitter.burst(3))).toBe(true);
  smoke.simulator.dispose();
});

test('an emitter puts out as many puffs on a way, however fast it travels', () => {
  const counts = [1, 3, 10].map((stepsPerMetre) => {
    const smoke = new HandledSmoke(factory);
    const object = smoke.put(new Object3D());
    smoke.emitFrom(object, { ...RESTING, rate: 0, perMetre: 40 });
    smoke.frame();
    for (let step = 1; step <= 5 * stepsPerMetre; step++) {
      object.position.x = step / stepsPerMetre;
      smoke.frame();
    }
    smoke.frames(2);
    const { alive } = smoke.simulator;
    smoke.simulator.dispose();
    return alive;
  });
  expect(new Set(counts).size).toBe(1);
  expect(Math.abs(counts[0] - 200)).toBeLessThanOrEqual(1);
});

test('a table emitter that is disabled has no puffs per metre', () => {
  const smoke = new HandledSmoke(factory);
  const object = smoke.put(new Object3D());
  const emitter = smoke.emitFrom(object, 0);
  emitter.set({ ...RESTING, perMetre: 20 });
  const travel = () => {
    for (let step = 0; step < 60; step++) {
      object.position.x += 0.05;
      smoke.frame();
    }
    return smoke.simulator.alive;
  };
  // It has no way in the first step, and the last puff is due in the next one.
  expect(Math.abs(travel() - 59)).toBeLessThanOrEqual(1);
  emitter.enabled = false;
  smoke.frame();
  const before = smoke.simulator.alive;
  expect(travel()).toBe(before);
  smoke.simulator.dispose();
});
