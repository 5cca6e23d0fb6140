import {
  ClampToEdgeWrapping,
  DataTexture,
  NearestFilter,
  RGBAFormat,
  UnsignedByteType,
  type Color as ThreeColor,
  type IUniform,
} from 'three';
import { COLUMN_ROWS, RAMP_ROWS, RAMP_TEXELS } from '../../base/constants.ts';

/** A display-encoded colour, each channel 0 to 255. */
export type Color = readonly [red: number, green: number, blue: number];

/** Writes a colour to a uniform without a colour space conversion. */
export function writeColor(color: Color, uniform: IUniform<ThreeColor>): void {
  uniform.value.fromArray(color.map((channel) => channel / 255));
}

/** A flat tone of a ramp. It applies where N.L is at least `from` (0 to 1); the first tone also applies below that. */
export interface Tone {
  from: number;
  color: Color;
}

/** The tones of a material in the light and in shadow. Both start with the same tone. */
export interface Ramp {
  lit: readonly Tone[];
  unlit: readonly Tone[];
  /** Replaces the first tone where the fill light reaches; defaults to the first tone. */
  filled?: Color;
  /** Whether tones are interpolated instead of flat. */
  isBlended?: boolean;
  /** Whether the material is a source of light, see {@link glowing}. */
  glows?: boolean;
  /** Share of its colours that the light does not scale, 0..1; defaults to 0. */
  glow?: number;
}

/** Selects the ramp of a puff: the ramp index is `ages[ageByte] + temperatures[temperatureByte]`. */
export interface Bands {
  readonly ages: readonly number[];
  readonly temperatures: readonly number[];
}

/** Linear factors on the channels of light. */
export type Factors = readonly [red: number, green: number, blue: number];

/**
 * The light as factors on the one in which ramps show their colours: of its direct part, KL of Eq. 2 (McGuire and Fein
 * 2006), and of its ambient part, Ka.
 */
export interface Illumination {
  readonly direct: Factors;
  readonly ambient: Factors;
}

/** The displayed colour, given that of a ramp and the share of the ramp's first tone in it. */
type Shown = (color: Color, firstShare: number) => Color;

/**
 * Least N.L of the second tone in built-in ramps, so that shadow volumes can start close behind the lit part of a puff.
 */
export const FIRST_BORDER = 0.3;

/**
 * The quantisation q of Eq. 2 (McGuire and Fein 2006) as a texture of final colours over max(0, N.L); clamping the
 * texture coordinate gives the max. The colours are those in the light of the frame, see {@link inLight}. Each material has
 * four rows: in shadow, in the light, then both again where the fill light reaches. Nearest filtering keeps the colours
 * exact. Alpha is the share of the filled tone, and in the first texel the share that glows. The last row holds the
 * {@link Bands}. With looks, ramps are in several columns, the last rows hold the bands of each look, and the alpha of the
 * second texel is the N.L from which lit smoke differs from smoke in shadow, in 255ths, rounded up, as shading is compared with
 * it. That of the third one is the texel there.
 */
export class RampTexture {
  readonly texture: DataTexture;
  private size: RampSize;

  /** @param materials number of ramps */
  constructor(materials: number) {
    this.size = { materials, bands: 1 };
    const { data, width, height } = imageFor(this.size);
    this.texture = new DataTexture(data, width, height, RGBAFormat, UnsignedByteType);
    this.texture.wrapS = ClampToEdgeWrapping;
    this.texture.wrapT = ClampToEdgeWrapping;
    this.texture.minFilter = NearestFilter;
    this.texture.magFilter = NearestFilter;
  }

  /**
   * Changes the number of ramps. All ramps must be written again afterwards.
   * @param bands number of rows of bands: one, or one for each look
   */
  resize(materials: number, bands = 1): void {
    if (materials === this.size.materials && bands === this.size.bands) return;
    this.size = { materials, bands };
    this.texture.dispose();
    this.texture.image = imageFor(this.size);
  }

