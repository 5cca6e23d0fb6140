import { expect, longIf, test } from '../../../support/fixtures.ts';
import { expectReference } from '../../../support/reference.ts';

type Cases = typeof import('./rotation.cases.ts');
const CASES = '/tests/visual/renderer/puffs/rotation.cases.ts';

const STEP = 1 / 8;
/** Shares of the covered pixels: changes are along borders and vanish with the angle. */
const MAX_CHANGED = 0.015;
/**
 * Change caused by switching between baked views, for comparison: the angle between adjacent views in degrees, and the
 * memory for half floats and bytes, 64 x 64 texels per view and four variations.
 */
const BAKED = [64, 256, 1024].map((views) => ({
  views,
  degrees: Math.sqrt(((180 / Math.PI) ** 2 * 4 * Math.PI) / views),
  megabytes: (views * 4 * 64 * 64 * 12 * (4 / 3)) / 2 ** 20,
}));

for (const by of ['orbit', 'roll'] as const) {
  test(`silhouette, normals, depth and ink are continuous under a small ${by}${longIf(by === 'roll')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, input) => module.rotating(...input), [by, STEP, 80] as const);
    console.log(`${by} by ${STEP} degrees:`, report);
    expect(report.covered).toBeGreaterThan(8_000);
    expect(report.largest).toBeLessThan(MAX_CHANGED);
    expect(report.mean).toBeGreaterThan(0);
    for (const { views, degrees, megabytes } of BAKED) {
      const { mean } = await cases.evaluate((module, input) => module.rotating(...input), [by, degrees, 6] as const);
      console.log(
        `${views} baked views, ${degrees.toFixed(1)} degrees apart, ${megabytes.toFixed(0)} MB:`,
        `${(100 * mean).toFixed(0)} % would change at once`,
      );
      expect(mean).toBeGreaterThan(3 * report.largest);
    }
  });
}

test('puffs have the orientation of the CPU for every seed', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const difference = await cases.evaluate((module) => module.differenceOfRotations());
  // The angle of the last seed's axis is 612 radians, of which single precision keeps 6e-5.
  expect(difference).toBeLessThan(1e-3);
});

test('puffs equal the reference from every side', async ({ load }, testInfo) => {
  const cases = await load<Cases>(CASES);
  for (const [by, degrees] of [
    ['orbit', 130],
    ['roll', 57],
  ] as const) {
    const picture = await cases.evaluate((module, input) => module.rotated(...input), [by, degrees] as const);
    await expectReference(`${by} ${degrees} degrees`, picture, testInfo, { maxOfEdges: 0.04 });
  }
});
