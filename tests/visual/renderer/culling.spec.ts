import { expect, longIf, test } from '../../support/fixtures.ts';
import { expectSame } from './sameness.ts';
import type { Values } from '../../../src/parameters/parameter.ts';

type Cases = typeof import('./culling.cases.ts');
const CASES = '/tests/visual/renderer/culling.cases.ts';

test('culling changes no pixel of the lamp @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  // Denser than the lamp preset, so that many particles are hidden.
  const values: Values = { 'simulation.maxParticles': 800, 'emission.rate': 150 };
  const comparisons = await cases.evaluate(
    (module, input) => module.compareScene(input, 4, ['scene', 'above', 'inside']),
    values,
  );
  expect(comparisons).toHaveLength(3);
  expectSame(comparisons);
});

test('culling changes no pixel of smoke in the light of a lamp @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values: Values = {
    'simulation.maxParticles': 800,
    'emission.rate': 150,
    'light.kind': 'lamp',
    'light.azimuth': -60,
  };
  const comparisons = await cases.evaluate(
    (module, input) => module.compareScene(input, 4, ['scene', 'above', 'inside']),
    values,
  );
  expectSame(comparisons);
  for (const { casters } of comparisons) expect(casters[0]).toBeLessThan(0.8 * casters[1]);
});

test('culling changes no pixel of puffs that turn, stretch and unfold', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values: Values = {
    'simulation.maxParticles': 800,
    'emission.rate': 150,
    'puff.turn': 1,
    'puff.stretch': 3,
    'puff.billow': 1,
  };
  const comparisons = await cases.evaluate(
    (module, input) => module.compareScene(input, 4, ['scene', 'inside']),
    values,
  );
  expectSame(comparisons);
});

test('culling changes no pixel of puffs that are eroded @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values: Values = { 'simulation.maxParticles': 800, 'emission.rate': 150, 'emission.dissolve': 'tear' };
  const comparisons = await cases.evaluate(
    (module, input) => module.compareScene(input, 5, ['scene', 'above', 'inside', 'behind']),
    values,
  );
  expectSame(comparisons);
  for (const { bodies } of comparisons) expect(bodies[0]).toBeLessThan(bodies[1]);
});

for (const form of ['lobes', 'billboards'] as const) {
  test(`culling changes no pixel of a dense plume of ${form}${longIf(form === 'billboards')}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const comparisons = await cases.evaluate(
      (module, style) => module.comparePlume(1000, style, ['scene', 'inside', 'orthographic']),
      { form },
    );
    expectSame(comparisons);
    for (const { bodies, casters } of comparisons) {
      expect(bodies[0]).toBeLessThan(0.8 * bodies[1]);
      expect(casters[0]).toBeLessThan(0.8 * casters[1]);
    }
  });
}
