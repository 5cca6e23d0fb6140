import {
  ClampToEdgeWrapping,
  DataTexture,
  NearestFilter,
  RGBAFormat,
  UnsignedByteType,
  type Color as ThreeColor,
  type IUniform,
} from 'three';

/** A display-encoded colour, each channel 0 to 255. */
export type Color = readonly [red: number, green: number, blue: number];

/** Gives a colour to a uniform, display-encoded as it is. */
export function writeColor(color: Color, uniform: IUniform<ThreeColor>): void {
  uniform.value.fromArray(color.map((channel) => channel / 255));
}

/** One flat tone of a ramp: it begins where N.L reaches `from` (0 to 1; the first tone also holds before it). */
export interface Tone {
  from: number;
  color: Color;
}

/** How one material answers light: its tones in the light, and its tones in shadow. Both start with the same tone. */
export interface Ramp {
  lit: readonly Tone[];
  unlit: readonly Tone[];
  /** What stands for the first tone where the fill light reaches; the first tone itself where absent. */
  filled?: Color;
  /** Whether tones run into each other instead of being flat. */
  isBlended?: boolean;
}

/** Which ramp a body has: `ages` and `temperatures` are numbers by byte whose sum is the number of the material. */
export interface Bands {
  readonly ages: readonly number[];
  readonly temperatures: readonly number[];
}

/** N.L below which ramps of tones turn no lighter: from there on shadow volumes start close behind what can be lit. */
export const FIRST_BORDER = 0.3;

// An even count puts a border at 1/2 exactly between two texels.
const TEXELS = 256;
const ROWS = 4;

/**
 * The quantisation q of Eq. 2 (McGuire and Fein 2006) as a texture: for each material rows of final colours in shadow
 * and in the light, then the same two where the fill light reaches, over max(0, N.L); the clamped address is the max.
 * Colours arrive on the screen exactly. The last row tells which material a body has: see {@link Bands}.
 */
export class RampTexture {
  readonly texture: DataTexture;
  private materials: number;

  /** @param materials how many ramps it holds */
  constructor(materials: number) {
    this.materials = materials;
    this.texture = new DataTexture(bytesFor(materials), TEXELS, rowsFor(materials), RGBAFormat, UnsignedByteType);
    this.texture.wrapS = ClampToEdgeWrapping;
    this.texture.wrapT = ClampToEdgeWrapping;
    this.texture.minFilter = NearestFilter;
    this.texture.magFilter = NearestFilter;
  }

  /** Makes room for another number of ramps; all of them are to be written then. */
  resize(materials: number): void {
    if (materials === this.materials) return;
    this.materials = materials;
    this.texture.dispose();
    this.texture.image = { data: bytesFor(materials), width: TEXELS, height: rowsFor(materials) };
  }

  write(material: number, { lit, unlit, filled, isBlended = false }: Ramp): void {
    const rows = [unlit, lit];
    if (filled) rows.push(...rows.map(([first, ...rest]) => [{ ...first, color: filled }, ...rest]));
    else rows.push(...rows);
    rows.forEach((tones, row) => this.writeRow(ROWS * material + row, tones, isBlended));
    this.texture.needsUpdate = true;
  }

  writeBands({ ages, temperatures }: Bands): void {
    const first = TEXELS * ROWS * this.materials;
    for (let byte = 0; byte < TEXELS; ++byte) {
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
    for (let texel = 0; texel < TEXELS; ++texel) {
      const facing = texel / TEXELS;
      const color = isBlended ? blendedAt(tones, facing) : colorAt(tones, facing);
      this.data.set([...color, 255], (row * TEXELS + texel) * 4);
    }
  }
}

function rowsFor(materials: number): number {
  return ROWS * materials + 1;
}

function bytesFor(materials: number): Uint8Array<ArrayBuffer> {
  return new Uint8Array(4 * TEXELS * rowsFor(materials));
}

/** The tone of a ramp at a value of max(0, N.L). */
export function colorAt(tones: readonly Tone[], facing: number): Color {
  return tones[toneAt(tones, facing)].color;
}

/** Which tone of a ramp holds at a value. */
export function toneAt(tones: readonly Tone[], facing: number): number {
  return Math.max(
    0,
    tones.findLastIndex(({ from }) => facing >= from),
  );
}

/** The colour of a ramp whose tones run into each other, at a value of max(0, N.L). */
export function blendedAt(tones: readonly Tone[], facing: number): Color {
  const tone = toneAt(tones, facing);
  const [low, high] = [tones[tone], tones[Math.min(tone + 1, tones.length - 1)]];
  const share = high.from > low.from ? (facing - low.from) / (high.from - low.from) : 0;
  return mixed(low.color, high.color, Math.max(0, share));
}

/** From one colour (share 0) to another (share 1), as displayed. */
export function mixed(from: Color, to: Color, share: number): Color {
  return from.map((channel, index) => Math.round(channel + share * (to[index] - channel))) as [number, number, number];
}
