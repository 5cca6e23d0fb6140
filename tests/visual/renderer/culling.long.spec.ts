import type { Values } from '../../../src/parameters/parameter.ts';
import { sceneEntries } from '../../../src/scenes/scenes.ts';
import { expect, test } from '../../support/fixtures.ts';
import type { Comparison } from './culling.cases.ts';
import { expectSame, expectSameFromLess } from './sameness.ts';

type Cases = typeof import('./culling.cases.ts');
const CASES = '/tests/visual/renderer/culling.cases.ts';

const PLACES = ['scene', 'above', 'inside', 'orthographic'] as const;
/** Denser than the lamp preset, so that many particles are hidden and cast shadows. */
const DENSE = { 'simulation.maxParticles': 800, 'emission.rate': 150 };
/** The presets of these scenes have fewer particles than are searched for hidden ones. */
const MORE: Readonly<Record<string, Values>> = {
  air: { 'emission.rate': 80, 'puff.size': 1.5 },
  dust: { 'emission.rate': 10000 },
  lamp: { 'emission.rate': 150 },
  wisp: { 'emission.rate': 80 },
};
const STYLES = {
  plain: {},
  'deep shadow': { shadowSteps: 2, shadowDepth: 3 },
  'deeper shadow': { shadowSteps: 2, shadowDepth: 6 },
  'no shading': { shading: false },
  'wide ink': { outlineWidth: 5, innerLine: 0 },
} as const;

for (const form of ['lobes', 'billboards'] as const) {
  for (const [seconds, light] of [
    [3, 'sun'],
    [6, 'sun'],
    [6, 'lamp'],
  ] as const) {
    test(`culling changes no pixel of the magic lamp of ${form} after ${seconds} s, lit by a ${light}`, async ({
      load,
    }) => {
      const cases = await load<Cases>(CASES);
      const [values, places] = [{ ...DENSE, 'puff.form': form, 'light.kind': light }, PLACES];
      const comparisons = await cases.evaluate(
        (module, input) => module.compareScene(input.values, input.seconds, input.places),
        { values, seconds, places },
      );
      expect(comparisons).toHaveLength(PLACES.length);
      expectSame(comparisons);
    });
  }
}

for (const scene of Object.keys(sceneEntries)) {
  test(`culling changes no pixel of the scene ${scene} from three cameras`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const comparisons: Comparison[] = [];
    for (const seconds of [2, 6]) {
      comparisons.push(
        ...(await cases.evaluate(
          (module, input) => module.compareScene(input.values, input.seconds, ['scene', 'above', 'behind']),
          { values: { preset: scene, ...MORE[scene] }, seconds },
        )),
      );
    }
    expect(comparisons).toHaveLength(6);
    expectSame(comparisons);
  });
}

for (const form of ['lobes', 'billboards'] as const) {
  for (const [name, style] of Object.entries(STYLES)) {
    test(`culling changes no pixel of plumes of ${form}: ${name}`, async ({ load }) => {
      const cases = await load<Cases>(CASES);
      for (const particles of [300, 3000]) {
        const input = { particles, style: { ...style, form }, places: PLACES };
        const comparisons = await cases.evaluate(
          (module, { particles: count, style: look, places }) => module.comparePlume(count, look, places),
          input,
        );
        (particles > 1000 ? expectSameFromLess : expectSame)(comparisons);
      }
    });
  }
}
