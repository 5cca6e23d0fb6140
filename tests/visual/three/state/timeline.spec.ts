import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./timeline.cases.ts');
const CASES = '/tests/visual/three/state/timeline.cases.ts';

test.describe('before the code of timelines is loaded', () => {
  test.use({ ownPage: true });

  test('smoke with a timeline has the hash of other ways to get it; steps wait', async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { first, hashes } = await cases.evaluate((module) => module.hashes());
    expect(first).toEqual(['0', '', '0', '100', 'true']);
    expect(new Set(hashes).size).toBe(1);
  });

  test('an invalid timeline is an event, and an error afterwards', async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const wanted = [['timeline.length'], 'timeline.emission.rate', 'timeline.emission.rate', ''];
    expect(await cases.evaluate((module) => module.invalid())).toEqual(wanted);
  });
});

test('a value that a caller sets holds until the next keyframe, also in a restored state', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { rates, same, base, loose } = await cases.evaluate((module) => module.held());
  expect(rates).toEqual([7, 7, 40]);
  expect(base).toBe(7);
  expect([same, loose]).toEqual([true, true]);
});

test('an object that follows emitter 0 emits as the timeline says', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { same, alive } = await cases.evaluate((module) => module.follower());
  expect(same).toBe(true);
  expect(alive[0]).toBe(0);
  expect(alive[1]).toBeGreaterThan(10);
});

test('smoke is drawn with the values of its time, except for what the scene of the host sets', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { colors, light, hasDrawn } = await cases.evaluate((module) => module.drawn());
  // Half a step before step 1, and step 30.
  expect(colors).toEqual(['#fdfdfd', '#808080', expect.stringMatching(/^#/)]);
  expect(colors[2]).not.toBe('#808080');
  expect([light, hasDrawn]).toEqual(['sun', true]);
});
