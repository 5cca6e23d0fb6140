import { expect, test } from 'vitest';
import { CasterInstances, ONE_QUAD } from '../../../src/instances/instances.ts';
import type { Rows } from '../../../src/sim/rows.ts';

const ROLL = 0x1234;

/** Rows with a radius of 0.5 m, whose shadows end this many 1/256ths of the radius behind them. */
function rowsEnding(ends: number[]): Rows {
  return {
    count: ends.length,
    place: Float32Array.from({ length: 4 * ends.length }, () => 0.5),
    attributes: Uint32Array.from(ends.flatMap((end) => [((end << 16) | ROLL) >>> 0, 7])),
  };
}

/** @param shortened ends in metres */
function wordsOf(ends: number[], shortened: number[]): number[] {
  const casters = new CasterInstances(8, ONE_QUAD);
  casters.fill(rowsEnding(ends), Float32Array.from(shortened));
  return Array.from(casters.geometry.getAttribute('attributes').array.slice(0, 2 * casters.count));
}

test('a shadow ends at the given distance in metres, rounded up to the precision of a row', () => {
  const words = wordsOf([0xffff, 0xffff, 0xffff], [1, 1.0001, 1e6]);
  expect(words).toEqual([(512 << 16) | ROLL, 7, (513 << 16) | ROLL, 7, 0xffff0000 + ROLL, 7]);
});

test('an earlier end of a shadow is kept, and a shadow with nothing behind it ends at its centre', () => {
  expect(wordsOf([100, 600], [1, -3])).toEqual([(100 << 16) | ROLL, 7, ROLL, 7]);
});
