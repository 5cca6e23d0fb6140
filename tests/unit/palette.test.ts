import { describe, expect, it } from 'vitest';
import { colorAt, FIRST_BORDER, RampTexture } from '../../src/device/ramps.ts';
import { isFlat, parseColor, rampOf, surfaceToning } from '../../src/smoke/palette.ts';

const CREAM = parseColor('#f6efe2');

describe('rampOf', () => {
  it('reads colours', () => {
    expect(CREAM).toEqual([246, 239, 226]);
  });

  it.each([1, 2, 3] as const)('shows %i tones in the light', (tones) => {
    const { lit } = rampOf(CREAM, { tones, shading: true });
    expect(new Set(lit.map(({ color }) => color.join())).size).toBe(tones);
    expect(lit.at(-1)?.color).toEqual(CREAM);
  });

  it.each([2, 3] as const)('is the same in light and in shadow where the surface looks away: %i tones', (tones) => {
    const { lit, unlit } = rampOf(CREAM, { tones, shading: true });
    expect(colorAt(lit, 0)).toEqual(colorAt(unlit, 0));
  });

  it('has no lighter tone below the border that the volumes count on', () => {
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

describe('surfaceToning', () => {
  it('keeps the side of a surface that looks away as dark as its shadow, however flat the smoke', () => {
    for (const tones of [1, 2, 3] as const) {
      for (const shading of [true, false]) {
        const { lit, unlit } = rampOf(CREAM, surfaceToning({ tones, shading }));
        expect(colorAt(lit, 0)).toEqual(colorAt(unlit, 0));
      }
    }
  });
});

describe('RampTexture', () => {
  it('turns at one half exactly, between two texels', () => {
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
