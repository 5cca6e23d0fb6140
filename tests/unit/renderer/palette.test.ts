import { describe, expect, it } from 'vitest';
import { defaultPreset, presetValues } from '../../../src/parameters/presets.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaults } from '../../../src/parameters/values.ts';
import {
  blendedAt,
  colorAt,
  type Factors,
  FIRST_BORDER,
  type Illumination,
  linear,
  type Ramp,
  RampTexture,
  type Tone,
} from '../../../src/renderer/gpu/ramps.ts';
import { illuminationOf } from '../../../src/renderer/light.ts';
import {
  isFlat,
  parseColor,
  parseStops,
  plainColorOf,
  rampOf,
  smokeColorOf,
  surfaceShadowOf,
  surfaceToning,
  litThresholdOf,
  washed,
} from '../../../src/renderer/palette.ts';
import { automaticColors, styleOf } from '../../../src/renderer/style.ts';

const CREAM = parseColor('#f6efe2');

describe('rampOf', () => {
  it('reads colours', () => {
    expect(CREAM).toEqual([246, 239, 226]);
  });

  it.each([1, 2, 3] as const)('has %i tones in the light', (tones) => {
    const { lit } = rampOf(CREAM, { tones, shading: true });
    expect(new Set(lit.map(({ color }) => color.join())).size).toBe(tones);
    expect(lit.at(-1)?.color).toEqual(CREAM);
  });

  it.each([2, 3] as const)('is the same in light and in shadow where the surface faces away: %i tones', (tones) => {
    const { lit, unlit } = rampOf(CREAM, { tones, shading: true });
    expect(colorAt(lit, 0)).toEqual(colorAt(unlit, 0));
  });

  it('has no lighter tone below the threshold that the volumes assume', () => {
    for (const tones of [2, 3] as const) {
      const { lit } = rampOf(CREAM, { tones, shading: true });
      for (const tone of lit.slice(1)) expect(tone.from).toBeGreaterThanOrEqual(FIRST_BORDER);
    }
  });

  it('is flat without shading, whatever the tones', () => {
    expect(rampOf(CREAM, { tones: 3, shading: false }).lit).toHaveLength(1);
    expect(isFlat({ tones: 3, shading: false })).toBe(true);
    expect(isFlat({ tones: 2, shading: true })).toBe(false);
  });
});

const STOPS = parseStops('0:333344,.125:aa7090,.5:ffeedd');

describe('custom ramps', () => {
  const toning = { tones: 2, shading: true, stops: STOPS } as const;
  const white = parseColor('#ffffff');

  it('show the colours as typed, the first of them in shadow', () => {
    const { lit, unlit } = rampOf(white, toning);
    expect(lit.map(({ color }) => color)).toEqual(STOPS.map(({ color }) => color));
    expect(
      [0, 0.124, 0.125, 0.49, 0.5, 1].map((facing) =>
        STOPS.findIndex(({ color }) => color.join() === colorAt(lit, facing).join()),
      ),
    ).toEqual([0, 0, 1, 1, 2, 2]);
    expect(unlit.map(({ color }) => color)).toEqual([STOPS[0].color]);
    expect(plainColorOf({ ...toning, smokeColor: CREAM })).toEqual(white);
    expect(smokeColorOf({ ...toning, smokeColor: CREAM })).toEqual(STOPS[2].color);
  });

  it('are multiplied by the colour of a tint', () => {
    expect(rampOf(parseColor('#ff0080'), toning).lit[2].color).toEqual([255, 0, 111]);
  });

  it('report where they leave shadow', () => {
    expect(litThresholdOf(toning)).toBe(0.125);
    expect(litThresholdOf({ ...toning, isBlended: true })).toBe(0);
    expect(litThresholdOf({ ...toning, shading: false })).toBe(-1);
    expect(litThresholdOf({ tones: 3, shading: true })).toBe(FIRST_BORDER);
    expect(litThresholdOf({ tones: 1, shading: true })).toBe(-1);
  });

  it('are blended on request, starting at the shadow', () => {
    const ramp = rampOf(white, { ...toning, isBlended: true });
    expect(blendedAt(ramp.lit, 0)).toEqual(STOPS[0].color);
    expect(blendedAt(ramp.lit, 0.0625)).toEqual([111, 82, 106]);
    expect(blendedAt(ramp.lit, 0.9)).toEqual(STOPS[2].color);
  });
});

