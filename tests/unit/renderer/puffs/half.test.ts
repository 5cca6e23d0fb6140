import { expect, test } from 'vitest';
import { fromHalf, toHalf } from '../../../../src/renderer/puffs/billboards/layers.ts';

test('every half float that is a number survives a round trip', () => {
  const halves = Array.from({ length: 65536 }, (_, half) => half).filter((half) => !Number.isNaN(fromHalf(half)));
  expect(halves.map((half) => toHalf(fromHalf(half)))).toEqual(halves);
});

test('known values', () => {
  expect([0, 1, -2, 0.5, 65504, 2 ** -24, 1 / 3].map(toHalf)).toEqual([
    0, 0x3c00, 0xc000, 0x3800, 0x7bff, 0x0001, 0x3555,
  ]);
  expect([Infinity, -Infinity, 65520, 1e9].map(toHalf)).toEqual([0x7c00, 0xfc00, 0x7c00, 0x7c00]);
  expect(fromHalf(toHalf(NaN))).toBeNaN();
});

test('rounds to the nearest, ties to even', () => {
  const step = 2 ** -10;
  expect(fromHalf(toHalf(1 + 0.49 * step))).toBe(1);
  expect(fromHalf(toHalf(1 + 0.51 * step))).toBe(1 + step);
  expect(fromHalf(toHalf(1 + 0.5 * step))).toBe(1);
  expect(fromHalf(toHalf(1 + 1.5 * step))).toBe(1 + 2 * step);
  expect(fromHalf(toHalf(2.5 * 2 ** -24))).toBe(2 * 2 ** -24);
});
