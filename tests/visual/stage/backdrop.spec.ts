import { readRamp } from '../../../src/parameters/ramp.ts';
import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./backdrop.cases.ts');
const CASES = '/tests/visual/stage/backdrop.cases.ts';
const OWN = '0:c86432,1:0a141e';

const many = Array.from(
  { length: 16 },
  (_, stop) => `${(stop / 15).toFixed(3)}:${(0x0f1357 * (stop + 1)).toString(16).padStart(6, '0').slice(-6)}`,
);
const RAMPS: Readonly<Record<string, string>> = {
  'the colours of the scene': '',
  'two colours at the ends': '0:1b4a8c,1:e9dfc6',
  'two colours within': '.25:1b4a8c,.6:e9dfc6',
  'three colours': '0:101820,.3:7a2048,1:f2aa4c',
  'a hard step': '0:8ff0ec,.499:8ff0ec,.5:1668d8,1:101010',
  stripes: '.199:ffffff,.2:c8102e,.6:c8102e,.601:ffffff,.9:012169',
  'the most colours': many.join(','),
};

/** The colour at a height 0..1: flat before the first stop and after the last, linear between two. */
function colorAt(ramp: string, height: number): number[] {
  const stops = readRamp(ramp)!.map(({ at, color }) => ({
    at,
    channels: [1, 3, 5].map((digit) => Number.parseInt(color.slice(digit, digit + 2), 16)),
  }));
  const after = stops.findIndex(({ at }) => at >= height);
  if (after <= 0) return stops.at(after)!.channels;
  const [low, high] = [stops[after - 1], stops[after]];
  const share = (height - low.at) / (high.at - low.at);
  return low.channels.map((channel, index) => channel + share * (high.channels[index] - channel));
}

test('the backdrop has its colours at their heights', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const [name, ramp] of Object.entries(RAMPS)) {
    const rows = await cases.evaluate((module, text) => module.rowsOf(text), ramp);
    rows.forEach(([red, green, blue, alpha], row) => {
      const expected = colorAt(ramp || OWN, (row + 0.5) / rows.length);
      const error = Math.max(...expected.map((channel, index) => Math.abs(channel - [red, green, blue][index])));
      expect(error, `${name}, row ${row}`).toBeLessThan(0.51);
      expect(alpha).toBe(255);
    });
  }
});
