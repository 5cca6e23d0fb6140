import { expect, it } from 'vitest';
import { defaults } from '../../../src/parameters/values.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { glowColors } from '../../../src/renderer/glow.ts';
import { styleOf } from '../../../src/renderer/style.ts';

const FIRE: Values = { ...defaults(), 'style.heatRamp': '0:000000,.5:ff0000,.75:ffffff', 'emission.glow': '.5:0,1:1' };

/** Red, green, blue and luminance at a temperature in 64ths. */
function at(step: number, values: Values): number[] {
  return [...glowColors(styleOf(values))!.subarray(4 * step, 4 * step + 4)];
}

it('is the light of colours by heat times the share that glows, and its luminance', () => {
  expect(at(16, FIRE)).toEqual([0, 0, 0, 0]);
  expect(at(32, FIRE)).toEqual([0, 0, 0, 0]);
  expect(at(40, FIRE)).toEqual([0.25, 0, 0, Math.fround(0.25 * 0.2126)]);
  expect(at(48, FIRE)).toEqual([0.5, 0.5, 0.5, 0.5]);
  expect(at(64, FIRE)).toEqual([1, 1, 1, 1]);
});

it('is that of full light, of the colour of smoke without colours by heat', () => {
  const plain = { ...FIRE, 'style.heatRamp': '', 'style.smokeColor': '#ff0000', 'style.tones': 3 } as const;
  expect(at(64, plain).slice(0, 3)).toEqual([1, 0, 0]);
  const ofStops = { ...plain, 'style.ramp': '0:000000,.5:0000ff' } as const;
  expect(at(64, ofStops).slice(0, 3)).toEqual([0, 0, 1]);
});

it('has few bits, which are the same in every engine', () => {
  const colors = glowColors(styleOf({ ...FIRE, 'style.heatRamp': '0:123456,1:abcdef', 'emission.glow': '0:1,1:1' }))!;
  for (const [index, number] of colors.entries())
    if (index % 4 < 3) expect(number * 65536).toBe(Math.round(number * 65536));
});

it('is nothing without glow', () => {
  expect(glowColors(styleOf(defaults()))).toBeUndefined();
  expect(glowColors(styleOf({ ...FIRE, 'emission.glow': '0:0,.5:0,1:0' }))).toBeUndefined();
});