describe('fill', () => {
  it('is a tone between shadow and light, and replaces the first tone only', () => {
    const ramp = rampOf(CREAM, { tones: 3, shading: true, fill: 0.25 });
    const [shadow, light] = [ramp.unlit[0].color, CREAM];
    ramp.filled!.forEach((channel, index) => {
      expect(channel).toBeGreaterThan(shadow[index]);
      expect(channel).toBeLessThan(light[index]);
    });
    const ramps = new RampTexture(1);
    ramps.write(0, ramp);
    const data = ramps.texture.image.data as Uint8Array;
    const texel = (row: number, column: number) => [
      ...data.subarray(4 * (256 * row + column), 4 * (256 * row + column) + 3),
    ];
    expect([texel(0, 0), texel(1, 0)]).toEqual([shadow, shadow]);
    expect([texel(2, 0), texel(2, 255), texel(3, 0)]).toEqual([ramp.filled, ramp.filled, ramp.filled]);
    expect(texel(3, 255)).toEqual([...CREAM]);
  });

  it('is off without shading', () => {
    expect(rampOf(CREAM, { tones: 2, shading: false, fill: 0.5 }).filled).toBeUndefined();
  });
});

describe('surfaceToning', () => {
  it('keeps the far side of a surface as dark as its shadow for any smoke style', () => {
    for (const tones of [1, 2, 3] as const) {
      for (const shading of [true, false]) {
        const { lit, unlit } = rampOf(CREAM, surfaceToning({ tones, shading }));
        expect(colorAt(lit, 0)).toEqual(colorAt(unlit, 0));
      }
    }
  });
});

describe('the shadow of surfaces', () => {
  const WHITE = parseColor('#ffffff');
  const [tones, shading] = [3, true] as const;
  const GREEN = parseStops('0:2f5a34,.3:9fc48a,.6:ffffff');
  const lightness = ([red, green, blue]: readonly number[]) => 0.3 * red + 0.59 * green + 0.11 * blue;

  it('is violet without a custom ramp', () => {
    const { lit, unlit } = rampOf(WHITE, surfaceToning({ tones, shading, stops: [] }));
    expect(unlit[0].color).toEqual([150, 140, 196]);
    expect(lit.map(({ color }) => color)).toEqual([
      [150, 140, 196],
      [214, 202, 232],
      [255, 255, 255],
    ]);
  });

  it('has the hue of the first colour of a custom ramp, as light as the violet and no more saturated', () => {
    // The dark green minus its lightness is (-26, 17, -21); the channels of the violet span 56, those of the green 43.
    expect(surfaceShadowOf({ tones, shading, stops: GREEN })).toEqual([115, 171, 122]);
    for (const dark of ['000000', 'ffffff', '140030', 'ff0000', '808080']) {
      const shadow = surfaceShadowOf({ tones, shading, stops: parseStops(`0:${dark},.5:ffffff`) });
      expect(Math.abs(lightness(shadow) - lightness([150, 140, 196])), dark).toBeLessThan(1);
      expect(Math.max(...shadow) - Math.min(...shadow), dark).toBeLessThanOrEqual(57);
    }
  });

  it('has the hue in its middle tone, too', () => {
    const [shadow, middle, light] = rampOf(WHITE, surfaceToning({ tones, shading, stops: GREEN })).lit;
    middle.color.forEach((channel, index) => {
      expect(channel).toBeGreaterThan(shadow.color[index]);
      expect(channel).toBeLessThan(light.color[index]);
    });
    expect(middle.color[1]).toBeGreaterThan(middle.color[0]);
    expect(middle.color[1]).toBeGreaterThan(middle.color[2]);
  });

  it('is the colour that is set, for any ramp and any wash', () => {
    const wash = { share: 1, color: [200, 100, 50] } as const;
    const surfaceShadowColor = parseColor('#203040');
    expect(surfaceShadowOf({ tones, shading, stops: GREEN, wash, surfaceShadowColor })).toEqual(surfaceShadowColor);
  });

  it('is read from values, and has a default value if it is not set', () => {
    const values = presetValues(defaultPreset);
    expect(styleOf(values).surfaceShadowColor).toBeUndefined();
    expect(automaticColors(values)).toEqual({ 'style.surfaceShadowColor': '#968cc4' });
    const set = { ...values, 'style.ramp': '0:2f5a34,.6:ffffff', 'style.surfaceShadowColor': '#203040' };
    expect(styleOf(set).surfaceShadowColor).toEqual([32, 48, 64]);
    expect(automaticColors(set)).toEqual({ 'style.surfaceShadowColor': '#73ab7a' });
  });
});

describe('RampTexture', () => {
  it('changes exactly at one half, between two texels', () => {
    const ramps = new RampTexture(2);
    ramps.write(1, rampOf(CREAM, { tones: 2, shading: true }));
    const data = ramps.texture.image.data as Uint8Array;
    const [unlit, lit] = [4, 5];
    const texel = (row: number, column: number) =>
      Array.from(data.subarray(4 * (256 * row + column), 4 * (256 * row + column) + 3));
    expect(texel(lit, 127)).not.toEqual([...CREAM]);
    expect(texel(lit, 128)).toEqual([...CREAM]);
    expect(texel(unlit, 255)).toEqual(texel(lit, 0));
  });
});

