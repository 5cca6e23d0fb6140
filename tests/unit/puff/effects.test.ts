import { describe, expect, it } from 'vitest';
import { emissionsOf, type Asked, type Emission, type Extent } from '../../../src/puff/effects.ts';
import { EFFECTS, type Effect } from '../../../src/puff/options.ts';
import { AIR, Emitters, Obstacles, type PlacedEmission } from '../../../src/puff/slots.ts';
import { defaults, validate } from '../../../src/preset/values.ts';

const POINT: Extent = { halfWidth: 0, halfHeight: 0 };
const BUTTON: Extent = { halfWidth: 0.4, halfHeight: 0.13 };
const WALL: Extent = { halfWidth: 6, halfHeight: 4 };

const placed = (effect: Effect, extent = POINT, asked: Asked = {}): PlacedEmission[] =>
  emissionsOf(effect, extent, asked).map((emission) => ({ ...emission, at: { x: 1, y: -2 }, tint: 2 }));

const total = (emissions: readonly Emission[]) => emissions.reduce((sum, { count }) => sum + count, 0);

describe.each(EFFECTS)('%s', (effect) => {
  it.each([
    ['a point', POINT, {}],
    ['a button', BUTTON, {}],
    ['a window', WALL, {}],
    ['the smallest options', BUTTON, { count: 1, size: 0.25, spread: 0, direction: -360, speed: 0, duration: 0 }],
    ['the largest options', WALL, { count: 500, size: 4, spread: 360, direction: 360, speed: 4, duration: 60 }],
  ])('has values that the simulator accepts: %s', (_, extent, asked) => {
    const emitters = new Emitters();
    for (const emission of placed(effect, extent, asked)) emitters.take(emission, 0, 0);
    expect(() => validate({ ...defaults(), ...AIR, ...emitters.values() })).not.toThrow();
  });

  it('emits about as many puffs as asked', () => {
    expect(Math.abs(total(emissionsOf(effect, BUTTON, { count: 60 })) - 60)).toBeLessThanOrEqual(2);
  });

  it('fits into the emitters of the simulator', () => {
    expect(emissionsOf(effect, POINT, {}).length).toBeLessThanOrEqual(4);
  });

  it('scales its puffs and emits for as long as asked', () => {
    const usual = emissionsOf(effect, BUTTON, {});
    const asked = emissionsOf(effect, BUTTON, { size: 2, duration: 9 });
    expect(asked.map(({ size }) => size)).toEqual(usual.map(({ size }) => 2 * size));
    expect(asked.every(({ duration }) => duration === 9)).toBe(true);
    expect(total(asked)).toBeGreaterThan(total(usual));
  });
});

it.each(['burst', 'whoosh', 'dust'] as const)('%s rotates with its direction', (effect) => {
  const usual = emissionsOf(effect, POINT, {});
  const [up, left] = [90, 180].map((direction) => emissionsOf(effect, POINT, { direction }));
  left.forEach((emission, index) => expect(emission.direction! - up[index].direction!).toBe(90));
  expect(left.map(({ spread }) => spread)).toEqual(usual.map(({ spread }) => spread));
});

describe('emitters', () => {
  const [burst] = placed('poof');
  const [stream] = placed('trail');

  it('share the rate as each emission needs, whatever else emits', () => {
    const emitters = new Emitters();
    emitters.take(stream, 0, 0);
    emitters.take({ ...stream, count: 2 * stream.count }, 0, 0);
    emitters.take(burst, 0, 0);
    const values = emitters.values() as Record<string, number>;
    const shares = Array.from({ length: 8 }, (_, index) => values[`emitters.${index}.share`]);
    const sum = shares.reduce((all, share) => all + share, 0);
    const rates = shares.map((share) => (values['emission.rate'] * share) / sum);
    const rate = stream.count / stream.duration;
    expect(rates.map((each) => Math.round(each * 100) / 100)).toEqual([rate, 2 * rate, 0, 0, 0, 0, 0, 0]);
    expect(values['emitters.2.burst.count']).toBe(burst.count);
  });

  it('are free again when their emission is over', () => {
    const emitters = new Emitters();
    for (let index = 0; index < 8; index++) expect(emitters.take(burst, 1, 0)).toBe(index);
    expect(emitters.free(1)).toBe(0);
    expect(emitters.free(1.1)).toBe(8);
    expect([emitters.holds(3, burst), emitters.holds(3, stream)]).toEqual([true, false]);
    emitters.delay([3], 5);
    expect(emitters.free(1.1)).toBe(7);
    expect(emitters.values()['emitters.3.envelope.start']).toBe(5);
  });

  it('follow a line without gaps', () => {
    const emitters = new Emitters();
    emitters.take(burst, 0, 0);
    const index = emitters.take(stream, 0, 0);
    const values = emitters.moveAlong(index, { x: 1, y: 2 }, { x: 3, y: -2 });
    expect(values).toMatchObject({
      'emitters.1.shape': 'line',
      'emitters.1.position.x': 2,
      'emitters.1.position.y': 0,
      'emitters.1.extent.x': 1,
      'emitters.1.extent.y': -2,
    });
    expect(() => validate(values)).not.toThrow();
    // Another call must not move them back.
    emitters.take(burst, 0, 0);
    expect(emitters.values()).toMatchObject(values);
  });
});

describe('obstacles', () => {
  it('go with their owner, and the oldest makes way for the ninth', () => {
    const obstacles = new Obstacles();
    const owners = Array.from({ length: 9 }, () => ({}));
    const keys = owners.map((owner) => Object.keys(obstacles.take(owner, { x: 0, y: 0 }, BUTTON))[0]);
    expect(keys[8]).toBe(keys[0]);
    expect(obstacles.release(owners[0])).toEqual({});
    const gone = obstacles.release(owners[3]);
    expect(gone['colliders.3.position.x']).toBeGreaterThan(100);
    expect(() => validate(gone)).not.toThrow();
    expect(Object.keys(obstacles.take({}, { x: 0, y: 0 }, BUTTON))[0]).toMatch(/^colliders\.3\./);
    expect(Object.keys(obstacles.release())).toHaveLength(3 * 8);
  });
});
