/** Looks that are proposed for random palettes keep their contrasts. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { distance, hexOf, labOf } from '../../../../src/demo/palette/color.ts';
import { changesOf, CONTRAST, KINDS, looksOf, type Look } from '../../../../src/demo/palette/looks.ts';
import { multiply, parseColor, formatColor } from '../../../../src/renderer/palette.ts';
import { mixed } from '../../../../src/renderer/gpu/ramps.ts';
import { readRamp } from '../../../../src/parameters/ramp.ts';
import { presets, presetValues } from '../../../../src/parameters/presets.ts';
import { isAccepted } from '../../../../src/parameters/values.ts';
import type { AnyValues } from '../../../../src/parameters/parameter.ts';
import { findParameter } from '../../../../src/parameters/table.ts';

const lightOf = (color: string) => labOf(color).l;
const looksIn = (colors: readonly string[]) => looksOf(colors.map((color) => ({ color, share: 1 / colors.length })));

/** The least of all contrasts by their names in `CONTRAST`, beside what the backdrop shows between its ends. */
function contrastsOf({ tones, ink, backdrop }: Look): Record<keyof typeof CONTRAST, number> {
  const lights = tones.map(lightOf);
  const [bottom, top] = backdrop.map(parseColor);
  const behind = [0, 0.25, 0.5, 0.75, 1].map((share) => labOf(formatColor(mixed(bottom, top, share))));
  return {
    tones: Math.min(...lights.slice(1).map((light, below) => light - lights[below])),
    ink: Math.min(...lights) - lightOf(ink),
    light: Math.min(...behind.map(({ l }) => Math.abs(l - lights[lights.length - 1]))),
    backdrop: Math.min(...behind.flatMap((color) => tones.map((tone) => distance(labOf(tone), color)))),
  };
}

function expectContrasts(colors: readonly string[]): void {
  for (const look of looksIn(colors)) {
    const contrasts = contrastsOf(look);
    for (const key of Object.keys(CONTRAST) as (keyof typeof CONTRAST)[]) {
      expect(contrasts[key], `${key} of ${look.kind} from ${colors.join()}`).toBeGreaterThanOrEqual(CONTRAST[key]);
    }
    expect(look.tones.length).toBeGreaterThanOrEqual(2);
    expect(look.tones.length).toBeLessThanOrEqual(5);
    // Ink stays visible in the second step of shadow, and shadow on surfaces is visible without hiding them.
    const deep = formatColor(multiply(parseColor(look.tones[0]), parseColor(look.deepShadow)));
    expect(lightOf(deep) - lightOf(look.ink), `deep shadow of ${look.kind}`).toBeGreaterThan(0.05);
    expect(lightOf(look.surfaceShadow)).toBeGreaterThan(0.5);
    expect(lightOf(look.surfaceShadow)).toBeLessThan(0.75);
    expect(lightOf(look.rim)).toBeGreaterThan(lightOf(look.tones[0]) + 0.1);
  }
}

const anyColor = fc.nat(0xffffff).map((value) => `#${value.toString(16).padStart(6, '0')}`);
const greyOf = (value: number) => `#${value.toString(16).padStart(2, '0').repeat(3)}`;
const anyGrey = fc.nat(255).map(greyOf);
/** Colours of one hue. */
const oneHue = fc
  .tuple(
    fc.double({ min: 0, max: 6.28, noNaN: true }),
    fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: 1, maxLength: 8 }),
  )
  .map(([hue, lights]) => lights.map((l) => hexOf({ l, a: 0.1 * Math.cos(hue), b: 0.1 * Math.sin(hue) })));
const nearlyEqual = fc.tuple(anyColor, fc.integer({ min: -3, max: 3 })).map(([color, change]) => {
  const blue = Math.min(255, Math.max(0, parseInt(color.slice(5), 16) + change));
  return [color, color.slice(0, 5) + blue.toString(16).padStart(2, '0')];
});

