/** Colours in OKLab (Ottosson 2020), in which equal distances look about equally large. */
import {
  clampChroma,
  converter,
  formatHex,
  modeLab,
  modeOklab,
  modeOklch,
  modeRgb,
  useMode,
  type Oklab,
} from 'culori/fn';

useMode(modeRgb);
useMode(modeOklch);
useMode(modeOklab);
const inOklab = converter('oklab');
// CIELAB with the white point D50, as in Adobe's files.
useMode(modeLab);
const inRgb = converter('rgb');

/** Lightness `l`, 0 (black) to 1 (white), and the chroma axes green to red `a` and blue to yellow `b`. */
export type Lab = Pick<Oklab, 'l' | 'a' | 'b'>;

/** @param color `#rrggbb` */
export function labOf(color: string): Lab {
  return inOklab(color)!;
}

/** The OKLab colour of display-encoded channels, 0 to 255 each. */
export function labOfRgb(red: number, green: number, blue: number): Lab {
  return inOklab({ mode: 'rgb', r: red / 255, g: green / 255, b: blue / 255 });
}

/** Channels beyond the range by less than this are rounded into it. */
const ROUNDING = 0.5 / 255;

/** Formats a colour as `#rrggbb`. One that sRGB lacks keeps its lightness and its hue, and loses chroma. */
export function hexOf({ l, a, b }: Lab): string {
  const color: Oklab = { mode: 'oklab', l: Math.min(Math.max(l, 0), 1), a, b };
  const { r, g, b: blue } = inRgb(color);
  const isShown = [r, g, blue].every((channel) => Math.abs(channel - 0.5) <= 0.5 + ROUNDING);
  return formatHex(isShown ? color : clampChroma(color, 'oklch'));
}

/** Converts CIELAB D50. @param l 0 to 100 */
export function hexOfCielab(l: number, a: number, b: number): string {
  const { r, g, b: blue } = inRgb({ mode: 'lab', l, a, b });
  return hexOfRgb(r, g, blue);
}

/** @param channels display-encoded, 0 to 1 each; others are clamped */
export function hexOfRgb(...channels: readonly [red: number, green: number, blue: number]): string {
  const [r, g, b] = channels;
  return formatHex({ mode: 'rgb', r, g, b });
}

export function distance(from: Lab, to: Lab): number {
  return Math.hypot(from.l - to.l, huesApart(from, to));
}

/** The distance of two colours without their lightness. */
export function huesApart(from: Lab, to: Lab): number {
  return Math.hypot(from.a - to.a, from.b - to.b);
}

/** Distance from the grey of the same lightness, about 0.3 for the most vivid colours. */
export function chromaOf({ a, b }: Lab): number {
  return Math.hypot(a, b);
}