  write(material: number, ramp: Ramp, illumination?: Illumination): void {
    const first = RAMP_ROWS * material;
    const other = isChanged(illumination) ? illumination : undefined;
    const { lit, unlit, filled, isBlended = false, glow = 0 } = ramp.glows && other ? glowing(ramp, other) : ramp;
    const shown: Shown = (color, filledShare) =>
      other && !ramp.glows ? inLight(color, unlit[0].color, other, { share: filledShare, filled, glow }) : color;
    [unlit, lit].forEach((tones, row) => {
      this.writeRow(first + row, tones, isBlended, shown, 0);
      if (filled) this.writeRow(first + 2 + row, [{ ...tones[0], color: filled }, ...tones.slice(1)], isBlended, shown);
    });
    if (!filled) {
      for (const row of [first, first + 1])
        this.data.copyWithin(this.placeOf(row + 2), this.placeOf(row), this.placeOf(row) + 4 * RAMP_TEXELS);
    }
    const start = this.placeOf(first);
    this.data[start + 3] = Math.round(255 * glow);
    if (this.size.bands > 1) {
      const border = borderOf(ramp);
      this.data[start + 7] = Math.ceil(255 * border - 1e-6);
      this.data[start + 11] = Math.min(RAMP_TEXELS * border, RAMP_TEXELS - 1);
    }
    this.texture.needsUpdate = true;
  }

  /** @param look index of the look that has the bands */
  writeBands({ ages, temperatures }: Bands, look = 0): void {
    const { width, height } = this.texture.image;
    const first = width * (height - this.size.bands + look);
    for (let byte = 0; byte < RAMP_TEXELS; ++byte) {
      const [age, heat] = [ages[byte], temperatures[byte]];
      this.data.set([age & 255, age >> 8, heat & 255, heat >> 8], 4 * (first + byte));
    }
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }

  private get data(): Uint8Array {
    return this.texture.image.data as Uint8Array;
  }

  /** Index of the first byte of a row of a ramp. */
  private placeOf(row: number): number {
    const rows = rowsOf(this.size);
    return 4 * ((row % rows) * this.texture.image.width + RAMP_TEXELS * Math.floor(row / rows));
  }

  /** @param fill share of the filled tone in the first one */
  private writeRow(row: number, tones: readonly Tone[], isBlended: boolean, shown: Shown, fill = 1): void {
    const flat = tones.map(({ color }, tone) => shown(color, tone === 0 ? fill : 0));
    const isFlat = !isBlended || tones.length === 1;
    const start = this.placeOf(row);
    for (let texel = 0; texel < RAMP_TEXELS; ++texel) {
      const facing = texel / RAMP_TEXELS;
      const tone = toneAt(tones, facing);
      const share = tone === 0 ? fill * (isFlat ? 1 : 1 - shareAt(tones, tone, facing)) : 0;
      const color = isFlat ? flat[tone] : shown(blendedAt(tones, facing), share);
      this.data.set([...color, Math.round(255 * share)], start + 4 * texel);
    }
  }
}

/**
 * Only the tone of full light, in the hue of the direct light as far as that is coloured: the same sun is orange at dusk and
 * a pale moon at night.
 */
export function glowing({ lit }: Ramp, { direct }: Illumination): Ramp {
  const [{ from, color }] = lit.slice(-1);
  const [least, most] = [Math.min(...direct), Math.max(...direct)];
  const share = most > 0 ? 1 - least / most : 0;
  const hue = linear(color).map((light, at) => light + share * (direct[at] / (most || 1) - light));
  const full = [{ from, color: encoded(hue) }];
  return { lit: full, unlit: full };
}

export function isChanged(illumination?: Illumination): boolean {
  return illumination !== undefined && [...illumination.direct, ...illumination.ambient].some((factor) => factor !== 1);
}

/** Numbers of ramps and of rows of bands. */
interface RampSize {
  readonly materials: number;
  readonly bands: number;
}

/** Rows of ramps in a column. */
function rowsOf({ materials, bands }: RampSize): number {
  return Math.min(RAMP_ROWS * materials, bands > 1 ? COLUMN_ROWS : Infinity);
}