describe('proposals keep the contrasts', () => {
  it.each([
    ['one to 16 colours', fc.array(anyColor, { minLength: 1, maxLength: 16 }), 150],
    ['256 colours', fc.array(anyColor, { minLength: 256, maxLength: 256 }), 6],
    ['greys', fc.array(anyGrey, { minLength: 1, maxLength: 8 }), 60],
    ['colours of one hue', oneHue, 80],
    ['two nearly equal colours', nearlyEqual, 80],
    ['dark colours', fc.array(fc.nat(0x30).map(greyOf), { minLength: 1, maxLength: 4 }), 20],
  ] as const)('for %s', (_, palettes, numRuns) => {
    fc.assert(fc.property(palettes, expectContrasts), { seed: 17, numRuns });
  });

  it.each([
    ['black', ['#000000']],
    ['white', ['#ffffff']],
    ['black and white', ['#000000', '#ffffff']],
    ['black and nearly black', ['#000000', '#010101']],
    ['the corners of RGB', ['#ff0000', '#00ff00', '#0000ff', '#00ffff', '#ff00ff', '#ffff00']],
  ])('for %s', (_, colors) => expectContrasts(colors));
});

const SUNSET = ['#2d1b33', '#5c2751', '#a33b5c', '#e8684a', '#f6a35c', '#ffe0a3'];

describe('proposals', () => {
  it('are of three kinds, which differ in tones and backdrop', () => {
    fc.assert(
      fc.property(fc.array(anyColor, { minLength: 4, maxLength: 16 }), (colors) => {
        const looks = looksIn(colors);
        expect(looks.map(({ kind }) => kind)).toEqual(KINDS);
        expect(new Set(looks.map(({ tones, backdrop }) => [...tones, ...backdrop].join())).size).toBe(3);
        expect(Math.max(...looks[2].backdrop.map(lightOf))).toBeLessThan(0.45);
      }),
      { seed: 17, numRuns: 60 },
    );
  });

  it('keep colours that have contrast as they are', () => {
    const [whole, poster, night] = looksIn(SUNSET);
    expect(whole.tones).toEqual(['#a33b5c', '#e8684a', '#f6a35c', '#ffe0a3']);
    expect([whole.ink, poster.ink, night.ink]).toEqual(['#2d1b33', '#2d1b33', '#2d1b33']);
    expect(poster.backdrop).toEqual(['#e8684a', '#e8684a']);
    expect(night.tones).toHaveLength(3);
  });

  it('do not depend on the order of colours that differ', () => {
    expect(looksIn(SUNSET.toReversed())).toEqual(looksIn(SUNSET));
  });

  it('have the ground of a picture as backdrop', () => {
    const ground = { color: '#7fb4a8', share: 0.8 };
    const rest = ['#2d1b33', '#a33b5c', '#f6a35c', '#ffe0a3'].map((color) => ({ color, share: 0.05 }));
    const [whole] = looksOf([ground, ...rest]);
    const [bottom, top] = whole.backdrop.map(labOf);
    const own = labOf(ground.color);
    for (const { a, b } of [bottom, top]) expect(Math.hypot(a - own.a, b - own.b)).toBeLessThan(0.02);
  });
});

describe('what a look changes', () => {
  it.each(presets.map(({ name }) => name))('are valid values, with a ramp of its tones: %s', (name) => {
    const values = presetValues(presets.find((preset) => preset.name === name)!);
    for (const look of looksIn(SUNSET)) {
      const changes = changesOf(look, values) as AnyValues;
      for (const [key, value] of Object.entries(changes)) {
        expect(isAccepted(findParameter(key)!, value), `${key} = ${String(value)}`).toBe(true);
      }
      expect(readRamp(String(changes['style.ramp']))!.map(({ color }) => color)).toEqual(look.tones);
      expect(readRamp(String(changes['style.backdrop']))!.map(({ color }) => color)).toEqual(look.backdrop);
      // White light shows the colours as they are, and nothing else colours cold smoke.
      expect([changes['light.color'], changes['light.intensity'], changes['light.ambient']]).toEqual(['#ffffff', 1, 1]);
      expect([changes['style.gradient'], changes['style.ageRamp']]).toEqual(['none', '']);
      const heat = String(changes['style.heatRamp']);
      expect(heat !== '').toBe((values['style.heatRamp'] ?? '') !== '');
      if (heat !== '') expect(heat).toMatch(/^0:ffffff,/);
    }
  });
});
