import { describe, expect, it } from 'vitest';
import { emissionsOf, type Extent } from '../../../../src/page/puff/effects.ts';
import type { Emission } from '../../../../src/page/puff/emission.ts';
import { EFFECTS } from '../../../../src/page/puff/options.ts';
import { AIR, alongLine, emissionOptions } from '../../../../src/page/puff/emission.ts';
import { Obstacles } from '../../../../src/page/puff/obstacles.ts';
import { sizeOfWord, Words } from '../../../../src/page/puff/words.ts';
import { defaults, validate } from '../../../../src/parameters/values.ts';
import { changeNumbers, emissionNumbers } from '../../../../src/simulator/emitterOptions.ts';

const POINT: Extent = { halfWidth: 0, halfHeight: 0 };
const BUTTON: Extent = { halfWidth: 0.4, halfHeight: 0.13 };
const PLACE = { ...BUTTON, middle: [0, 0, 0], top: [0, 0.13, 0] } as const;
const PLANE = { middle: [0, 0, 0], right: [0.01, 0, 0], up: [0, 0.01, 0] } as const;
const WALL: Extent = { halfWidth: 6, halfHeight: 4 };

const total = (emissions: readonly Emission[]) => emissions.reduce((sum, { count }) => sum + count, 0);

describe.each(EFFECTS)('%s', (effect) => {
  it.each([
    ['a point', POINT, {}],
    ['a button', BUTTON, {}],
    ['a window', WALL, {}],
    ['the smallest options', BUTTON, { count: 1, size: 0.25, spread: 0, direction: -360, speed: 0, duration: 0 }],
    ['the largest options', WALL, { count: 500, size: 4, spread: 360, direction: 360, speed: 4, duration: 60 }],
  ])('has values that the simulator accepts: %s', (_, extent, asked) => {
    for (const emission of emissionsOf(effect, extent, asked))
      expect(() => emissionNumbers(emissionOptions(emission, [1, -2, 0], 2))).not.toThrow();
  });

  it('emits about as many puffs as asked', () => {
    expect(Math.abs(total(emissionsOf(effect, BUTTON, { count: 60 })) - 60)).toBeLessThanOrEqual(2);
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

it('has air that the simulator accepts', () => {
  expect(() => validate({ ...defaults(), ...AIR })).not.toThrow();
});

it('follows a line without gaps', () => {
  const change = alongLine([1, 2, 0], [3, -2, 0]);
  expect(change).toEqual({ shape: 'line', position: { x: 2, y: 0, z: 0 }, extent: { x: 1, y: -2, z: 0 } });
  expect(() => changeNumbers(change)).not.toThrow();
});

describe('obstacles', () => {
  it('go with their owner, and the oldest makes way for the ninth', () => {
    const obstacles = new Obstacles();
    const owners = Array.from({ length: 9 }, () => ({}));
    const take = (owner: object) => Object.keys(obstacles.claim(owner, PLACE, PLANE))[0];
    const keys = owners.map(take);
    expect(keys[8]).toBe(keys[0]);
    expect(obstacles.release(owners[0])).toEqual({});
    const gone = obstacles.release(owners[3]);
    expect(gone['colliders.3.position.x']).toBeGreaterThan(100);
    expect(() => validate(gone)).not.toThrow();
    expect(take({})).toMatch(/^colliders\.3\./);
    expect(Object.keys(obstacles.release())).toHaveLength(3 * 8);
  });
});

describe('words', () => {
  const WORD = { text: 'SAVE', outline: 'GRkgg-CgA' };

  it('are above their target, or below it at the upper edge of the picture', () => {
    for (const [top, sign] of [
      [2, 1],
      [0.3, -1],
    ]) {
      const values = new Words().claim({}, WORD, PLACE, top, 1.5);
      expect(() => validate(values)).not.toThrow();
      expect(sign * values['shapes.0.position.y']!).toBeGreaterThan(BUTTON.halfHeight + 0.2);
      expect(values['shapes.0.envelope.start']).toBe(1.5);
    }
  });

  it('are as wide as their letters or their target, and do not fill the page', () => {
    expect(sizeOfWord('A', 0).width).toBe(sizeOfWord('ABC', 0).width);
    expect(sizeOfWord('SAVE', 1).width).toBe(2);
    expect(sizeOfWord('x'.repeat(40), 9).width).toBe(5);
  });

  it('go with their owner', () => {
    const words = new Words();
    const [first, second] = [{}, {}];
    words.claim(first, WORD, PLACE, 2, 0);
    words.claim(second, WORD, PLACE, 2, 0);
    expect(words.release(second)).toEqual({ 'shapes.1.speed': 0 });
    expect(words.release()).toEqual({ 'shapes.0.speed': 0 });
  });
});
