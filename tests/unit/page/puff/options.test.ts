import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { ParameterError } from '../../../../src/base/errors.ts';
import { TINTS } from '../../../../src/base/constants.ts';
import { TINT_LIMIT, Tints } from '../../../../src/page/puff/look.ts';
import { requirePuffOptions, EFFECTS, RANGES, type PuffOptions } from '../../../../src/page/puff/options.ts';

beforeEach(() => vi.stubGlobal('CSS', { supports: (_: string, value: string) => value === 'tomato' }));
afterEach(() => vi.unstubAllGlobals());

describe('options', () => {
  it('are accepted up to both ends of each range', () => {
    for (const [name, [min, max]] of Object.entries(RANGES)) {
      for (const value of [min, max]) expect(() => requirePuffOptions({ [name]: value })).not.toThrow();
      for (const value of [min - 1, max + 1, NaN, Infinity, '1', null]) {
        expect(() => requirePuffOptions({ [name]: value }), `${name}: ${value}`).toThrow(ParameterError);
      }
    }
  });

  it('can be undefined', () => {
    expect(() => requirePuffOptions({ effect: undefined, count: undefined, color: undefined })).not.toThrow();
  });

  it.each([
    [{ effect: 'bang' }, EFFECTS.join(', ')],
    [{ effect: 'toString' }, EFFECTS.join(', ')],
    [{ layer: 'beside' }, 'above, below'],
    [{ color: 'none' }, 'a CSS colour'],
    [{ preset: 4 }, 'the name of a preset'],
    [{ text: ' ' }, '1 to 40 characters'],
    [{ text: 'x'.repeat(41) }, '1 to 40 characters'],
    [{ text: 4 }, '1 to 40 characters'],
    [{ colour: 'tomato' }, 'The options are effect, layer'],
    [{ count: 2.5 }, 'a whole number from 1 to 500'],
  ])('%o is rejected with what is accepted', (options, accepted) => {
    expect(() => requirePuffOptions(options as PuffOptions)).toThrow(accepted);
  });
});

describe('tints', () => {
  it('keep a colour and give the oldest away', () => {
    expect(TINT_LIMIT).toBe(TINTS);
    const tints = new Tints();
    const values = {};
    expect(tints.acquireTint(undefined, values)).toBe(0);
    expect(['#111111', '#222222', '#333333', '#111111'].map((color) => tints.acquireTint(color, values))).toEqual([
      1, 2, 3, 1,
    ]);
    expect(tints.acquireTint('#444444', values)).toBe(2);
    expect(values).toEqual({ 'style.tint1': '#111111', 'style.tint2': '#444444', 'style.tint3': '#333333' });
  });
});
