/** Each mistake that has no visible effect is reported once in development, and never in production. */
import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./warnings.cases.ts');
const CASES = '/tests/visual/development/warnings.cases.ts';

const UNAWAITED =
  /^CartoonSmoke\.create\(\): \.(isObject3D|update|visible) was read from a promise\. Write “await CartoonSmoke\.create\(\)”/;
const SINCE_START = /^CartoonSmoke: update\([\d.]+\) looks like the time since the start\./;
const NAN = /^CartoonSmoke: ParameterError: seconds cannot be NaN/;
const NO_BOX = /^puff\(\): The target has no box/;

/** A regular expression that several situations share is the same warning. */
const WARNINGS: Readonly<Record<string, RegExp>> = {
  'update is never called': /^CartoonSmoke: The scene is rendered, but update\(\) was never called/,
  'smoke in no scene': /^CartoonSmoke: The smoke is in no scene .* Call scene\.add\(smoke\)\.$/,
  'smoke in a group that is in no scene': /^CartoonSmoke: The scene that the smoke is in is not rendered/,
  'update(16.7)': /^CartoonSmoke: update\(16\.7\) looks like milliseconds\. Pass seconds/,
  'update(performance.now())': SINCE_START,
  'update(clock.getElapsedTime())': SINCE_START,
  'two updates in each frame': /^CartoonSmoke: update\(\) is called twice in each frame/,
  'update(NaN)': NAN,
  'update() without a number': /^CartoonSmoke: ParameterError: seconds cannot be undefined/,
  'an object at NaN': /^CartoonSmoke: ParameterError: emitFrom\.object cannot be .*NaN/,
  'update after dispose': /^CartoonSmoke: SimulatorError: This smoke was disposed/,
  'update(NaN) of <Smoke>': NAN,
  'scene.add(promise)': UNAWAITED,
  'promise.update()': UNAWAITED,
  'promise.visible = false': UNAWAITED,
  'createStage(canvas).play': /^createStage\(\): \.play was read from a promise\. Write “await createStage\(\)”/,
  'smokes that nobody disposes': /^CartoonSmoke: More than 16 smokes exist/,
  "puff(document.querySelector('.none'))": /^puff\(\): The target is null, so smoke starts in the middle/,
  'puff of a hidden element': NO_BOX,
  'puff of an element without a size': NO_BOX,
  'puff of an element outside of the document': NO_BOX,
  'puff with reduced motion': /^puff\(\): The system prefers reduced motion/,
  'puff of an unknown effect': /^puff\(\): ParameterError: effect cannot be .*poofs/,
  'puff of a selector': /^puff\(\): ParameterError: target cannot be .*none/,
  'puff of an unknown preset': /^puff\(\): ParameterError: preset cannot be .*lampp/,
};

/** The situations in rounds, in each of which a warning is that of one situation only. */
const rounds: string[][] = [];
const seen = new Map<RegExp, number>();
for (const [situation, warning] of Object.entries(WARNINGS)) {
  const round = seen.get(warning) ?? 0;
  seen.set(warning, round + 1);
  (rounds[round] ??= []).push(situation);
}

test.use({ ownPage: true });

for (const [round, names] of rounds.entries()) {
  const tag = longIf(round > 0);
  test(`in development each of ${names.length} mistakes is reported once (${round + 1})${tag}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const lines = await cases.evaluate((module, some) => module.written('development', some), names);
    const expected = names.map((name) => [name, [expect.stringMatching(WARNINGS[name])]]);
    expect(lines).toEqual(Object.fromEntries(expected));
  });
}

test('in production none is reported', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const lines = await cases.evaluate((module, some) => module.written('production', some), rounds[0]);
  expect(Object.keys(lines)).toEqual(rounds[0]);
  expect(Object.values(lines).flat()).toEqual([]);
});

test('correct programs write nothing in development', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const lines = await cases.evaluate((module) => module.written('development', Object.keys(module.correct)));
  expect(Object.keys(lines).length).toBeGreaterThan(5);
  expect(Object.values(lines).flat()).toEqual([]);
});
