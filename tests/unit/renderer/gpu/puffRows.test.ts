import { expect, test } from 'vitest';
import { ONE_QUAD } from '../../../../src/renderer/gpu/drawnRows.ts';
import { CasterRows } from '../../../../src/renderer/gpu/puffRows.ts';
import { ATTRIBUTE_BITS, END_STEPS, NO_END, PLACE_FLOATS } from '../../../../src/simulator/layout.ts';
import type { Rows } from '../../../../src/simulator/rows.ts';

const { shift, max } = ATTRIBUTE_BITS.end;
const ROLL = 0x1234;

/** Rows with a radius of 0.5 m, whose shadows end this many steps behind them. */
function rowsEnding(ends: number[]): Rows {
  return {
    count: ends.length,
    whole: ends.length,
    place: Float32Array.from({ length: PLACE_FLOATS * ends.length }, () => 0.5),
    attributes: Uint32Array.from(ends.flatMap((end) => [ending(end), 7, 0, 0])),
  };
}

/** Word 0 of a row. */
function ending(end: number): number {
  return ((end << shift) | ROLL) >>> 0;
}

/** @param shortened ends in metres */
function wordsOf(ends: number[], shortened: number[]): number[] {
  const casters = new CasterRows(8, ONE_QUAD);
  casters.fill(rowsEnding(ends), Float32Array.from(shortened));
  return Array.from(casters.attributeWords);
}

test('a shadow ends at the given distance in metres, rounded up to the precision of a row', () => {
  const words = wordsOf([max, max, max], [1, 1.0001, 1e6]);
  expect(words).toEqual(
    [ending(2 * END_STEPS), ending(2 * END_STEPS + 1), NO_END + ROLL].flatMap((word) => [word, 7, 0, 0]),
  );
});

test('an earlier end of a shadow is kept, and a shadow with nothing behind it ends at its centre', () => {
  expect(wordsOf([100, 600], [1, -3])).toEqual([ending(100), 7, 0, 0, ROLL, 7, 0, 0]);
});
