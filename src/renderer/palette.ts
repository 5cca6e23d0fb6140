import { blendedAt, FIRST_BORDER, mixed, toneAt, type Bands, type Color, type Ramp, type Tone } from './gpu/ramps.ts';
import { valueAt, type Stop } from '../parameters/curve.ts';
import { readRamp } from '../parameters/ramp.ts';
import { TEMPERATURE_MAX } from '../simulator/layout.ts';

/** How the tones of a material depend on the light. */
export interface Toning {
  /** Number of flat tones, if there are no `stops`. */
  tones: 1 | 2 | 3;
  shading: boolean;
  /** Custom tones over N.L; the first one is the tone of shadow. None if absent or empty. */
  stops?: readonly Tone[];
  /** Whether the stops are interpolated. */
  isBlended?: boolean;
  /** Share of the full-light tone that is mixed into the tone of shadow where the fill light reaches, 0..1. */
  fill?: number;
  /** Factor on a colour in shadow, if there are no `stops`; defaults to a violet. */
  shadow?: Color;
  /** How far the tone of shadow is desaturated, 0..1. */
  neutral?: number;
}

/** The toning of surfaces in a style. */
export interface SurfaceToning extends Toning {
  /** Replaces the colours of surfaces by shades of one colour; absent, they keep their own. */
  wash?: Wash;
  /** Factor on the colours of surfaces in shadow; absent, it is derived from `stops` and `wash`. */
  surfaceShadowColor?: Color;
}

/** How far colours are mixed with shades of one colour, 0..1, and the lightest of these shades. */
export interface Wash {
  readonly share: number;
  readonly color: Color;
}

// Factor on a colour in shadow: a violet, which looks cool beside any light.
const SHADOW: Color = [150, 140, 196];
const SHADOW_LIGHTNESS = 149;
/** Difference between its greatest and its least channel. */
const SHADOW_SPREAD = 56;
// Share of the way from white to shadow at which the middle tone is, for each channel.
const MIDDLE = [0.39, 0.461, 0.39];
// Neutral tones of shadow and of the middle, for surfaces with a wash.
const GREY: Color = [142, 142, 142];
const LIGHT_GREY: Color = [206, 206, 206];
const WHITE: Color = [255, 255, 255];

/**
 * Builds the ramp of a material: Eq. 2 of McGuire and Fein (2006) with Ka + KL q() folded into final colours, so that
 * flat tones are exact.
 * @param color colour of the material in full light; stops are multiplied by it
 */
export function rampOf(color: Color, toning: Toning): Ramp {
  const ramp = toning.stops?.length ? rampOfStops(color, toning.stops, toning) : rampOfTones(color, toning);
  const first = ramp.unlit[0].color;
  const isFilled = !isFlat(toning) && toning.fill;
  return isFilled ? { ...ramp, filled: mixed(first, ramp.lit[ramp.lit.length - 1].color, isFilled) } : ramp;
}

function rampOfTones(color: Color, { tones, shading, shadow = SHADOW, neutral = 0 }: Toning): Ramp {
  const shaded = { from: 0, color: multiply(color, mixed(shadow, GREY, neutral)) };
  const unlit = [shaded];
  if (!shading || tones === 1) return { lit: [{ from: 0, color }], unlit };
  if (tones === 2) return { lit: [shaded, { from: 0.5, color }], unlit };
  const middle = shadow.map((channel, index) => 255 - (255 - channel) * MIDDLE[index]) as [number, number, number];
  return {
    lit: [
      shaded,
      { from: FIRST_BORDER, color: multiply(color, mixed(middle, LIGHT_GREY, neutral)) },
      { from: 0.66, color },
    ],
    unlit,
  };
}

function rampOfStops(color: Color, stops: readonly Tone[], { shading, isBlended }: Toning): Ramp {
  const lit = stops.map((stop) => ({ ...stop, color: multiply(stop.color, color) }));
  return { lit: shading ? lit : lit.slice(-1), unlit: lit.slice(0, 1), isBlended };
}

