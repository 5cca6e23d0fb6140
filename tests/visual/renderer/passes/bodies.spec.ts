import type { Style } from '../../../../src/renderer/style.ts';
import { expect, longIf, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./puffs.cases.ts');
const CASES = '/tests/visual/renderer/passes/puffs.cases.ts';

type LonePuffs = typeof import('./lonePuffs.cases.ts');
const LONE_PUFFS = '/tests/visual/renderer/passes/lonePuffs.cases.ts';

type NearPlane = typeof import('./nearPlane.cases.ts');
const NEAR_PLANE = '/tests/visual/renderer/passes/nearPlane.cases.ts';

for (const light of ['sun', 'lamp'] as const) {
  const tag = longIf(light === 'lamp');
  test(`puffs with bites under a ${light} mask none of their own lit pixels${tag}`, async ({ load }) => {
    const cases = await load<LonePuffs>(LONE_PUFFS);
    const report = await cases.evaluate(
      (module, kind) => module.selfMasked('lobes', kind, 200, undefined, { tones: 3, isEroded: true }),
      light,
    );
    expect(report.lit).toBeGreaterThan(30_000);
    expect(report.masked).toBe(0);
  });
}

test('puffs with twelve lobes have bites only on GPUs with more varyings than WebGL 2 guarantees @long', async ({
  load,
}) => {
  const cases = await load<LonePuffs>(LONE_PUFFS);
  const [guaranteed, more] = await cases.evaluate((module) => [15, 17].map(module.bittenPixels));
  expect(guaranteed).toEqual({ differing: 0, error: 0 });
  expect(more.differing).toBeGreaterThan(1000);
  expect(more.error).toBe(0);
});

for (const form of ['lobes', 'billboards'] as const) {
  test.describe(form, () => {
    test('near the camera, puffs and their shadows have the same size', async ({ load }) => {
      const cases = await load<NearPlane>(NEAR_PLANE);
      for (const depth of [0.6, 1, 1.5, 2.5]) {
        const { puff, shadow } = await cases.evaluate((module, input) => module.shadowBehind(...input), [
          form,
          depth,
        ] as const);
        expect(puff, `${depth} radii`).toBeGreaterThan(depth > 0.8 ? 1_000 : 100);
        expect(shadow, `${depth} radii`).toBeLessThan(10);
      }
    });

    test('a camera flies through them without a jump of the picture', async ({ load }) => {
      const cases = await load<NearPlane>(NEAR_PLANE);
      const shares = await cases.evaluate((module, shape) => module.flight(shape, 100), form);
      const steps = shares.slice(1).map((share, index) => Math.abs(share - shares[index]));
      expect(Math.max(...shares)).toBeGreaterThan(0.6);
      expect(Math.max(...steps)).toBeLessThan(0.06);
    });

    for (const light of ['sun', 'lamp'] as const) {
      const tag = longIf(light === 'sun');
      test(`unshadowed puffs under a ${light} mask none of their own lit pixels${tag}`, async ({ load }) => {
        const cases = await load<LonePuffs>(LONE_PUFFS);
        const report = await cases.evaluate((module, input) => module.selfMasked(...input, 200), [
          form,
          light,
        ] as const);
        expect(report.lit).toBeGreaterThan(50_000);
        expect(report.masked).toBe(0);
      });
    }

    test('they mask nothing with an early ramp, a fill light and a rim light', async ({ load }) => {
      const cases = await load<LonePuffs>(LONE_PUFFS);
      const report = await cases.evaluate(
        (module, shape) => module.selfMasked(shape, 'sun', 150, undefined, module.EARLY),
        form,
      );
      expect(report.lit).toBeGreaterThan(50_000);
      expect(report.masked).toBe(0);
    });

    test('custom tones, fill light, rim light and colours by heat are drawn exactly', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const { found, allowed } = await cases.evaluate((module, shape) => module.chosenColors(shape), form);
      expect(Object.keys(found).sort()).toEqual([...new Set(allowed)].sort());
    });

    test('a gradient by height does not move while smoke appears and dies', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const { differing, shades } = await cases.evaluate((module, shape) => module.heightUnrest(shape), form);
      expect(shades).toBeGreaterThan(40);
      expect(differing).toBe(0);
    });

    test('a gradient by height follows the relief at any camera elevation', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const reports = await cases.evaluate((module, shape) => module.heightErrors(shape), form);
      expect(reports).toHaveLength(8);
      for (const { looked, worst, ...view } of reports) {
        expect(looked, JSON.stringify(view)).toBeGreaterThan(5_000);
        // Billboards are baked in texels.
        expect(worst, JSON.stringify(view)).toBeLessThan(form === 'lobes' ? 1.01 : 2.5);
      }
    });

    test('two tones show exactly the ramp, the ink and the page', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const { found, allowed } = await cases.evaluate((module, shape) => module.toneColors(shape), form);
      expect(Object.keys(found).sort()).toEqual([...allowed].sort());
    });

    test('tinted puffs have the tones of their tint, all others those of the smoke', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      for (const { tint, found, expected } of await cases.evaluate((module, shape) => module.tintColors(shape), form)) {
        expect(found, `tint ${tint}`).toEqual(expected);
      }
    });

    test('ink has the ink colour in light, in shade and in shadow', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const report = await cases.evaluate((module, shape) => module.inkColors(shape), form);
      for (const { ink, nearInk } of Object.values(report)) {
        expect(ink).toBeGreaterThan(200);
        expect(nearInk).toBe(0);
      }
    });

    test('ink shows between two puffs only where the gap is over the threshold', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const [under, over] = await cases.evaluate(
        (module, shape) => [module.innerInk(shape, 'under'), module.innerInk(shape, 'over')],
        form,
      );
      expect(under).toBe(0);
      expect(over).toBeGreaterThan(150);
    });

    test('with a taper a line between puffs widens from 0 at the threshold to its full width', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const [under, between, twice, full] = await cases.evaluate(
        (module, shape) => [
          module.innerInk(shape, 'under', 1),
          module.innerInk(shape, 'under', 1, 1.9),
          module.innerInk(shape, 'over', 1, 2),
          module.innerInk(shape, 'over', 0, 2),
        ],
        form,
      );
      expect(under).toBe(0);
      expect(between).toBeGreaterThan(0);
      expect(between).toBeLessThan(0.9 * full);
      expect(twice).toBe(full);
    });

    test('drawing order does not change the picture', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const { differing, painted, pixels } = await cases.evaluate(
        (module, shape) => module.orderSensitivity(shape),
        form,
      );
      expect(painted).toBeGreaterThan(10_000);
      expect(differing / pixels).toBeLessThanOrEqual(0.0001);
    });

    test('a reversed depth buffer does not change the picture', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const report = await cases.evaluate((module, shape) => module.reversalSensitivity(shape), form);
      expect(report.painted).toBeGreaterThan(10_000);
      expect(report.differing / report.painted).toBeLessThan(0.002);
    });

    for (const [radius, distance, variation, ink] of [
      [0.8, 3, 0, 0],
      [0.8, 3, 1, 0],
      [0.5, 4, 2, 0],
      [0.8, 3, 3, 6],
      [0.4, 3, 1, 3],
    ] as const) {
      const line = ink > 0 ? ` and a line of ${ink} px` : '';
      test(`puff ${variation} of radius ${radius} at ${distance} m covers its silhouette${line}`, async ({ load }) => {
        const cases = await load<Cases>(CASES);
        const report = await cases.evaluate((module, input) => module.outlineError(...input), [
          form,
          radius,
          distance,
          variation,
          ink,
        ] as const);
        expect(report.covered).toBeGreaterThan(2_000);
        expect(report.worst).toBeLessThan(1);
      });
    }

    test('the seam between a puff and a plane is curved', async ({ load }) => {
      const cases = await load<Cases>(CASES);
      expect(await cases.evaluate((module, shape) => module.seamBend(shape), form)).toBeGreaterThan(8);
    });
  });
}

/** The ground has the colour (222, 170, 110). The shadow colour multiplies it. */
const GROUND_SHADOWS = [
  ['is violet without a ramp', {}, '131,93,85,255'],
  ['has the hue of a chosen ramp: (115, 171, 122) of dark green', { stops: 'green' }, '100,114,53,255'],
  ['has the colour that is set', { surfaceShadowColor: [100, 50, 200] }, '87,33,86,255'],
  [
    'has the colour that is set on a chosen ramp',
    { stops: 'green', surfaceShadowColor: [100, 50, 200] },
    '87,33,86,255',
  ],
] as const;
const GREEN = [
  { from: 0, color: [47, 90, 52] },
  { from: 0.5, color: [255, 255, 255] },
] as const;

test('shadow on the ground has the hue of a chosen ramp, or the colour that is set', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const [what, style, expected] of GROUND_SHADOWS) {
    const given = { ...style, ...('stops' in style ? { stops: GREEN } : {}) };
    const found = await cases.evaluate((module, toning) => module.groundColors(toning), given as Partial<Style>);
    expect(Object.keys(found).sort(), what).toEqual(['222,170,110,255', expected].sort());
    expect(found[expected], what).toBeGreaterThan(2_000);
  }
});
