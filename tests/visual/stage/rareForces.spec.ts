import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./rareForces.cases.ts');
const CASES = '/tests/visual/stage/rareForces.cases.ts';

test.describe('before the simulator with flows is loaded', () => {
  test.use({ ownPage: true, allowed: /Failed to load resource/ });

  test('a first flow gives the hash of later ones; steps wait', async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { steps, hashes } = await cases.evaluate((module) => module.hashes());
    expect(steps).toEqual([20, 120]);
    expect(new Set(hashes).size).toBe(1);
  });

  test('a failure is an event, and the smoke goes on', async ({ load, blank }) => {
    await blank.route('**/meshes/bindings_bg.wasm*', (route) => route.abort());
    const cases = await load<Cases>(CASES);
    const { errors, steps } = await cases.evaluate((module) => module.failing());
    expect(errors).toEqual(['LoadError']);
    expect(steps).toEqual([0, 5]);
  });
});

test(`flows give the same hash in a worker${longIf(true)}`, async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const [main, worker] = [
    await cases.evaluate((module) => module.remote('main')),
    await cases.evaluate((module) => module.remote('worker')),
  ];
  expect(worker).toBe(main);
});