describe('RampTexture under another light', () => {
  const SAME = { direct: [1, 1, 1], ambient: [1, 1, 1] } as const;
  const SUNSET = parseStops('0:343868,.12:8c6096,.55:fad6aa');

  /** The texels of a ramp, without alpha. */
  function texelsOf(ramp: Ramp, illumination?: Illumination): number[][] {
    const ramps = new RampTexture(1);
    ramps.write(0, ramp, illumination);
    const data = ramps.texture.image.data as Uint8Array;
    return Array.from({ length: 4 * 256 }, (_, texel) => [...data.subarray(4 * texel, 4 * texel + 3)]);
  }

  it('has the factors of the values, which are 1 by default', () => {
    expect(illuminationOf(defaults())).toEqual(SAME);
    const values: Values = { ...defaults(), 'light.color': '#ff0000', 'light.intensity': 0.5, 'light.ambient': 3 };
    expect(illuminationOf(values)).toEqual({ direct: [0.5, 0, 0], ambient: [3, 3, 3] });
    // An sRGB code of 188 is 0.5029 of white.
    expect(illuminationOf({ ...values, 'light.ambientColor': '#bcbcbc' }).ambient[0]).toBeCloseTo(3 * 0.5029, 3);
  });

  it('weakens with the distance from a lamp with decay only', () => {
    const lamp: Values = { ...defaults(), 'light.kind': 'lamp', 'light.intensity': 0.5 };
    expect(styleOf({ ...lamp, 'light.decay': 2 }).lampLight).toEqual([0.5, 0.5, 0.5]);
    const others: Values[] = [
      {},
      { 'light.kind': 'sun', 'light.decay': 2 },
      { 'style.renderer': 'selle', 'light.decay': 2 },
    ];
    for (const other of others) expect(styleOf({ ...lamp, ...other }).lampLight).toBeUndefined();
  });

  it('has the share of the fill light as alpha', () => {
    const ramps = new RampTexture(1);
    const stops = parseStops('0:404040,.5:c0c0c0');
    const ramp = rampOf([255, 255, 255], { tones: 2, shading: true, fill: 1, stops, isBlended: true });
    ramps.write(0, ramp);
    const data = ramps.texture.image.data as Uint8Array;
    const texel = (row: number, column: number) => [...data.subarray(4 * (256 * row + column)).subarray(0, 4)];
    expect([texel(0, 0), texel(1, 64), texel(1, 128)]).toEqual([
      [64, 64, 64, 0],
      [128, 128, 128, 0],
      [192, 192, 192, 0],
    ]);
    expect([texel(2, 0), texel(3, 64), texel(3, 128)]).toEqual([
      [192, 192, 192, 255],
      [192, 192, 192, 128],
      [192, 192, 192, 0],
    ]);
  });

  it('shows only full light of a material that glows, in the hue of coloured light, but its tones in that of the style', () => {
    const ramp = { ...rampOf(CREAM, { tones: 3, shading: true }), glows: true };
    const shown = (direct: Factors) => [...new Set(texelsOf(ramp, { direct, ambient: [0, 0.1, 0.3] }).map(String))];
    expect(texelsOf(ramp, SAME)).toEqual(texelsOf({ ...ramp, glows: false }, SAME));
    expect(shown([0.2, 0.2, 0.2])).toEqual([String(CREAM)]);
    expect(shown([0, 0, 0])).toEqual([String(CREAM)]);
    expect(shown([0, 0, 0.5])).toEqual(['0,0,255']);
    const half = linear(CREAM).map((light, at) => (light + [0.5, 0.5, 1][at]) / 2);
    shown([0.25, 0.25, 0.5])[0]
      .split(',')
      .forEach((channel, at) => expect(linear([Number(channel), 0, 0])[0]).toBeCloseTo(half[at], 2));
  });

  it.each([
    ['two tones', { tones: 2, shading: true }],
    ['three tones and a fill light', { tones: 3, shading: true, fill: 0.4 }],
    ['custom tones', { tones: 2, shading: true, stops: SUNSET, fill: 0.3 }],
    ['blended tones and a fill light', { tones: 2, shading: true, stops: SUNSET, fill: 0.3, isBlended: true }],
    ['no shading', { tones: 3, shading: false }],
  ] as const)('has the tones as they are by default, to the bit, with %s', (_, toning) => {
    const ramp = rampOf(CREAM, toning);
    const withFill = (tones: readonly Tone[]) =>
      tones.map((tone, at) => ({ ...tone, color: at === 0 && ramp.filled ? ramp.filled : tone.color }));
    const rows = [ramp.unlit, ramp.lit, withFill(ramp.unlit), withFill(ramp.lit)];
    const colorIn = ramp.isBlended ? blendedAt : colorAt;
    const expected = rows.flatMap((tones) =>
      Array.from({ length: 256 }, (__, texel) => [...colorIn(tones, texel / 256)]),
    );
    expect(texelsOf(ramp)).toEqual(expected);
    expect(texelsOf(ramp, SAME)).toEqual(expected);
  });

  it('scales both parts in linear light, and clamps their sum', () => {
    const ramp = rampOf([255, 255, 255], { tones: 2, shading: true, stops: parseStops('0:404040,.5:c0c0ff') });
    const texels = texelsOf(ramp, { direct: [0.5, 4, 0], ambient: [1, 0.25, 2] });
    // In linear light, codes of 64 and 192 are 0.05127 and 0.52712: 0.28920, 1.91622 and 0.10254 are 146, 255 and 90.
    expect(texels[256 + 255]).toEqual([146, 255, 90]);
    // Shadow has ambient light alone: 0.05127, 0.01282 and 0.10254.
    expect(texels[255]).toEqual([64, 30, 90]);
    expect(texels[256]).toEqual(texels[255]);
  });

  it('leaves the share that glows as it is, mixed in linear light', () => {
    const stops = parseStops('0:404040,.5:c0c0c0');
    const plain = rampOf([255, 255, 255], { tones: 2, shading: true, stops });
    const light = { direct: [0.5, 0.5, 0.5], ambient: [0, 0, 4] } as const;
    const at = (glow: number) => {
      const texels = texelsOf({ ...plain, glow }, light);
      return [texels[256 + 255], texels[255]];
    };
    // In linear light, codes of 64 and 192 are 0.05127 and 0.52712. Half of their difference is 0.23793: 134. With the
    // ambient light of blue, 0.20508, it is 0.44301: 178. In shadow there is ambient light only.
    expect(at(0)).toEqual([
      [134, 134, 178],
      [0, 0, 125],
    ]);
    // (0.52712 + 0.23793) / 2 = 0.38252 is 166, (0.52712 + 0.44301) / 2 = 0.48506 is 185; 0.02564 is 44, 0.12818 is 100.
    expect(at(0.5)).toEqual([
      [166, 166, 185],
      [44, 44, 100],
    ]);
    expect(at(1)).toEqual([
      [192, 192, 192],
      [64, 64, 64],
    ]);
  });

  it('has the share that glows as alpha of its first texel alone', () => {
    const ramps = new RampTexture(2);
    ramps.write(1, { ...rampOf(CREAM, { tones: 2, shading: true }), glow: 0.6 });
    const data = ramps.texture.image.data as Uint8Array;
    const alphas = Array.from({ length: 4 * 256 }, (_, texel) => data[4 * (4 * 256 + texel) + 3]);
    expect(alphas[0]).toBe(153);
    expect(alphas.slice(1).every((alpha) => alpha === 0)).toBe(true);
  });

  it('does not change the part of the fill light', () => {
    const ramp = rampOf([255, 255, 255], { tones: 2, shading: true, fill: 1, stops: parseStops('0:404040,.5:c0c0c0') });
    const texels = texelsOf(ramp, { direct: [0, 0, 0], ambient: [0, 0, 0] });
    // 0.52712 - 0.05127 = 0.47585 is 183.
    expect([texels[0], texels[256], texels[512], texels[768]]).toEqual([
      [0, 0, 0],
      [0, 0, 0],
      [183, 183, 183],
      [183, 183, 183],
    ]);
    expect(texels[768 + 255]).toEqual([0, 0, 0]);
  });
});

describe('washed', () => {
  const wash = { share: 1, color: [200, 100, 50] } as const;

  it('does not change colours without a wash', () => {
    expect(washed(CREAM)).toEqual(CREAM);
    expect(washed(CREAM, { ...wash, share: 0 })).toEqual(CREAM);
  });

  it('makes shades of one colour with the lightness of the original colours', () => {
    expect(washed([255, 255, 255], wash)).toEqual([200, 100, 50]);
    const [dark, light] = [washed([60, 20, 20], wash), washed([90, 220, 120], wash)];
    for (const shade of [dark, light]) expect(shade[0] / shade[1]).toBeCloseTo(2, 1);
    expect(light[0]).toBeGreaterThan(dark[0] + 60);
  });

  it('applies to surface shadows, too', () => {
    const toning = surfaceToning({ tones: 3, shading: true, wash });
    const { lit } = rampOf([255, 255, 255], toning);
    expect(lit).toHaveLength(3);
    for (const { color } of lit) expect(new Set(color).size).toBe(1);
  });
});
