import { expect, longIf, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./patterns.cases.ts');
const CASES = '/tests/visual/renderer/passes/patterns.cases.ts';

const KINDS = ['dots', 'lines', 'crosshatch', 'grain'] as const;
/** Turn of the camera in 1/24 s when it orbits in twelve seconds, radians. */
const TURN = (2 * Math.PI) / 12 / 24;

for (const pattern of KINDS) {
  test(`${pattern} move with their puff`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    for (const form of ['lobes', 'billboards'] as const) {
      const style = { pattern, form, patternCoverage: 0.4 } as const;
      const { changed, compared } = await cases.evaluate((module, given) => module.moved(given), style);
      expect(compared).toBeGreaterThan(3000);
      expect(changed).toBeLessThan(0.005 * compared);
    }
  });

  test(`${pattern} cover their amount of puffs of any size, and appear one by one`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    for (const patternCoverage of [0.15, 0.3, 0.5]) {
      // The noise of fewer and larger grains has another mean.
      const patternSize = pattern === 'grain' ? 2.5 : 5;
      const input = [{ pattern, patternCoverage, patternSize }, [45, 60, 80]] as const;
      const shares = await cases.evaluate((module, given) => module.shares(...given), input);
      console.log(pattern, patternCoverage, shares.map((share) => share.toFixed(3)).join(' '));
      const slack = pattern === 'grain' ? 0.06 : 0.04;
      for (const share of shares) expect(Math.abs(share - patternCoverage)).toBeLessThan(slack);
    }
    const input = [{ pattern, patternCoverage: 0.4, patternSize: 6 }, 72] as const;
    const changes = await cases.evaluate((module, given) => module.changesByGrowth(...given), input);
    console.log(pattern, 'growth', Math.max(...changes).toFixed(3));
    expect(changes).toHaveLength(72);
    expect(Math.max(...changes)).toBeLessThan(0.08);
  });

  test(`${pattern} on smoke stay on its surface as the camera orbits, and stand still with it${longIf(pattern !== 'dots')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const values = { 'style.pattern': pattern, 'style.patternCoverage': 0.4, 'style.patternOn': 'both' } as const;
    const changes = await cases.evaluate((module, given) => module.orbit('lamp', ...given), [values, TURN] as const);
    console.log(pattern, JSON.stringify(changes));
    expect(changes.points).toBeGreaterThan(5000);
    expect(changes.fixed).toBeGreaterThan(0.02);
    expect(changes.followed).toBeLessThan(0.5 * changes.fixed);
    const still = await cases.evaluate((module, given) => module.orbit('lamp', ...given), [values, 0] as const);
    expect(still.followed).toBe(0);
  });
}

for (const pattern of KINDS) {
  test(`${pattern} on the backdrop join themselves where a full turn of the camera ends`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const values = {
      'style.pattern': pattern,
      'style.patternCoverage': 0,
      'style.patternBackdrop': 0.8,
      'style.patternColor': '#000000',
      'style.backdrop': '0:ffffff,1:fffffe',
    } as const;
    const { atEnd, inDegree } = await cases.evaluate((module, given) => module.changesAtTurn(given), values);
    expect(inDegree).toBeGreaterThan(0.05);
    expect(atEnd).toBeLessThan(0.001);
  });
}

for (const simplify of [0, 3]) {
  test(`without marks the frame is as it was before them, simplified by ${simplify} px`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { calls, isSame } = await cases.evaluate((module, given) => module.switched(given), { simplify });
    const [before, during, after] = calls;
    expect(during).toBeGreaterThan(before);
    expect(after).toBe(before);
    expect(isSame).toBe(true);
  });
}

for (const [what, one, other, isSame] of [
  [
    'at any pixel ratio',
    { style: { pattern: 'dots', patternSize: 4 }, pixelRatio: 2 },
    { style: { pattern: 'dots', patternSize: 8 } },
    true,
  ],
  ['with the edge filter', { style: { pattern: 'lines' }, smoothEdges: true }, { style: { pattern: 'lines' } }, true],
  ['at another angle', { style: { pattern: 'dots' } }, { style: { pattern: 'dots', patternAngle: 20 } }, false],
  ['out of register', { style: { pattern: 'dots' } }, { style: { pattern: 'dots', patternShiftX: 3 } }, false],
] as const) {
  test(`marks are ${isSame ? 'the same' : 'elsewhere'} ${what}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const found = await cases.evaluate((module, given) => module.differing(...given), [one, other] as const);
    expect(found.marked).toBeGreaterThan(500);
    if (isSame) expect(found.differing).toBeLessThan(20);
    else expect(found.differing).toBeGreaterThan(1000);
  });
}
