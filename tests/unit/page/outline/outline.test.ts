import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { isOutline, OUTLINE_LIMIT, packedOutline, unpackedOutline } from '../../../../src/base/outlineText.ts';
import { readOutline, writeOutline } from '../../../../src/page/outline/outline.ts';
import { traceShape } from '../../../../src/page/outline/traceShape.ts';
import type { Line } from '../../../../src/renderer/puffs/drawing/drawing.ts';

const SQUARE = 'QEAgBAgBA';
const anyLine = fc.array(fc.tuple(fc.nat(255), fc.nat(255)), { minLength: 1, maxLength: 6 });
const anyOutline = fc.array(fc.array(anyLine, { maxLength: 3 }), { minLength: 1, maxLength: 3 });

describe('the text of an outline', () => {
  it.each([
    ['', true],
    ['GRkgg-Cg', false],
    ['GRkgg-CgA', true],
    ['GRk', true],
    ['GRkgg.Hh4qg;;Hh4', true],
    [';;;;;;;', true],
    [';;;;;;;;', false],
    ['GR', false],
    ['.GRk', false],
    ['GRk.', false],
    ['GRkg\n', false],
    ['<script>', false],
    [`GRk${'gg'.repeat(510)}`, true],
    [`GRk${'gg'.repeat(511)}`, false],
  ])('%j is one: %s', (text, isOne) => expect(isOutline(text)).toBe(isOne));

  it('keeps the layers and the lines of an outline', () => {
    fc.assert(
      fc.property(anyOutline, (layers) => {
        const text = writeOutline(layers);
        fc.pre(text.length <= OUTLINE_LIMIT);
        expect(isOutline(text)).toBe(true);
        const ends = (lines: readonly Line[]) => lines.map((line) => [line[0], line.at(-1)]);
        expect(readOutline(text).map(ends)).toEqual(layers.map(ends));
      }),
    );
  });

  it('passes through the numbers of the simulator', () => {
    const anyText = fc.string({ unit: fc.constantFrom(...'AZaz09-_.;'.split('')), maxLength: OUTLINE_LIMIT });
    fc.assert(
      fc.property(anyText, (text) => {
        const numbers = packedOutline(text);
        expect(numbers).toHaveLength(128);
        expect(numbers.every(([, number]) => Number.isSafeInteger(number))).toBe(true);
        expect(unpackedOutline(numbers.map(([, number]) => number))).toBe(text);
      }),
    );
    expect(
      packedOutline(SQUARE)
        .slice(0, 3)
        .map(([end]) => end),
    ).toEqual(['.000', '.001', '.002']);
  });

  it('is none for numbers that hold no text', () => {
    expect(() => unpackedOutline(Array<number>(128).fill(67 ** 8 - 1))).not.toThrow();
    expect(unpackedOutline(Array<number>(128).fill(0))).toBe('');
  });
});

/** The area of a closed line. */
function areaOf(line: Line): number {
  const twice = line.reduce((sum, [x, y], at) => {
    const [nextX, nextY] = line[(at + 1) % line.length];
    return sum + x * nextY - y * nextX;
  }, 0);
  return Math.abs(twice) / 2;
}

/** A pyramid of this height over a square of side 2, whose tip is at the greatest z. */
function pyramid(height: number) {
  const positions = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 0, height];
  return { positions, indices: [0, 1, 2, 0, 2, 3, 0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0] };
}

describe('the outline of a mesh', () => {
  it('is cut into layers from back to front', async () => {
    const layers = readOutline(await traceShape({ mesh: pyramid(3) }));
    expect(layers).toHaveLength(6);
    for (const [layer, [line, ...others]] of layers.entries()) {
      const side = 252 * (1 - (layer + 0.5) / 6);
      expect(others).toEqual([]);
      expect(Math.abs(areaOf(line) / side ** 2 - 1)).toBeLessThan(0.15);
    }
  });

  it.each([
    ['without triangles', { positions: [] }],
    ['that is flat', { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] }],
    ['with a vertex at infinity', { positions: [0, 0, 0, 1, 0, Infinity, 0, 1, 0] }],
  ])('is refused for one %s', async (_what, mesh) => {
    await expect(traceShape({ mesh })).rejects.toThrow(/finite|empty/);
  });
});

it.each([[{}], [null], [{ text: '' }], [{ text: 'x'.repeat(41) }], [{ text: 'a', font: '' }], [{ word: 'a' }]])(
  'a source %j is refused',
  async (source) => await expect(traceShape(source as never)).rejects.toThrow(/traceShape/),
);
