import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./programs.cases.ts');

for (const [lobes, failsSelfTest] of [
  [10, false],
  [6, false],
  [10, true],
] as const) {
  const puffs = `${failsSelfTest ? 'flat ' : ''}puffs of ${lobes} lobes`;
  test(`all programs of a picture are compiled in advance, and none twice: ${puffs}${longIf(lobes === 6)}`, async ({
    load,
  }) => {
    const cases = await load<Cases>('/tests/visual/stage/programs.cases.ts');
    const { ahead, drawing } = await cases.evaluate((module, given) => module.programsOfWisp(...given), [
      lobes,
      failsSelfTest,
    ] as const);
    expect(ahead.length).toBeGreaterThan(10);
    expect(new Set(ahead).size).toBe(ahead.length);
    expect(drawing).toEqual([]);
  });
}

for (const [preset, strokes] of [
  ['wisp', 0],
  ['cloudscape', 3],
  ['train', 3],
] as const) {
  const tag = longIf(preset !== 'train');
  test(`light that follows the form, and strokes, are compiled in advance: ${preset}${tag}`, async ({ load }) => {
    const cases = await load<Cases>('/tests/visual/stage/programs.cases.ts');
    const { ahead, drawing } = await cases.evaluate((module, name) => module.programsOfPreset(name), preset);
    expect(ahead.filter((shaders) => shaders.includes('#define FORM'))).toHaveLength(1);
    expect(ahead.filter((shaders) => shaders.includes('#define TILE'))).toHaveLength(strokes);
    expect(drawing).toEqual([]);
  });
}
