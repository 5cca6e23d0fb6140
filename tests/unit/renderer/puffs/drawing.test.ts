import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import { ShapeError } from '../../../../src/base/errors.ts';
import { MAX_LOBES } from '../../../../src/base/constants.ts';
import { DRAWING_LIMIT, isDrawing } from '../../../../src/base/drawingText.ts';
import { defaultPreset, presetValues } from '../../../../src/parameters/presets.ts';
import { fetchExtras } from '../../../../src/renderer/extraPasses.ts';
import { LivePuffs } from '../../../../src/renderer/livePuffs.ts';
import { bakePuffs, samplePuff } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { drawPuff } from '../../../../src/renderer/puffs/drawing/drawPuff.ts';
import {
  readDrawings,
  writeDrawing,
  writeDrawings,
  type Line,
  type PuffDrawing,
} from '../../../../src/renderer/puffs/drawing/drawing.ts';
import { simulatorValues } from '../../../../src/simulator/simulatorValues.ts';
import { requireShapes } from '../../../../src/renderer/puffs/lobes.ts';

/** A regular polygon about the middle of the sheet, in particle radii. */
function circle(radius: number, [x, y] = [0, 0], corners = 96): Line {
  return Array.from({ length: corners }, (_, corner) => {
    const angle = (2 * Math.PI * corner) / corners;
    return [
      Math.round(128 + 128 * (x + radius * Math.cos(angle))),
      Math.round(128 - 128 * (y + radius * Math.sin(angle))),
    ];
  });
}

function drawingOf(...outlines: Line[]): PuffDrawing {
  return { areas: [{ color: '#ffffff', outlines }], folds: [] };
}

const bake = (drawing: PuffDrawing) => bakePuffs([drawPuff(drawing)]);

describe('the text of drawings', () => {
  const point = fc.tuple(fc.integer({ min: 0, max: 255 }), fc.integer({ min: 0, max: 255 }));
  const line = fc.array(point, { minLength: 2, maxLength: 6 });

  it('holds colours, outlines and folds; long steps are divided', () => {
    const given = { areas: [{ color: '#12ab9f', outlines: [[[0, 255], [255, 0], [3, 4]]] }], folds: [[[9, 8], [7, 6]]] }; // prettier-ignore
    const [read] = readDrawings(writeDrawings([given as unknown as PuffDrawing]));
    expect(read.folds).toEqual(given.folds);
    expect(read.areas[0].color).toBe('#12ab9f');
    const [outline] = read.areas[0].outlines;
    expect([outline[0], outline[9], outline.at(-1)]).toEqual([[0, 255], [255, 0], [3, 4]]); // prettier-ignore
    for (const [x, y] of outline.slice(0, 10)) expect(Math.abs(x + y - 255)).toBeLessThanOrEqual(1);
  });

  it('is read as it was written', () => {
    const areas = fc.array(
      fc.record({
        color: fc.constantFrom('#ffffff', '#00ff80'),
        outlines: fc.array(line, { minLength: 1, maxLength: 3 }),
      }),
      { minLength: 1, maxLength: 3 },
    );
    fc.assert(
      fc.property(fc.record({ areas, folds: fc.array(line, { maxLength: 2 }) }), (drawing) => {
        const text = writeDrawing(drawing);
        expect(isDrawing(text)).toBe(true);
        expect(writeDrawing(readDrawings(text)[0])).toBe(text);
      }),
    );
  });

  test.each([
    ['five', Array<PuffDrawing>(5).fill(drawingOf(circle(0.5)))],
    ['no area', [{ areas: [], folds: [circle(0.5)] }]],
    ['too many points', [drawingOf(...Array<Line>(40).fill(circle(0.5)))]],
  ])('cannot hold %s', (_, drawings) => {
    expect(() => writeDrawings(drawings)).toThrow(ShapeError);
  });

  test.each([
    '',
    'x',
    'ffffff*',
    'ffffff*AAA',
    'ffffff*AAAB',
    'ffffff*AAA<B',
    '*GRk-g',
    'ffffff*GRk-g;',
    'FFFFFF*GRk-g',
    `ffffff*GRk${'-g'.repeat(600)}`,
  ])('is not %s', (text) => {
    expect(() => readDrawings(text)).toThrow(ShapeError);
    if (text) expect(() => requireShapes([{ ...drawPuff('ff8800*GRk-gg-Cg'), drawing: text }])).toThrow(ShapeError);
  });

  it('keeps points on the sheet', () => {
    const outlines = readDrawings(`ffffff*_____${'__'.repeat(20)}`)[0].areas[0].outlines.flat(2);
    expect(Math.max(...outlines)).toBe(255);
    expect(
      readDrawings(`ffffff*AAA${'AA'.repeat(20)}`)[0]
        .areas[0].outlines.flat(2)
        .every((at) => at === 0),
    ).toBe(true);
  });
});

