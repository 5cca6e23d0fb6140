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
      (module, kind) => module.masked(['rings', 'heart', 'torus', 'popcorn'], kind, 150),
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

test('culling changes no pixel of a dense plume of meshes', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const comparisons = await cases.evaluate((module) => module.culled(['heart', 'popcorn', 'face']));
  expectSame(comparisons);
  for (const { bodies, casters } of comparisons) {
    process.stdout.write(`bodies ${bodies.join(' of ')}, casters ${casters.join(' of ')}\n`);
    expect(bodies[0]).toBeLessThan(0.8 * bodies[1]);
    expect(casters[0]).toBeLessThan(0.8 * casters[1]);
  }
});
