import { expect, longIf, test } from '../../../../support/fixtures.ts';

type Cases = typeof import('./simplify.cases.ts');
const CASES = '/tests/visual/renderer/passes/simplify/simplify.cases.ts';

/** A Gaussian of deviation s leaves less than half of a disc in its middle if the radius is below s sqrt(2 ln 2). */
const GONE_BELOW = Math.sqrt(2 * Math.LN2);
const DEVIATION = 6;

test('a patch of shade vanishes below the size that the Gaussian says, and grows out of nothing @long', async ({
  load,
}) => {
  const cases = await load<Cases>(CASES);
  const radii = [-0.3, -0.2, -0.1, 0, 0.1, 0.3, 0.6, 0.9].map((step) => DEVIATION * (GONE_BELOW + step));
  for (const pixelRatio of [1, 2]) {
    const areas = await cases.evaluate((module, given) => module.shadowAreas(...given), [
      radii,
      DEVIATION,
      pixelRatio,
    ] as const);
    const visible = areas.findIndex((area) => area > 0);
    expect.soft(radii[visible] / DEVIATION, `${pixelRatio}`).toBeGreaterThan(GONE_BELOW - 0.21);
    expect.soft(radii[visible] / DEVIATION, `${pixelRatio}`).toBeLessThan(GONE_BELOW + 0.1);
    areas.slice(visible).reduce((before, area) => {
      expect.soft(area).toBeGreaterThan(before);
      return area;
    }, 0);
    expect.soft(areas.at(-1)! / pixelRatio ** 2).toBeGreaterThan(100);
  }
});

test('a small patch of shade vanishes wherever it is in the tiles of the picture', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const radius of [3, 8]) {
    const shifts = [0, 1, 2, 3, 4, 5, 6, 7];
    const areas = await cases.evaluate((module, given) => module.shadowAreasAt(...given), [shifts, radius] as const);
    expect.soft(Math.min(...areas.map(({ plain }) => plain))).toBeGreaterThan(2 * radius ** 2);
    expect.soft(areas.map(({ smooth }) => smooth)).toEqual(areas.map(() => 0));
  }
  // On a surface all light is equal.
  const inOneTile = (deviation: number) =>
    cases.evaluate((module, given) => module.shadowAreasOnWall([3], given), deviation);
  expect.soft((await inOneTile(0))[0]).toBeGreaterThan(18);
  expect.soft(await inOneTile(8)).toEqual([0]);
});

test('large shapes keep their size, on smoke and on surfaces', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const onSmoke = await cases.evaluate((module) => module.shadowAreas([30], 4, 1));
  const onWall = await cases.evaluate((module) => module.shadowAreasOnWall([4, 30], 4));
  expect.soft(onWall[0]).toBe(0);
  for (const area of [onSmoke[0], onWall[1]]) {
    expect.soft(area / (Math.PI * 30 ** 2)).toBeGreaterThan(0.95);
    expect.soft(area / (Math.PI * 30 ** 2)).toBeLessThan(1.01);
  }
});

test('light is smoothed within one colour and depth only', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const left = (name: 'same' | 'otherTint' | 'nearer') =>
    cases.evaluate((module, which) => module.shareLeft(which), name);
  expect.soft(await left('same')).toBe(0);
  expect.soft(await left('otherTint')).toBeGreaterThan(0.85);
  expect.soft(await left('nearer')).toBeGreaterThan(0.85);
});

test('light is not smoothed across ink', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { shadow, changed } = await cases.evaluate((module) => module.acrossInk());
  expect.soft(shadow).toBeGreaterThan(5000);
  expect.soft(changed).toBe(0);
});

test('smoothing adds no colours', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { changed, added } = await cases.evaluate((module) => module.allTones());
  expect.soft(changed).toBeGreaterThan(500);
  expect.soft(added).toEqual([]);
});

/** Display-encoded, as `0:000000,.5:ffffff` of the paper. */
const BLACK_AND_WHITE = [
  { from: 0, color: [0, 0, 0] },
  { from: 0.5, color: [255, 255, 255] },
] as const;
const BY_HEIGHT = { gradient: 'height', gradientColor: [90, 160, 250], gradientHeights: [-0.7, 0.7] } as const;

for (const [what, style] of [
  ['a black tone of shadow', { stops: BLACK_AND_WHITE }],
  ['a gradient on a black tone of shadow', { stops: BLACK_AND_WHITE, ...BY_HEIGHT }],
  ['a gradient without ambient light', { illumination: { direct: [1, 1, 1], ambient: [0, 0, 0] }, ...BY_HEIGHT }],
  ['a gradient to a lighter colour', { smokeColor: [120, 90, 40], tones: 3, fill: 0.5, ...BY_HEIGHT }],
] as const) {
  test(`smoothing does not change the middle of tones, with ${what}${longIf(what.includes('gradient'))}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const { largest, pixels } = await cases.evaluate((module, given) => module.inMiddleOfTones(given), style);
    expect.soft(largest).toBeLessThanOrEqual(2);
    expect.soft(Object.keys(pixels).length).toBeGreaterThan(1);
    expect.soft(Math.min(...Object.values(pixels))).toBeGreaterThan(30);
  });
}

test('a picture does not depend on the frame before it', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.repeated())).toBe(0);
});

// The smaller one is drawn in all tiles.
for (const [width, height, least] of [
  [203, 157, 300],
  [61, 53, 30],
] as const) {
  test(`only tiles that keep their pixels are left out of ${width} x ${height}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { differing, smoothed } = await cases.evaluate((module, size) => module.everyTile(...size), [
      width,
      height,
    ] as const);
    expect.soft(smoothed).toBeGreaterThan(least);
    expect.soft(differing).toBe(0);
  });
}