/** N.L from which a lit pixel differs from a shadowed one; -1 if it differs for every N.L. */
export function litThresholdOf(toning: Toning): number {
  if (isFlat(toning)) return -1;
  const { lit, isBlended } = rampOf(WHITE, toning);
  return lit[isBlended ? 0 : 1].from;
}

/** N.L from which smoke has its lightest tone. */
export function fullFromOf(toning: Toning): number {
  const { lit } = rampOf(WHITE, toning);
  return lit[lit.length - 1].from;
}

/**
 * The toning of surfaces. Surfaces stay shaded where smoke is flat: the edge of a mesh's own shadow follows its
 * triangles and must be on its dark side.
 */
export function surfaceToning({ tones, wash, stops, surfaceShadowColor }: SurfaceToning): Toning {
  const shadow = surfaceShadowColor ?? shadowIn(stops?.[0]?.color ?? SHADOW);
  return { tones: tones === 1 ? 2 : tones, shading: true, shadow, neutral: surfaceShadowColor ? 0 : wash?.share };
}

/** Factor on the colours of surfaces in shadow. */
export function surfaceShadowOf(style: SurfaceToning): Color {
  return rampOf(WHITE, surfaceToning(style)).unlit[0].color;
}

/** The violet of SHADOW with the hue of another colour, equally light and at most as saturated. */
function shadowIn(color: Color): Color {
  const own = lightnessOf(color);
  const scale = Math.min(SHADOW_LIGHTNESS / own, SHADOW_SPREAD / (Math.max(...color) - Math.min(...color)));
  // Greys have no hue: 0 times infinity is NaN.
  const channels = color.map((channel) => Math.round(SHADOW_LIGHTNESS + (scale * (channel - own) || 0)));
  return channels as [number, number, number];
}

function lightnessOf([red, green, blue]: Color): number {
  return 0.3 * red + 0.59 * green + 0.11 * blue;
}

// Black becomes this share of the wash's colour, so that dark surfaces stay darker than light ones but still show
// shadow.
const DARKEST = 0.22;

/** The colour of a surface, mixed with the shade of the wash's colour that has the same lightness. */
export function washed(color: Color, wash?: Wash): Color {
  if (!wash) return color;
  const shade = mixed([0, 0, 0], wash.color, DARKEST + ((1 - DARKEST) * lightnessOf(color)) / 255);
  return mixed(color, shade, wash.share);
}

/**
 * Whether light and shadow differ even on the side of a puff that faces away from the light. A puff's own shadow must
 * not start on it then.
 */
export function isFlat({ tones, shading, stops }: Toning): boolean {
  return !shading || (tones === 1 && !stops?.length);
}

/** The base colour of the smoke's ramp; white with custom stops, which are used unchanged. */
export function plainColorOf({ stops, smokeColor }: Pick<Toning, 'stops'> & { smokeColor: Color }): Color {
  return stops?.length ? WHITE : smokeColor;
}

/** The colour of smoke in full light. */
export function smokeColorOf(style: Toning & { smokeColor: Color }): Color {
  const { lit } = rampOf(plainColorOf(style), style);
  return lit[lit.length - 1].color;
}

