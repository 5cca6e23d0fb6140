import { describe, expect, it } from 'vitest';
import type { Tone } from '../../../src/renderer/gpu/ramps.ts';
import { bandsOf } from '../../../src/renderer/palette.ts';

const SMOKE_TO_FIRE: Tone[] = [
  { from: 0, color: [60, 60, 70] },
  { from: 0.25, color: [200, 80, 40] },
  { from: 0.75, color: [255, 230, 160] },
];
const FADING: Tone[] = [
  { from: 0.1, color: [255, 255, 255] },
  { from: 0.5, color: [51, 102, 255] },
];
const NONE = { ageColors: [], heatColors: [], softColors: false, glow: [], smokeColor: [9, 8, 7] } as const;
const FIRST = 7;

describe('bandsOf', () => {
  it('has no band without colours: all smoke uses the first material', () => {
    const { colors, bands } = bandsOf(NONE, FIRST);
    expect(colors).toEqual([]);
    expect(new Set([...bands.ages, ...bands.temperatures])).toEqual(new Set([0]));
  });

  it('changes the colour by age at the stops; the first colour also applies before its stop', () => {
    const { colors, bands } = bandsOf({ ...NONE, ageColors: FADING }, FIRST);
    const at = (age: number) => colors[bands.ages[Math.floor(256 * age)] + bands.temperatures[0] - FIRST];
    expect([0, 0.3, 0.499, 0.5, 0.99].map(at)).toEqual([0, 0, 0, 1, 1].map((stop) => FADING[stop].color));
  });

  it('changes the colour by temperature in steps of 4/255, and not beyond 1', () => {
    const { colors, bands } = bandsOf({ ...NONE, heatColors: SMOKE_TO_FIRE }, FIRST);
    const at = (heat: number) => colors[bands.ages[0] + bands.temperatures[Math.round((255 * heat) / 4)] - FIRST];
    expect([0, 0.2, 0.3, 0.7, 0.8, 1, 4].map(at)).toEqual(
      [0, 0, 1, 1, 2, 2, 2].map((stop) => SMOKE_TO_FIRE[stop].color),
    );
  });

  it('multiplies both', () => {
    const { colors, bands } = bandsOf({ ...NONE, ageColors: FADING, heatColors: SMOKE_TO_FIRE }, FIRST);
    expect(colors).toHaveLength(6);
    expect(colors[bands.ages[255] + bands.temperatures[255] - FIRST]).toEqual([51, 92, 160]);
  });

  it('glows by the curve at the middle of a band, and at temperature 1 in the last one', () => {
    const glow = [
      { at: 0.25, value: 0 },
      { at: 0.75, value: 1 },
    ];
    const { glows } = bandsOf({ ...NONE, ageColors: FADING, heatColors: SMOKE_TO_FIRE, glow }, FIRST);
    // The middle of 0.25 to 0.75, in steps of 1/255; the same at both ages.
    expect(glows).toEqual([0, 0, 128 / 255, 128 / 255, 1, 1]);
    expect(bandsOf({ ...NONE, heatColors: SMOKE_TO_FIRE }, FIRST).glows).toEqual([0, 0, 0]);
  });

  it('has bands of the one colour of smoke that glows without colours by heat', () => {
    const glow = [
      { at: 0, value: 0 },
      { at: 1, value: 1 },
    ];
    const { colors, glows, bands } = bandsOf({ ...NONE, glow }, FIRST);
    expect(new Set(colors.map(String))).toEqual(new Set([String(NONE.smokeColor)]));
    const at = (heat: number) => glows[bands.ages[0] + bands.temperatures[Math.round((255 * heat) / 4)] - FIRST];
    for (const heat of [0, 0.3, 0.5, 0.9]) expect(Math.abs(at(heat) - heat), `at ${heat}`).toBeLessThan(0.02);
    expect([at(1), at(3)]).toEqual([1, 1]);
  });

  it('blends softly in steps that fit into the texture for every pair of ramps', () => {
    const soft = { ...NONE, ageColors: FADING, softColors: true };
    const { colors, bands } = bandsOf(soft, FIRST);
    expect(colors[0]).toEqual(FADING[0].color);
    expect(colors.at(-1)).toEqual(FADING[1].color);
    expect(new Set(bands.ages).size).toBe(colors.length);
    for (let i = 1; i < colors.length; i++) expect(Math.abs(colors[i][0] - colors[i - 1][0])).toBeLessThan(10);
    expect(bandsOf({ ...soft, heatColors: SMOKE_TO_FIRE }, FIRST).colors.length).toBeLessThanOrEqual(256);
  });
});
