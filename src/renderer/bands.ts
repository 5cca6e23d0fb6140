import { blendedAt, toneAt, type Bands, type Color, type Tone } from './gpu/ramps.ts';
import { TEMPERATURE_MAX } from '../simulator/layout.ts';
import { multiply } from './palette.ts';

/** The fields of a style that colour smoke over its life; see Style. */
export interface Coloring {
  ageColors: readonly Tone[];
  heatColors: readonly Tone[];
  softColors: boolean;
}

/**
 * Number of steps that approximate interpolated colours. With both ramps, every pair of steps takes rows of the ramp
 * texture.
 */
const SOFT_STEPS = 64;
const SOFT_STEPS_OF_BOTH = 16;

const WHITE: readonly Tone[] = [{ from: 0, color: [255, 255, 255] }];
const BYTES = Array.from({ length: 256 }, (_, byte) => byte);
const NONE = BYTES.map(() => 0);

/**
 * Divides the colours of smoke by age and temperature into flat bands, and maps an age (0..1) and a temperature (0..1;
 * higher values are clamped to 1) to its band. With both ramps the two colours are multiplied.
 * @param first material index of the first band; without colour ramps all smoke has material 0
 */
export function bandsOf(coloring: Coloring, first: number): { colors: Color[]; bands: Bands } {
  const { ageColors, heatColors } = coloring;
  const steps = ageColors.length && heatColors.length ? SOFT_STEPS_OF_BOTH : SOFT_STEPS;
  const [ages, heats] = [ageColors, heatColors].map((ramp) => (coloring.softColors ? softened(ramp, steps) : ramp));
  if (ages.length + heats.length === 0) return { colors: [], bands: { ages: NONE, temperatures: NONE } };
  const [byAge, byHeat] = [ages, heats].map((ramp) => (ramp.length ? ramp : WHITE));
  const colors = byHeat.flatMap((heat) => byAge.map((age) => multiply(age.color, heat.color)));
  const bands = {
    ages: BYTES.map((byte) => first + toneAt(byAge, byte / 256)),
    temperatures: BYTES.map((byte) => byAge.length * toneAt(byHeat, (byte / 255) * TEMPERATURE_MAX)),
  };
  return { colors, bands };
}

/** Divides a ramp into equal steps; the first and the last step have the colours of its ends. */
function softened(ramp: readonly Tone[], steps: number): Tone[] {
  if (ramp.length === 0) return [];
  return Array.from({ length: steps }, (_, step) => ({
    from: step / steps,
    color: blendedAt(ramp, step / (steps - 1)),
  }));
}