function imageFor(size: RampSize): { data: Uint8Array<ArrayBuffer>; width: number; height: number } {
  const rows = rowsOf(size);
  const width = RAMP_TEXELS * Math.ceil((RAMP_ROWS * size.materials) / rows);
  const height = rows + size.bands;
  return { data: new Uint8Array(4 * width * height), width, height };
}

/** N.L from which lit smoke differs from smoke in shadow; 0 for all. */
function borderOf({ lit, isBlended }: Ramp): number {
  return lit.length === 1 ? 0 : lit[isBlended ? 0 : 1].from;
}

/** The tone of a ramp at a value of max(0, N.L). */
export function colorAt(tones: readonly Tone[], facing: number): Color {
  return tones[toneAt(tones, facing)].color;
}

/** Index of the tone that applies at a value of max(0, N.L). */
export function toneAt(tones: readonly Tone[], facing: number): number {
  return Math.max(
    0,
    tones.findLastIndex(({ from }) => facing >= from),
  );
}

/** The interpolated colour of a ramp at a value of max(0, N.L). */
export function blendedAt(tones: readonly Tone[], facing: number): Color {
  const tone = toneAt(tones, facing);
  return mixed(tones[tone].color, nextOf(tones, tone).color, shareAt(tones, tone, facing));
}

/** How far a value of max(0, N.L) is from a tone to the next one, 0..1. */
function shareAt(tones: readonly Tone[], tone: number, facing: number): number {
  const [low, high] = [tones[tone].from, nextOf(tones, tone).from];
  return high > low ? Math.max(0, (facing - low) / (high - low)) : 0;
}

function nextOf(tones: readonly Tone[], tone: number): Tone {
  return tones[Math.min(tone + 1, tones.length - 1)];
}

/** Linear light, 0 to 1, of each display-encoded channel, 0 to 255 (IEC 61966-2-1). */
const LINEAR = Array.from({ length: 256 }, (_, code) => {
  const value = code / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
});

/** The linear light of a display-encoded colour, 0 to 1. */
export function linear(color: Color): Factors {
  return color.map((channel) => LINEAR[channel]) as [number, number, number];
}

/** The display-encoded colour of linear light, which is clamped to 0..1. */
export function encoded(light: readonly number[]): Color {
  return light.map((channel) => {
    const value = Math.min(Math.max(channel, 0), 1);
    return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
  }) as [number, number, number];
}

/** A colour with factors on its linear light; unchanged to the bit if they are 1. */
export function scaled(color: Color, factors: Factors): Color {
  return factors.every((factor) => factor === 1)
    ? color
    : encoded(linear(color).map((light, at) => light * factors[at]));
}

/** What the key light and the ambient light do not scale in a colour of a ramp. */
interface Unscaled {
  /** Share of the filled tone F in the colour, 0..1, and F. */
  readonly share?: number;
  readonly filled?: Color;
  /** Share of the colour that glows, 0..1. */
  readonly glow?: number;
}

/**
 * A colour of a ramp in another light. With the tone of ambient light S = C Ka of Eq. 2 and this colour T = C (Ka + KL q),
 * it is S a + (T - S) k in linear light. T - S is negative where a ramp gets darker towards the light. The part of the fill
 * light, which T contains with a share of F - S, keeps its strength. A share e that glows is e T, and the rest 1 - e of that.
 * @param ambient S
 */
export function inLight(
  color: Color,
  ambient: Color,
  illumination: Illumination,
  { share = 0, filled = ambient, glow = 0 }: Unscaled = {},
): Color {
  const [all, first] = [linear(color), linear(ambient)];
  const byFill = linear(filled).map((light, at) => share * (light - first[at]));
  return encoded(
    all.map((light, at) => {
      const direct = light - first[at] - byFill[at];
      const lit = first[at] * illumination.ambient[at] + direct * illumination.direct[at] + byFill[at];
      return glow * light + (1 - glow) * lit;
    }),
  );
}

/** Interpolates display-encoded colours linearly, from one (share 0) to the other (share 1). */
export function mixed(from: Color, to: Color, share: number): Color {
  return from.map((channel, index) => Math.round(channel + share * (to[index] - channel))) as [number, number, number];
}
