/** What glows, as the simulator takes it for its lamps. */
import { Vector3 } from 'three';
import { valueAt } from '../parameters/curve.ts';
import { GLOW_HEATS, LAMP_FLOATS } from '../simulator/layout.ts';
import type { AdditionalLight } from './light.ts';
import { NEAREST } from './reach.ts';
import { blendedAt, colorAt, linear, type Tone } from './gpu/ramps.ts';
import { plainColorOf, rampOf } from './palette.ts';
import type { Style } from './style.ts';

/** Luminance of linear red, green and blue (IEC 61966-2-1). */
const LUMINANCE = [0.2126, 0.7152, 0.0722];
/** Engines differ in the last bits of powers. Fewer bits are the same in all of them. */
const STEPS = 65536;

/**
 * The light of glowing smoke in full light: for each temperature from 0 to 1 linear red, green and blue, and their
 * luminance. With looks, the same for each of them follows. Undefined if nothing glows.
 */
export function glowColors(style: Style): Float32Array | undefined {
  if (style.glow.length === 0) return undefined;
  const own = colorsOf(style);
  if (!style.looks) return own;
  const ofLooks = style.looks.styles.slice(1).map((look) => (look ? colorsOf(look) : own));
  // A tint does not glow.
  const all = ofLooks.map((colors, index) => (style.looks!.tints[index + 1] > 0 ? colors.map(() => 0) : colors));
  return Float32Array.from([own, ...all].flatMap((colors) => [...colors]));
}

function colorsOf(style: Style): Float32Array {
  const { glow, heatColors, softColors } = style;
  const heats: readonly Tone[] = heatColors.length ? heatColors : [{ from: 0, color: plainColorOf(style) }];
  const colors = new Float32Array(4 * (GLOW_HEATS + 1));
  for (let step = 0; step <= GLOW_HEATS; ++step) {
    const heat = step / GLOW_HEATS;
    const { lit } = rampOf((softColors ? blendedAt : colorAt)(heats, heat), style);
    const light = linear(lit[lit.length - 1].color).map((channel) => Math.round(STEPS * channel) / STEPS);
    const share = valueAt(glow, heat);
    const luminance = light.reduce((sum, channel, at) => sum + LUMINANCE[at] * channel, 0);
    colors.set(
      [...light, luminance].map((number) => share * number),
      4 * step,
    );
  }
  return colors;
}

/** Candela of a white puff of radius 1 m: the area of a disc that is as bright as white on the screen. */
export const CANDELA = Math.PI;
/** Irradiance in which smoke has the direct light of its style. */
export const IRRADIANCE = 3;

/** Lamps at the parts of smoke that glow. @param numbers of `Simulator.glow` */
export function glowLamps(numbers: Float32Array): AdditionalLight[] {
  return Array.from({ length: numbers.length / LAMP_FLOATS }, (_, index) => {
    const [x, y, z, , red, green, blue] = numbers.subarray(LAMP_FLOATS * index);
    const factor = CANDELA / IRRADIANCE;
    const strength = factor * Math.max(red, green, blue);
    // At the surface of what glows, a lamp is as bright as the direct light of the style.
    const falloff = { decay: 2, least: Math.max(strength, NEAREST) };
    return {
      light: { kind: 'lamp' as const, place: new Vector3(x, y, z), falloff },
      color: [factor * red, factor * green, factor * blue] as const,
    };
  });
}
