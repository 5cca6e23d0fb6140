import { expect, longIf, test } from '../../../support/fixtures.ts';
import { expectSame } from '../sameness.ts';

type Cases = typeof import('./meshes.cases.ts');
const CASES = '/tests/visual/renderer/puffs/meshes.cases.ts';

for (const light of ['sun', 'lamp'] as const) {
  test(`lone meshes under a ${light} mask none of their own lit pixels${longIf(light === 'lamp')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate(
      (module, kind) => module.masked(['rings', 'heart', 'torus', 'popcorn', 'sheet'], kind, 150),
      light,
    );
    expect(report.lit).toBeGreaterThan(40_000);
    expect(report.masked).toBe(0);
  });
}

for (const style of [{}, { simplify: 4 }]) {
  test(`the colours of a mesh multiply the tones of the ramp ${JSON.stringify(style)}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { found, expected } = await cases.evaluate((module, given) => module.paintedTones(given), style);
    expect(expected.flat()).toHaveLength(4);
    expect(found).toEqual(expected);
  });
}

for (const sides of [1, 8]) {
  test(`culling changes no pixel of a dense plume of meshes from ${sides} sides`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const comparisons = await cases.evaluate(
      (module, count) => module.culled(['heart', 'popcorn', 'face'], count),
      sides,
    );
    expectSame(comparisons);
    for (const { bodies, casters } of comparisons) {
      process.stdout.write(`bodies ${bodies.join(' of ')}, casters ${casters.join(' of ')}\n`);
      expect(casters[0]).toBeLessThan(0.8 * casters[1]);
    }
    const [, inside] = comparisons;
    expect(inside.bodies[0]).toBeLessThan(0.3 * inside.bodies[1]);
  });
}

test('culling changes no pixel of a dense plume of a sheet', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expectSame(await cases.evaluate((module) => module.culled(['sheet'], 1)));
});

test('puffs of a sheet look like the puffs that it was made of', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { covered, different } = await cases.evaluate((module) => module.besideSheet());
  process.stdout.write(`${different} of ${covered} covered pixels differ\n`);
  expect(covered).toBeGreaterThan(40_000);
  expect(different).toBeLessThan(0.01 * covered);
});

test('with eight views, the seeds of puffs select their sides; the simulation does not change', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const front = await cases.evaluate((module) => module.sidesShown(1));
  const around = await cases.evaluate((module) => module.sidesShown(8));
  expect(front.warm).toBeGreaterThan(1000);
  expect(around.warm).toBeGreaterThan(500);
  expect(around.cold).toBeGreaterThan(front.cold + 500);
  expect(around.hash).toBe(front.hash);
});
