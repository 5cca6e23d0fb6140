import fc from 'fast-check';
import { encode, type State } from '../../../src/parameters/codec.ts';
import { presets, presetValues } from '../../../src/parameters/presets.ts';
import { anyState } from '../../support/anyState.ts';
import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./values.cases.ts');
const CASES = '/tests/visual/three/values.cases.ts';

const states: readonly State[] = [
  ...presets.map(({ name }) => ({ preset: name, values: presetValues(name) })),
  ...fc.sample(anyState, { seed: 34, numRuns: 10 }),
];

test('smoke takes the values of each preset and of random states, and what it gives', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module, given) => module.ofSmoke(given), states)).toEqual({});
});

for (const thread of ['main', 'worker'] as const) {
  test(`a stage (${thread}) takes what it gives, for each preset and random states @long`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const found = await cases.evaluate((module, [given, where]) => module.ofStage(given, where), [
      states,
      thread,
    ] as const);
    expect(found).toEqual({});
  });
}

test('smoke ignores what the scene of the host determines, and set names it', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values = { ...presetValues('train'), seed: 7, 'simulation.maxParticles': 900, 'puff.size': 2 };
  const link = await encode({ preset: 'train', values });
  const { errors, kept, bad, hashes, sizes, light } = await cases.evaluate(
    (module, given) => module.ofHost(given),
    link,
  );
  expect(errors.filter((error) => /^ParameterError: .*your scene sets it/.test(error))).toHaveLength(6);
  expect(errors.filter((error) => /^ParameterError: .*at creation only/.test(error))).toHaveLength(2);
  expect(kept).toEqual([]);
  expect(sizes).toEqual([2, 2]);
  expect(light).toEqual([true, true]);
  for (const error of bad) expect(error).toMatch(/^ParameterError: preset cannot be .*(link|preset)/);
  // The capacity has no effect on the first puffs, and nothing else of the host has.
  expect(hashes[0]).toBe(hashes[2]);
  expect(hashes[1]).not.toBe(hashes[2]);
});