describe('the relief of a drawing', () => {
  it('is a flattened ball over a disc', () => {
    const layers = bake(drawingOf(circle(0.9)));
    for (const [x, y] of [[0, 0], [0.3, 0.2], [-0.5, 0.4], [0, -0.8], [0.6, -0.6]]) {
      const { height, normal, distance } = samplePuff(layers, 0, x, y);
      const ball = Math.sqrt(0.81 - x * x - y * y);
      expect(height).toBeCloseTo(0.85 * ball, 1.7);
      const length = Math.hypot(0.85 * x, 0.85 * y, ball);
      expect(normal[0]).toBeCloseTo((0.85 * x) / length, 1.5);
      expect(normal[1]).toBeCloseTo((0.85 * y) / length, 1.5);
      expect(distance).toBeCloseTo(Math.max(-0.35, Math.hypot(x, y) - 0.9), 1.5);
    }
  }); // prettier-ignore

  it('falls along folds', () => {
    const plain = drawingOf(circle(0.9));
    const folded = bake({ ...plain, folds: [[[128, 80], [128, 176]]] }); // prettier-ignore
    const [before, after] = [bake(plain), folded].map((layers) => samplePuff(layers, 0, 0, 0).height);
    expect(after).toBeLessThan(0.5 * before);
    expect(samplePuff(folded, 0, 0.1, 0).normal[0]).toBeLessThan(-0.3);
    expect(samplePuff(folded, 0, -0.1, 0).normal[0]).toBeGreaterThan(0.3);
    expect(samplePuff(folded, 0, 0.6, 0).height).toBeGreaterThan(0.75 * samplePuff(bake(plain), 0, 0.6, 0).height);
  });

  it('is open where outlines overlap, and has the colour of the last area', () => {
    const ring = drawingOf(circle(0.8), circle(0.4));
    const painted = { ...ring, areas: [...ring.areas, { color: '#ff0000', outlines: [circle(0.15, [0, 0.6])] }] };
    const layers = bake(painted);
    expect(samplePuff(layers, 0, 0, 0).distance).toBeGreaterThan(0.3);
    const colorAt = (x: number, y: number) => {
      const [column, row] = [x, y].map((at) => Math.floor(((at / 1.35 + 1) / 2) * 128));
      return [...layers.colorCoverage.subarray(4 * (128 * row + column), 4 * (128 * row + column) + 3)];
    };
    expect(colorAt(0, 0.6)).toEqual([255, 0, 0]);
    expect(colorAt(0.6, 0)).toEqual([255, 255, 255]);
  });

  it('has supports: how far its silhouette extends in each direction', () => {
    const [{ supports }] = bake(drawingOf(circle(0.3, [0.4, -0.2]))).figures;
    expect(supports).toHaveLength(16);
    for (const [direction, extent] of supports.entries()) {
      const angle = (2 * Math.PI * direction) / 16;
      expect(Math.abs(extent - (0.3 + 0.4 * Math.cos(angle) - 0.2 * Math.sin(angle)))).toBeLessThan(0.01);
    }
  });

  it('shrinks to the unit circle, and is a dot where nothing is drawn', () => {
    const [wide] = bake(drawingOf([[0, 0], [255, 0], [255, 255], [0, 255]])).figures; // prettier-ignore
    expect(wide.outerRadius).toBeLessThan(1.01);
    expect(wide.outerRadius).toBeGreaterThan(0.97);
    const [empty] = bake(drawingOf([[9, 9], [60, 60]])).figures; // prettier-ignore
    expect(empty.silhouetteRadius).toBeGreaterThan(0.05);
    expect(empty.silhouetteRadius).toBeLessThan(0.15);
  });

  test.each([
    ['a disc', drawingOf(circle(0.9))],
    ['a ring', drawingOf(circle(0.9), circle(0.5))],
    ['two islands', drawingOf(circle(0.3, [-0.6, 0]), circle(0.2, [0.5, 0.5]))],
    ['a thin line', drawingOf([[20, 128], [236, 128], [236, 132], [20, 132]])], // prettier-ignore
  ])('has discs inside %s', (_, drawing) => {
    const { lobes } = drawPuff(drawing);
    const layers = bake(drawing);
    expect(lobes.length).toBeLessThanOrEqual(MAX_LOBES);
    for (const { center, radius } of lobes) {
      const depth = -samplePuff(layers, 0, center[0], center[1]).distance;
      expect(radius).toBeLessThan(depth > 0.34 ? 1 : depth + 0.02);
    }
  });
});

test('puffs take their pictures from `puff.drawing`, whatever their form', async () => {
  const values = { ...presetValues(defaultPreset), 'puff.drawing': 'ff8800*GRk-gg-Cg;3355aa*Hh4qggqWg' } as const;
  await fetchExtras({
    renderer: 'nailboards',
    form: 'billboards',
    isDeformed: false,
    volumes: 'receiver',
    simplify: 0,
    plumeForm: 0,
    outlines: true,
    strokes: 0,
    isEroded: false,
  });
  const live = new LivePuffs(values);
  const { layers } = live.finish()!.billboards;
  expect(layers.count).toBe(2);
  const middle = 4 * (128 * 64 + 64);
  expect([...layers.colorCoverage.subarray(middle, middle + 3)]).toEqual([255, 136, 0]);
  live.requestPuffs({ ...values, 'puff.drawing': '' });
  expect(live.finish()!.lobes.count).toBe(4);
});

test('drawings are not in the simulation', () => {
  const values = presetValues('wisp-hearts');
  const { 'puff.drawing': drawing, ...others } = values;
  expect(isDrawing(drawing!)).toBe(true);
  expect(drawing!.split(';').length).toBe(3);
  expect(simulatorValues(values)).toEqual(simulatorValues(others));
});

test('a drawing is the longest that a link holds', () => {
  const longest = `ffffff*AAA${'hh'.repeat((DRAWING_LIMIT - 10) / 2)}`;
  expect(longest.length).toBe(DRAWING_LIMIT);
  expect(isDrawing([longest, longest, longest, longest].join(';'))).toBe(true);
  expect(isDrawing(`${longest}hh`)).toBe(false);
});
