import { FIRST_BORDER, mixed, type Color, type Ramp, type Tone } from '../device/ramps.ts';
import { readRamp } from '../preset/ramp.ts';

/** How a material turns its tones with the light, if it does at all. */
export interface Toning {
  /** How many flat tones it shows, unless `stops` say so. */
  tones: 1 | 2 | 3;
  shading: boolean;
  /** Tones over N.L as they are chosen, the first of them that of shadow; none where absent or empty. */
  stops?: readonly Tone[];
  /** Whether the stops run into each other. */
  isBlended?: boolean;
  /** How far the tone of shadow comes back towards the colour where the fill light reaches, 0..1. */
  fill?: number;
  /** What a colour is multiplied by in shadow, unless `stops` say so; a violet where absent. */
  shadow?: Color;
  /** How far shadow lets go of its hue, 0..1. */
  neutral?: number;
}

/** What surfaces take from a style. */
export interface SurfaceToning extends Toning {
  /** Shades of one colour that they take; their own colours where absent. */
  wash?: Wash;
  /** What their colours are multiplied by in shadow; absent, it follows `stops` and `wash`. */
  surfaceShadowColor?: Color;
}

/** How far colours become shades of one, 0..1, and the lightest of these shades. */
export interface Wash {
  readonly share: number;
  readonly color: Color;
}

// What is multiplied into a colour to shade it: shadows lean to violet, so that they read as cool beside any light.
const SHADOW: Color = [150, 140, 196];
const SHADOW_LIGHTNESS = 149;
/** Between its greatest and its least channel. */
const SHADOW_SPREAD = 56;
// How far the middle tone is from white to shadow.
const MIDDLE = [0.39, 0.461, 0.39];
// Shadow and middle tone without a hue, for things that are washed into shades of one colour.
const GREY: Color = [142, 142, 142];
const LIGHT_GREY: Color = [206, 206, 206];
const WHITE: Color = [255, 255, 255];

/**
 * Eq. 2 of McGuire and Fein (2006) with Ka + KL q() folded into final colours, so that flat tones are exact.
 * @param color of the material in full light; stops are multiplied by it
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

/** N.L from which a lit pixel differs from one in shadow; -1 where it does whatever N.L is. */
export function litThresholdOf(toning: Toning): number {
  if (isFlat(toning)) return -1;
  const { lit, isBlended } = rampOf(WHITE, toning);
  return lit[isBlended ? 0 : 1].from;
}

/** Surfaces stay shaded where smoke is flat: the edge of a mesh's own shadow follows its triangles and has to lie in shade. */
export function surfaceToning({ tones, wash, stops, surfaceShadowColor }: SurfaceToning): Toning {
  const shadow = surfaceShadowColor ?? shadowIn(stops?.[0]?.color ?? SHADOW);
  return { tones: tones === 1 ? 2 : tones, shading: true, shadow, neutral: surfaceShadowColor ? 0 : wash?.share };
}

/** What the colours of surfaces are multiplied by in shadow. */
export function surfaceShadowOf(style: SurfaceToning): Color {
  return rampOf(WHITE, surfaceToning(style)).unlit[0].color;
}

/** SHADOW in the hue of another colour: as light as it is, and no stronger. */
function shadowIn(color: Color): Color {
  const own = lightnessOf(color);
  const scale = Math.min(SHADOW_LIGHTNESS / own, SHADOW_SPREAD / (Math.max(...color) - Math.min(...color)));
  // A grey has no hue: 0 times infinity.
  const channels = color.map((channel) => Math.round(SHADOW_LIGHTNESS + (scale * (channel - own) || 0)));
  return channels as [number, number, number];
}

function lightnessOf([red, green, blue]: Color): number {
  return 0.3 * red + 0.59 * green + 0.11 * blue;
}

// Of the wash's colour, what black becomes: dark things stay darker than light ones and yet show their shadow.
const DARKEST = 0.22;

/** The colour of a surface: its own, or the shade of the wash's colour that is as light as its own. */
export function washed(color: Color, wash?: Wash): Color {
  if (!wash) return color;
  const shade = mixed([0, 0, 0], wash.color, DARKEST + ((1 - DARKEST) * lightnessOf(color)) / 255);
  return mixed(color, shade, wash.share);
}

/** Whether light and shadow differ even where a puff looks away from the light: its own shadow must not begin on it then. */
export function isFlat({ tones, shading, stops }: Toning): boolean {
  return !shading || (tones === 1 && !stops?.length);
}

/** The colour that the smoke's ramp is made from: chosen stops stand as they are. */
export function plainColorOf({ stops, smokeColor }: Toning & { smokeColor: Color }): Color {
  return stops?.length ? WHITE : smokeColor;
}

/** The colour of smoke in full light. */
export function smokeColorOf(style: Toning & { smokeColor: Color }): Color {
  const { lit } = rampOf(plainColorOf(style), style);
  return lit[lit.length - 1].color;
}

/** Reads `#rrggbb`. */
export function parseColor(text: string): Color {
  const value = Number.parseInt(text.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** Colours over a range, as a ramp of the table has them. @param text that `readRamp` takes */
export function parseStops(text: string): Tone[] {
  return (readRamp(text) ?? []).map(({ at, color }) => ({ from: at, color: parseColor(color) }));
}

export function multiply(color: Color, factor: Color): Color {
  return color.map((channel, index) => Math.round((channel * factor[index]) / 255)) as [number, number, number];
}
