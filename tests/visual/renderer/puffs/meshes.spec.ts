import { expect, longIf, test } from '../../../support/fixtures.ts';
import { expectSame } from '../sameness.ts';

type Cases = typeof import('./meshes.cases.ts');
const CASES = '/tests/visual/renderer/puffs/meshes.cases.ts';

for (const [what, names, light, trials] of [
  ['meshes', ['rings', 'heart', 'torus', 'popcorn', 'sheet'], 'sun', 150],
  ['meshes', ['rings', 'heart', 'torus', 'popcorn', 'sheet'], 'lamp', 150],
  ['cards', ['heartCard', 'letterO', 'leaf'], 'sun', 200],
  ['cards', ['heartCard', 'letterO', 'leaf'], 'lamp', 230],
] as const) {
  test(`lone ${what} under a ${light} mask none of their own lit pixels${longIf(light === 'lamp')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, given) => module.masked(...given), [names, light, trials] as const);
    expect(report.lit).toBeGreaterThan(30_000);
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

for (const [what, names, sides, style, mostCasters, mostInside] of [
  ['meshes', ['heart', 'popcorn', 'face'], 1, {}, 0.8, 0.3],
  ['meshes', ['heart', 'popcorn', 'face'], 8, {}, 0.8, 0.3],
  ['cards', ['heartCard', 'letterO', 'leaf'], 1, {}, 0.9, 0.5],
  ['cards with counted volumes', ['heartCard', 'letterO', 'leaf'], 8, { volumes: 'counted' }, 1, 0.7],
] as const) {
  test(`culling changes no pixel of a dense plume of ${what} from ${sides} sides${longIf(what !== 'cards')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const comparisons = await cases.evaluate((module, given) => module.culled(...given), [
      names,
      sides,
      style,
    ] as const);
    expectSame(comparisons);
    for (const { bodies, casters } of comparisons) {
      process.stdout.write(`bodies ${bodies.join(' of ')}, casters ${casters.join(' of ')}\n`);
      expect(casters[0]).toBeLessThan(mostCasters * casters[1]);
    }
    const [, inside] = comparisons;
    expect(inside.bodies[0]).toBeLessThan(mostInside * inside.bodies[1]);
  });
}

test('culling changes no pixel of a dense plume of a sheet @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expectSame(await cases.evaluate((module) => module.culled(['sheet'], 1)));
});

test('puffs of a sheet look like the puffs that it was made of @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { covered, different } = await cases.evaluate((module) => module.besideSheet());
  process.stdout.write(`${different} of ${covered} covered pixels differ\n`);
  expect(covered).toBeGreaterThan(40_000);
  expect(different).toBeLessThan(0.01 * covered);
});

test('with eight views, the seeds of puffs select their sides; the simulation does not change @long', async ({
  load,
}) => {
  const cases = await load<Cases>(CASES);
  const front = await cases.evaluate((module) => module.sidesShown(1));
  const around = await cases.evaluate((module) => module.sidesShown(8));
  expect(front.warm).toBeGreaterThan(1000);
  expect(around.warm).toBeGreaterThan(500);
  expect(around.cold).toBeGreaterThan(front.cold + 500);
  expect(around.hash).toBe(front.hash);
});