/** Parses `#rrggbb`. */
export function parseColor(text: string): Color {
  const value = Number.parseInt(text.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/**
 * Parses a colour ramp of the preset.
 * @param text text in the format of `readRamp`
 */
export function parseStops(text: string): Tone[] {
  return (readRamp(text) ?? []).map(({ at, color }) => ({ from: at, color: parseColor(color) }));
}

/** Formats a colour as `#rrggbb`. */
export function formatColor([red, green, blue]: Color): string {
  return `#${((red << 16) | (green << 8) | blue).toString(16).padStart(6, '0')}`;
}

export function multiply(color: Color, factor: Color): Color {
  return color.map((channel, index) => Math.round((channel * factor[index]) / 255)) as [number, number, number];
}

/** The fields of a style that colour smoke over its life; see Style. */
export interface Coloring extends Pick<Toning, 'stops'> {
  readonly ageColors: readonly Tone[];
  readonly heatColors: readonly Tone[];
  readonly softColors: boolean;
  readonly glow: readonly Stop[];
  readonly smokeColor: Color;
}

/**
 * Number of steps that approximate interpolated colours. With both ramps, every pair of steps takes rows of the ramp
 * texture.
 */
const SOFT_STEPS = 64;
const SOFT_STEPS_OF_BOTH = 16;

const BYTES = Array.from({ length: 256 }, (_, byte) => byte);
const NONE = BYTES.map(() => 0);

/** Flat bands of smoke: their colours, the share of each that glows, 0..1, and where they apply. */
interface BandsOfSmoke {
  readonly colors: readonly Color[];
  readonly glows: readonly number[];
  readonly bands: Bands;
}

/**
 * Divides the colours of smoke by age and temperature into flat bands, and maps an age (0..1) and a temperature (0..1;
 * higher values are clamped to 1) to its band. With both ramps the two colours are multiplied. Smoke that glows has bands
 * by temperature even if its colour is the same at all temperatures.
 * @param first material index of the first band; without colour ramps all smoke has material 0
 * @param stepsOfBoth number of steps of each ramp that approximate the interpolated colours of both
 */
export function bandsOf(coloring: Coloring, first: number, stepsOfBoth = SOFT_STEPS_OF_BOTH): BandsOfSmoke {
  const { ageColors, glow, softColors } = coloring;
  const isPlain = ageColors.length + coloring.heatColors.length === 0;
  const whole: readonly Tone[] = [{ from: 0, color: isPlain ? plainColorOf(coloring) : WHITE }];
  const hasSteps = glow.length > 0 && coloring.heatColors.length === 0;
  const heatColors = hasSteps ? whole : coloring.heatColors;
  const steps = ageColors.length && heatColors.length ? stepsOfBoth : SOFT_STEPS;
  const ages = softColors ? softened(ageColors, steps) : ageColors;
  const heats = softColors || hasSteps ? softened(heatColors, steps) : heatColors;
  if (ages.length + heats.length === 0) return { colors: [], glows: [], bands: { ages: NONE, temperatures: NONE } };
  const [byAge, byHeat] = [ages, heats].map((ramp) => (ramp.length ? ramp : [{ from: 0, color: WHITE }]));
  const colors = byHeat.flatMap((heat) => byAge.map((age) => multiply(age.color, heat.color)));
  const glows = byHeat.flatMap((_, heat) => byAge.map(() => glowOf(glow, byHeat, heat)));
  const bands = {
    ages: BYTES.map((byte) => first + toneAt(byAge, byte / 256)),
    temperatures: BYTES.map((byte) => byAge.length * toneAt(byHeat, (byte / 255) * TEMPERATURE_MAX)),
  };
  return { colors, glows, bands };
}

/** The share that glows in the middle of a band, which the last one has at temperature 1. In steps of the ramp texture. */
function glowOf(glow: readonly Stop[], byHeat: readonly Tone[], band: number): number {
  if (glow.length === 0) return 0;
  const next = byHeat[band + 1];
  const middle = next ? (byHeat[band].from + next.from) / 2 : 1;
  return Math.round(255 * valueAt(glow, middle)) / 255;
}

/** Divides a ramp into equal steps; the first and the last step have the colours of its ends. */
function softened(ramp: readonly Tone[], steps: number): Tone[] {
  if (ramp.length === 0) return [];
  return Array.from({ length: steps }, (_, step) => ({
    from: step / steps,
    color: blendedAt(ramp, step / (steps - 1)),
  }));
}
