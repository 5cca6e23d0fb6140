import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./looks.cases.ts');
type Given = Parameters<Cases['sameColors']>;
const CASES = '/tests/visual/renderer/looks.cases.ts';

const RAMP = '0:301050,.3:9040a0,.6:ffd0f0';
const BY_AGE = '0:ffffff,.4:80ff60,.8:204080';
const BY_HEAT = '0:404050,.3:c04020,.8:ffe080';
const HEATS = [
  { from: 0, color: [90, 90, 110] },
  { from: 0.4, color: [250, 160, 90] },
] as const;
const STOPS = [
  { from: 0, color: [60, 60, 90] },
  { from: 0.4, color: [180, 170, 170] },
  { from: 0.8, color: [250, 245, 230] },
] as const;
const GLOW = [
  { at: 0.2, value: 0 },
  { at: 0.8, value: 1 },
] as const;

/** Styles and settings in which each pass that reads looks draws. */
const PICTURES = {
  plain: [{}, {}],
  'three tones, fill and rim': [{ tones: 3, fill: 0.5, rim: 0.6, inkSwell: 0.4, boil: 0.5 }, {}],
  billboards: [{ form: 'billboards', fill: 0.5 }, {}],
  'flat puffs': [{}, { failsSelfTest: true }],
  'simplified light': [{ simplify: 2 }, {}],
  'light of the whole form': [{ simplify: 2, plumeForm: 0.6, isBlended: true, stops: STOPS }, {}],
  'three tones of the whole form': [{ simplify: 2, plumeForm: 0.6, tones: 3 }, {}],
  strokes: [{ strokes: 1, isDeformed: true }, { pixelRatio: 2 }],
  pattern: [{ pattern: 'dots', patternCoverage: 0.4 }, {}],
  'a lamp that fades': [{ lampLight: [1, 1, 1] }, { lamp: [1, 2, 1] }],
  'lights besides the key light': [{ hasAdditionalLights: true, glow: GLOW, heatColors: HEATS }, {}],
  bites: [{ isEroded: true, isDeformed: true }, { erosion: 0.5 }],
  selle: [{ renderer: 'selle' }, {}],
  normals: [{}, { view: 'normals' }],
} as const;

for (const [name, [style, setting]] of Object.entries(PICTURES)) {
  test(`looks with the colours of the smoke draw the same pixels as none: ${name}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const found = await cases.evaluate((module, given) => module.sameColors(...given), [
      style,
      setting,
    ] as unknown as Given);
    expect(found).toMatchObject({ differing: 0 });
    expect(found.colors).toBeGreaterThan(8);
  });

  test(`smoke of an emitter has the colours of its look: ${name}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const found = await cases.evaluate(
      (module, [base, given, ramps]) => {
        const [stops, ageColors, heatColors] = ramps.map((ramp) => module.tonesOf(ramp));
        const look = { colors: ramps[0], ageColors: ramps[1], heatColors: ramps[2] };
        return module.looksAsStyle(base, look, { stops, ageColors, heatColors }, given);
      },
      [style, setting, [RAMP, BY_AGE, BY_HEAT]] as unknown as [...Given, string[]],
    );
    expect(found).toMatchObject({ differing: 0 });
    expect(found.colors).toBeGreaterThan(8);
  });
}

for (const form of ['lobes', 'billboards'] as const) {
  for (const weight of [0, 0.5, 2]) {
    test(`lines of ${form} with the ink weight ${weight} are those of smoke with such outlines`, async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const found = await cases.evaluate(
        (module, [given, inkWeight]) =>
          module.looksAsStyle({ form: given, inkSwell: 0.4 }, { inkWeight }, { outlineWidth: 2 * inkWeight }),
        [form, weight] as const,
      );
      expect(found).toMatchObject({ differing: 0 });
    });
  }
}

test('strokes have the ink weight of a look', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const found = await cases.evaluate((module) =>
    module.looksAsStyle({ strokes: 1 }, { inkWeight: 2 }, { outlineWidth: 4 }, { pixelRatio: 2 }),
  );
  expect(found).toMatchObject({ differing: 0 });
});

test('an emitter with a tint and no colours has the colours of the tint', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const found = await cases.evaluate((module) =>
    module.looksAsStyle({}, { tint: 5, inkWeight: 2 }, { smokeColor: [127, 178, 229], outlineWidth: 4 }),
  );
  expect(found).toMatchObject({ differing: 0 });
});

test('puffs that tear have the bites of smoke that tears', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const found = await cases.evaluate((module) =>
    module.looksAsStyle(
      { shadows: false },
      { dissolve: 3 },
      { isEroded: true, isTorn: true, isDeformed: true, stretch: 4 },
      { erosion: 0.5 },
    ),
  );
  expect(found).toMatchObject({ differing: 0 });
});

for (const isSoft of [false, true]) {
  test(`fifteen looks with ${isSoft ? 'blended ' : ''}colours by age and heat fit into the texture`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const found = await cases.evaluate((module, given) => module.manyLooks(given), isSoft);
    expect(found).toMatchObject({ differing: 0 });
    expect(found.width).toBeGreaterThan(256);
    expect(Math.max(found.width, found.height)).toBeLessThanOrEqual(2048);
  });
}
