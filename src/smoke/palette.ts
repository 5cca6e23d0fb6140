import { FIRST_BORDER, type Color, type Ramp } from '../device/ramps.ts';

/** How many flat tones a material shows, and whether it turns its tones with the light at all. */
export interface Toning {
  tones: 1 | 2 | 3;
  shading: boolean;
}

// What is multiplied into a colour to shade it: shadows lean to violet, so that they read as cool beside any light.
const SHADOW: Color = [150, 140, 196];
const MIDDLE: Color = [214, 202, 232];

/** Eq. 2 of McGuire and Fein (2006) with Ka + KL q() folded into final colours, so that flat tones are exact. */
export function rampOf(color: Color, { tones, shading }: Toning): Ramp {
  const shadow = { from: 0, color: multiply(color, SHADOW) };
  const unlit = [shadow];
  if (!shading || tones === 1) return { lit: [{ from: 0, color }], unlit };
  if (tones === 2) return { lit: [shadow, { from: 0.5, color }], unlit };
  return { lit: [shadow, { from: FIRST_BORDER, color: multiply(color, MIDDLE) }, { from: 0.66, color }], unlit };
}

/** Surfaces stay shaded where smoke is flat: the edge of a mesh's own shadow follows its triangles and has to lie in shade. */
export function surfaceToning({ tones }: Toning): Toning {
  return { tones: tones === 1 ? 2 : tones, shading: true };
}

/** Whether light and shadow differ even where a puff looks away from the light: its own shadow must not begin on it then. */
export function isFlat({ tones, shading }: Toning): boolean {
  return !shading || tones === 1;
}

/** Reads `#rrggbb`. */
export function parseColor(text: string): Color {
  const value = Number.parseInt(text.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

function multiply(color: Color, factor: Color): Color {
  const channel = (index: 0 | 1 | 2) => Math.round((color[index] * factor[index]) / 255);
  return [channel(0), channel(1), channel(2)];
}
