/** What drivers do to smoke is recorded: a take replays a performance to the bit, without its source. */
import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./drivers.cases.ts');
const CASES = '/tests/visual/page/drivers.cases.ts';

test.use({ ownPage: true });

for (const name of ['scroll', 'pointer', 'audio', 'midi'] as const) {
  test(`a take replays what ${name} did${longIf(name !== 'scroll')}`, async ({ load, blank }) => {
    const cases = await load<Cases>(CASES);
    // Browsers let sound play after a gesture.
    await blank.mouse.click(5, 5);
    const { played, again, changes } = await cases.evaluate((module, each) => module.replayed(each), name);
    expect(changes).toBeGreaterThan(10);
    expect(again).toEqual(played);
  });
}

for (const thread of ['main', 'worker'] as const) {
  test(`a take replays what scrolling did on a remote stage: ${thread}${longIf(thread === 'main')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const { played, again, changes } = await cases.evaluate((module, each) => module.replayedRemotely(each), thread);
    expect(changes).toBeGreaterThan(10);
    expect(again).toEqual(played);
  });
}

test('scrolling changes smoke in a three.js scene, and not its camera', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { changes, key } = await cases.evaluate((module) => module.hosted());
  expect(changes).toBeGreaterThan(10);
  expect(key).toBe('camera.azimuth');
});

test('a change holds until the next keyframe of its parameter', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.held())).toEqual([40, 40, 90]);
});
