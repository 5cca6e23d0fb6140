import { readTimeline, valueAt } from '../../../src/parameters/timeline.ts';
import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./timeline.cases.ts');
const CASES = '/tests/visual/stage/timeline.cases.ts';

test.describe('before the code of timelines is loaded', () => {
  test.use({ ownPage: true });

  test('a timeline gives the hash of other ways to get it; steps wait', async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { first, hashes } = await cases.evaluate((module) => module.hashes());
    expect(first).toEqual(['', '0', '100', 'true', 'true']);
    expect(new Set(Object.values(hashes))).toEqual(new Set([hashes.created]));
    const wanted = [hashes.created, 'true', 'timeline.seed'];
    expect(await cases.evaluate((module) => module.remote('main'))).toEqual(wanted);
  });

  test('an invalid timeline is an event and changes nothing', async ({ load }) => {
    const cases = await load<Cases>(CASES);
    expect(await cases.evaluate((module) => module.invalidBefore())).toEqual(['timeline.seed', '', '3']);
  });
});

test(`a timeline gives the same hash in a worker${longIf(true)}`, async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const [main, worker] = [
    await cases.evaluate((module) => module.remote('main')),
    await cases.evaluate((module) => module.remote('worker')),
  ];
  expect(worker).toEqual(main);
});

test('frames of a film at 24 fps have style and camera of their own times, between steps', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { colors, azimuths, base } = await cases.evaluate((module) => module.betweenSteps());
  const times = [0, 6, 12, 13, 14, 30].map((frame) => (frame / 24) * 60);
  const { lanes } = readTimeline('90;style.smokeColor/0*ffffff/60*000000;camera.azimuth/20*0/80*90').timeline;
  expect(colors).toEqual(times.map((time) => valueAt(lanes[0], time)));
  times.forEach((time, frame) => expect(azimuths[frame]).toBeCloseTo(valueAt(lanes[1], time) as number, 6));
  expect(base).toEqual(['#f6efe2', false]);
});

test('smoke keeps the colours of its look while a timeline changes the style', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.looksWhileAnimated())).toEqual([true, true, true]);
});

test('the code of later pictures is loaded before the first one', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.strokesLater())).toEqual([true, true]);
});

test('an invalid timeline is an error with its place and changes nothing', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.invalid())).toEqual({
    create: 'timeline.emission.rate',
    set: 'timeline.emission.rate',
    object: 'timeline.length',
    enter: 'timeline.emission.rate',
    left: '60;emission.rate/0*5',
    events: '0',
  });
});
