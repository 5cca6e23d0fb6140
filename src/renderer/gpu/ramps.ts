import {
  ClampToEdgeWrapping,
  DataTexture,
  NearestFilter,
  RGBAFormat,
  UnsignedByteType,
  type Color as ThreeColor,
  type IUniform,
} from 'three';
import { RAMP_ROWS, RAMP_TEXELS } from '../../base/constants.ts';

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
}

/** Selects the ramp of a puff: the ramp index is `ages[ageByte] + temperatures[temperatureByte]`. */
export interface Bands {
  readonly ages: readonly number[];
  readonly temperatures: readonly number[];
}

/**
 * Least N.L of the second tone in built-in ramps, so that shadow volumes can start close behind the lit part of a puff.
 */
export const FIRST_BORDER = 0.3;

/**
 * The quantisation q of Eq. 2 (McGuire and Fein 2006) as a texture of final colours over max(0, N.L); clamping the
 * texture coordinate gives the max. Each material has four rows: in shadow, in the light, then both again where the
 * fill light reaches. Nearest filtering keeps the colours exact. The last row holds the {@link Bands}.
 */
export class RampTexture {
  readonly texture: DataTexture;
  private materials: number;

  /** @param materials number of ramps */
  constructor(materials: number) {
    this.materials = materials;
    this.texture = new DataTexture(bytesFor(materials), RAMP_TEXELS, rowsFor(materials), RGBAFormat, UnsignedByteType);
    this.texture.wrapS = ClampToEdgeWrapping;
    this.texture.wrapT = ClampToEdgeWrapping;
    this.texture.minFilter = NearestFilter;
    this.texture.magFilter = NearestFilter;
  }

  /** Changes the number of ramps. All ramps must be written again afterwards. */
  resize(materials: number): void {
    if (materials === this.materials) return;
    this.materials = materials;
    this.texture.dispose();
    this.texture.image = { data: bytesFor(materials), width: RAMP_TEXELS, height: rowsFor(materials) };
  }

  write(material: number, { lit, unlit, filled, isBlended = false }: Ramp): void {
    const rows = [unlit, lit];
    if (filled) rows.push(...rows.map(([first, ...rest]) => [{ ...first, color: filled }, ...rest]));
    else rows.push(...rows);
    rows.forEach((tones, row) => this.writeRow(RAMP_ROWS * material + row, tones, isBlended));
    this.texture.needsUpdate = true;
  }

  writeBands({ ages, temperatures }: Bands): void {
    const first = RAMP_TEXELS * RAMP_ROWS * this.materials;
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

  private writeRow(row: number, tones: readonly Tone[], isBlended: boolean): void {
    for (let texel = 0; texel < RAMP_TEXELS; ++texel) {
      const facing = texel / RAMP_TEXELS;
      const color = isBlended ? blendedAt(tones, facing) : colorAt(tones, facing);
      this.data.set([...color, 255], (row * RAMP_TEXELS + texel) * 4);
    }
  }
}

function rowsFor(materials: number): number {
  return RAMP_ROWS * materials + 1;
}

function bytesFor(materials: number): Uint8Array<ArrayBuffer> {
  return new Uint8Array(4 * RAMP_TEXELS * rowsFor(materials));
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
  const [low, high] = [tones[tone], tones[Math.min(tone + 1, tones.length - 1)]];
  const share = high.from > low.from ? (facing - low.from) / (high.from - low.from) : 0;
  return mixed(low.color, high.color, Math.max(0, share));
}

/** Interpolates display-encoded colours linearly, from one (share 0) to the other (share 1). */
export function mixed(from: Color, to: Color, share: number): Color {
  return from.map((channel, index) => Math.round(channel + share * (to[index] - channel))) as [number, number, number];
}
