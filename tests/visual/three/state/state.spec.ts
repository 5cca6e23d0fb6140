import { expect, test } from '../../../support/fixtures.ts';

type State = typeof import('./state.cases.ts');
const STATE = '/tests/visual/three/state/state.cases.ts';

test('emitFrom without options makes an emitter of its own for each object, with the values of emitter 0', async ({
  load,
}) => {
  const cases = await load<State>(STATE);
  // In 61 steps, without the puff that is born at their end.
  const puffs = (rate: number) => Math.ceil((rate * 61) / 60) - 1;
  expect(await cases.evaluate((module) => module.emitFromObjects())).toEqual({
    none: { 0: puffs(60) },
    two: { 3: puffs(60), 6: puffs(60) },
    'twice the rate': { 3: puffs(120), 6: puffs(120) },
    'one with a rate of its own': { 3: puffs(240), 6: puffs(30) },
    'one disabled': { 6: puffs(30) },
    'and the emitter of the table': { 6: puffs(30), 9: puffs(240) },
    'and attached': { 6: puffs(30), 12: puffs(240) },
    'all removed': {},
    enabled: { 3: puffs(240) },
    nothing: {},
    'a quarter of the rate': { 3: puffs(15), [-5]: puffs(45) },
    'bursts of the table': { 3: 15 },
    'a high rate': { 3: puffs(6000) },
  });
});

test('clear removes the puffs and only them', async ({ load }) => {
  const cases = await load<State>(STATE);
  const { before, ...rest } = await cases.evaluate((module) => module.clear());
  expect(before).toBeGreaterThan(50);
  expect(rest).toEqual({ isItself: true, alive: 0, after: { 3: 60 }, rate: 60, children: true });
});

for (const physics of [true, false])
  test(`restart and restore repeat a run with handles to the last bit, physics ${physics}`, async ({ load }) => {
    const cases = await load<State>(STATE);
    const { steps, first, second, third } = await cases.evaluate((module, given) => module.again(given), physics);
    expect(steps).toBe(0);
    expect(second).toEqual(first);
    expect(third).toEqual(first);
  });

test('a restored state has the handles of now and the values of then', async ({ load }) => {
  const cases = await load<State>(STATE);
  const seen = await cases.evaluate((module) => module.otherHandles());
  expect(seen).toEqual({
    counts: { 8: 60 },
    changed: ['style.tones'],
    rigids: 1,
    message: 'SimulatorError',
    isUnchanged: true,
  });
});

test('a state with more particles than the capacity is an error', async ({ load }) => {
  const cases = await load<State>(STATE);
  expect(await cases.evaluate((module) => module.tooSmall())).toMatch(/120 particles were saved, there is room for 50/);
});

test('all calls take objects and positions within 5,000 m', async ({ load }) => {
  const cases = await load<State>(STATE);
  const seen = await cases.evaluate((module) => module.reach());
  const calls = ['emitFrom', 'emitFrom 0', 'emitFrom', 'burst', 'attach', 'collide', 'pushed', 'cast'];
  expect(seen).toEqual(
    calls.flatMap((call) => [`${call} 4999`, expect.stringMatching(new RegExp(`^${call} .*5001.*5000`))]),
  );
});

test('smoke of one chimney looks as that of the emitter of the table', async ({ load }) => {
  const cases = await load<State>(STATE);
  const { own, table } = await cases.evaluate((module) => module.chimneys());
  expect(own.filter((value, byte) => value !== own[byte % 4]).length).toBeGreaterThan(1000);
  expect(own).toEqual(table);
});
