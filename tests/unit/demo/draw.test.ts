import { describe, expect, it } from 'vitest';
import {
  COLORS,
  coverageOf,
  emptySketch,
  sketchOf,
  withFill,
  withFold,
  withStroke,
} from '../../../src/demo/draw/sketch.ts';
import type { Brush, Sketch } from '../../../src/demo/draw/sketch.ts';
import { traceSketch } from '../../../src/demo/draw/trace.ts';
import { isDrawing } from '../../../src/base/drawingText.ts';
import { readDrawings, SIDE } from '../../../src/renderer/puffs/drawing/drawing.ts';

const PEN: Brush = { tool: 'pen', width: 100, ink: 1, isMirrored: false };
const MIDDLE = [128, 128] as const;

/** A disc of a width about the middle. */
function disc(sketch: Sketch, width: number, ink: number): Sketch {
  return withStroke(sketch, { ...PEN, width, ink, tool: ink === 0 ? 'eraser' : 'pen' }, MIDDLE, MIDDLE);
}

/** The sketch that the text of a sketch draws. */
function redrawn(sketch: Sketch): Sketch {
  const { text } = traceSketch(sketch);
  expect(isDrawing(text)).toBe(true);
  return sketchOf(readDrawings(text)[0]);
}

/** Pixels of one colour or both, by the colour itself. */
function overlap(a: Sketch, b: Sketch): number {
  const colorAt = ({ pixels, colors }: Sketch, at: number) => (pixels[at] ? colors[pixels[at] - 1] : '');
  let [same, all] = [0, 0];
  for (let at = 0; at < SIDE * SIDE; at++) {
    const [first, second] = [colorAt(a, at), colorAt(b, at)];
    if (first || second) all++;
    if (first && first === second) same++;
  }
  return same / all;
}

/** Pixels inside a sketch whose text leaves them empty. */
function gaps(sketch: Sketch): number {
  const copy = redrawn(sketch);
  return sketch.pixels.filter((pixel, at) => {
    const isInner = [at, at - 3, at + 3, at - 3 * SIDE, at + 3 * SIDE].every((near) => sketch.pixels[near] > 0);
    return isInner && pixel > 0 && copy.pixels[at] === 0;
  }).length;
}

const ring = disc(disc(emptySketch(), 200, 1), 120, 0);
const halves = (() => {
  const sketch = disc(emptySketch(), 220, 1);
  const pixels = sketch.pixels.map((pixel, at) => (pixel && at % SIDE > 90 + 20 * Math.sin(at / SIDE / 9) ? 2 : pixel));
  return { ...sketch, pixels };
})();

describe('the text of a sketch', () => {
  it.each([
    ['a disc', disc(emptySketch(), 180, 3), 1],
    ['a ring', ring, 1],
    ['two colours with a common border', halves, 2],
    ['a pupil in an eye in a face', disc(disc(disc(emptySketch(), 240, 1), 90, 2), 30, 4), 3],
  ])('draws %s again, without gaps', (_, sketch, areas) => {
    expect(overlap(sketch, redrawn(sketch))).toBeGreaterThan(0.98);
    expect(gaps(sketch)).toBe(0);
    const drawn = readDrawings(traceSketch(sketch).text)[0].areas;
    expect(drawn).toHaveLength(areas);
  });

  it('has a hole for the hole of a ring', () => {
    expect(readDrawings(traceSketch(ring).text)[0].areas[0].outlines).toHaveLength(2);
  });

  it.each([0.5, 0.05])('fits into the limit with noise of density %f', (density) => {
    let random = 1;
    const next = () => (random = (random * 48271) % 2147483647) / 2147483647;
    const { pixels } = disc(emptySketch(), 240, 1);
    const noise = pixels.map((pixel) => (pixel && next() < density ? 1 + Math.floor(8 * next()) : 0));
    const { text } = traceSketch({ ...emptySketch(), pixels: noise });
    expect(isDrawing(text)).toBe(true);
    expect(text).not.toBe('');
  });

  it('fits into the limit with many folds', () => {
    let sketch = disc(emptySketch(), 240, 1);
    for (let x = 20; x < 236; x += 2) {
      const line = Array.from({ length: 60 }, (_, at) => [x + (at % 2) * 9, 20 + 3 * at] as const);
      sketch = withFold(sketch, PEN, line);
    }
    expect(isDrawing(traceSketch(sketch).text)).toBe(true);
  });

  it('is empty without paint, whatever the folds', () => {
    const sketch = withFold(emptySketch(), PEN, [MIDDLE, [200, 200]]);
    expect(traceSketch(sketch).text).toBe('');
    expect(traceSketch(disc(emptySketch(), 3, 1)).text).not.toBe('');
  });
});

describe('strokes', () => {
  it('paint both sides when symmetric, and the text is symmetric', () => {
    const sketch = withStroke(emptySketch(), { ...PEN, width: 30, isMirrored: true }, [60, 60], [90, 190]);
    const mirrored = (pixels: Uint8Array) => pixels.map((_, at) => pixels[at - (at % SIDE) + SIDE - 1 - (at % SIDE)]);
    expect(mirrored(sketch.pixels)).toEqual(sketch.pixels);
    expect(overlap({ ...sketch, pixels: mirrored(redrawn(sketch).pixels) }, redrawn(sketch))).toBeGreaterThan(0.96);
  });

  it('stay on the paper, and fill only what is enclosed', () => {
    const outline = disc(disc(emptySketch(), 200, 1), 180, 0);
    const filled = withFill(outline, { ...PEN, tool: 'fill', ink: 2 }, MIDDLE);
    expect(coverageOf(filled)).toBeCloseTo((100 / 127) ** 2, 1);
    expect(coverageOf(disc(emptySketch(), 900, 1))).toBeCloseTo(1, 2);
    expect(filled.pixels[128 * SIDE + 128]).toBe(2);
    expect(coverageOf(outline)).toBeLessThan(0.2);
  });

  it('of the eraser remove folds that they touch', () => {
    const sketch = withFold(disc(emptySketch(), 200, 1), PEN, [[100, 100], [150, 100]]); // prettier-ignore
    const eraser: Brush = { ...PEN, tool: 'eraser', width: 8 };
    expect(withStroke(sketch, eraser, [125, 120], [125, 120]).folds).toHaveLength(1);
    expect(withStroke(sketch, eraser, [125, 103], [125, 103]).folds).toHaveLength(0);
  });
});

it('a sketch has the colours of its drawing and, for new ones, the others', () => {
  const { colors } = redrawn(disc(emptySketch(), 100, 5));
  expect(colors[0]).toBe(COLORS[4]);
  expect(new Set(colors).size).toBe(COLORS.length);
});
