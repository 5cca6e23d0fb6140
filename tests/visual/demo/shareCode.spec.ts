/** The code of the share sheet runs, for each preset. */
import { transform } from 'esbuild';
import { presets } from '../../../src/parameters/presets.ts';
import { readRamp } from '../../../src/parameters/ramp.ts';
import { expect, longIf, test } from '../../support/fixtures.ts';
import type { Kind, Shown } from './shareCode.cases.ts';

type Cases = typeof import('./shareCode.cases.ts');
const CASES = '/tests/visual/demo/shareCode.cases.ts';
const STOPS = { 'style.backdrop': '0:101820,.25:7a2048,.251:f2aa4c,1:ffffff' };

/** The computed style of a backdrop. */
function cssOf(ramp: string): string {
  const stops = readRamp(ramp)!.map(({ at, color }) => {
    const channels = [1, 3, 5].map((digit) => Number.parseInt(color.slice(digit, digit + 2), 16));
    return `rgb(${channels.join(', ')}) ${100 * at}%`;
  });
  return stops.length > 0 ? `linear-gradient(to top, ${stops.join(', ')})` : 'rgb(154, 196, 214)';
}

type Load = Parameters<Parameters<typeof test>[2]>[0]['load'];

/** What the code of each kind shows. */
async function shown(load: Load, kinds: readonly Kind[], ...call: Parameters<Cases['codesFor']>): Promise<Shown[]> {
  const cases = await load<Cases>(CASES);
  const codes = await cases.evaluate((module, given) => module.codesFor(...given), call);
  codes.fiber = (await transform(codes.fiber, { loader: 'jsx' })).code;
  const results: Shown[] = [];
  for (const kind of kinds) {
    results.push(await cases.evaluate((module, [name, code]) => module.run(name, code), [kind, codes[kind]] as const));
    expect(results.at(-1)!.said, kind).toEqual([]);
  }
  return results;
}

/** It has a backdrop with tones. */
const SHOWN = 'lamp-noir';

for (const { name, values } of presets) {
  test(`the code for ${name} shows its smoke${longIf(name !== SHOWN)}`, async ({ load }) => {
    const [three, fiber, element, puff] = await shown(load, ['three', 'fiber', 'element', 'puff'], name);
    for (const { background, covered, alive } of [three, fiber]) {
      expect(background).toBe(cssOf(values['style.backdrop'] ?? ''));
      expect(alive).toBeGreaterThan(0);
      expect(covered).toBeGreaterThan(20);
    }
    expect(element.values).toMatchObject(values);
    expect(puff.covered).toBe(1);
  });
}

test('the code has positions of the backdrop, and runs with other options', async ({ load }) => {
  const options = { isInteractive: true, alt: "It's </script> \\ smoke", width: undefined };
  for (const isTransparent of [false, true]) {
    for (const { background, covered } of await shown(load, ['three', 'fiber'], 'lamp', STOPS, {
      ...options,
      isTransparent,
    })) {
      expect(background).toBe(isTransparent ? 'rgba(0, 0, 0, 0)' : cssOf(STOPS['style.backdrop']));
      expect(covered).toBeGreaterThan(20);
    }
  }
});
