import { PNG } from 'pngjs';
import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./edges.cases.ts');
const CASES = '/tests/visual/renderer/passes/edges.cases.ts';

/** Degrees from the horizontal. */
const ANGLES = [3, 8, 22, 38, 45, 64, 75, 87];

test('slanted edges of every kind are smoothed by pixel coverage', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const slants = await cases.evaluate((module, angles) => module.slants([...angles, 0]), ANGLES);
  for (const { kind, angle, report } of slants) {
    const { levels, error, rawError, flatChanged, strange } = report;
    const what = `${kind} at ${angle} degrees`;
    if (angle > 0) expect(levels, what).toBeGreaterThanOrEqual(3);
    else expect(levels, what).toBe(0);
    if (angle > 0) expect(error / rawError, what).toBeLessThan(angle === 45 ? 0.8 : 0.5);
    expect([flatChanged, strange], what).toEqual([0, 0]);
  }
});

test('lines of one or two pixels keep their ink and do not break', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const angles = [0, 2, 10, 25, 40, 45, 60, 80, 90, 'ring'] as const;
  for (const { width, angle, report } of await cases.evaluate(
    (module, all) => module.thinLines([1, 1.5, 2], all),
    angles,
  )) {
    const what = `${width} px at ${angle}`;
    expect(Math.abs(report.kept - 1), what).toBeLessThan(0.04);
    expect(report.palest, what).toBeGreaterThan(0.8);
  }
});

test('specks of one or two pixels are removed and strokes stay', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const { name, isDrawn, left } of await cases.evaluate((module) => module.marks())) {
    if (isDrawn) expect(left, name).toBeCloseTo(1, 1);
    else expect(left, name).toBe(0);
  }
});

test('the corner of a square stays sharp', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.corner())).toBe(0);
});

for (const [width, height] of [
  [128, 64],
  [131, 45],
  [64, 64],
  [9, 8],
  [5, 3],
] as const) {
  // Slopes below the least edge, below it only along rows and columns, and above it.
  for (const slope of [0, 3, 7, 12]) {
    test(`the filter skips tiles without an edge and no others, ${width} x ${height}, slope ${slope}`, async ({
      load,
    }) => {
      const cases = await load<Cases>(CASES);
      const size = [width, height, slope] as const;
      const { different, filtered } = await cases.evaluate((module, picture) => module.tiled(...picture, true), size);
      expect(different).toBe(0);
      if (width > 9) expect(filtered).toBeGreaterThan(0);
    });
  }
}

test('the filter skips gradients', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const marked = (slope: number) =>
    cases.evaluate((module, steep) => module.tiled(128, 64, steep, false).marked, slope);
  expect(await marked(4)).toBe(0);
  expect(await marked(12)).toBeGreaterThan(0);
});

for (const grey of [0, 128, 255]) {
  test(`an outline has the same coverage on a transparent page as on an opaque one: ${grey}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { farthest, mixed } = await cases.evaluate((module, value) => module.pageShares(value), grey);
    expect(mixed).toBeGreaterThan(100);
    // The 8-bit error of the share between ink and black.
    expect(farthest).toBeLessThan(grey === 0 ? 0.06 : 0.02);
  });
}

for (const background of ['white', 'black', 'noise']) {
  test(`a page shows through the outline without a fringe: ${background}`, async ({ load, blank }) => {
    const cases = await load<Cases>(CASES);
    const { disc, behind } = await cases.evaluate((module, name) => module.showDisc(name), background);
    const shown = PNG.sync.read(await blank.screenshot({ clip: { x: 0, y: 0, width: 64, height: 64 } })).data;
    const expected = disc.map((value, at) => value + (1 - disc[at - (at % 4) + 3] / 255) * behind[at]);
    const worst = expected.reduce(
      (most, value, at) => (at % 4 === 3 ? most : Math.max(most, Math.abs(value - shown[at]))),
      0,
    );
    expect(worst).toBeLessThanOrEqual(2);
  });
}

for (const form of ['lobes', 'billboards'] as const) {
  test(`${form}: the filter smooths every kind of edge and changes nothing else`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const inked = await cases.evaluate((module, shape) => module.sceneEdges(shape, true), form);
    const plain = await cases.evaluate((module, shape) => module.sceneEdges(shape, false), form);
    console.log(`levels between flat tones, ${form}:`, inked.levels, plain.levels);
    for (const { flat, flatChanged, strange } of [inked, plain]) {
      expect(flat).toBeGreaterThan(30_000);
      expect([flatChanged, strange]).toEqual([0, 0]);
    }
    for (const edge of ['light on shade', 'ground on shadow', 'ink on page', 'ink on light', 'ink on shade']) {
      expect(inked.levels[edge], edge).toBeGreaterThanOrEqual(3);
    }
    for (const edge of ['light on shade', 'light on page', 'page on shade']) {
      expect(plain.levels[edge.split(' on ').sort().join(' on ')], edge).toBeGreaterThanOrEqual(3);
    }
  });
}
