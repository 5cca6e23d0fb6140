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

/** One flat tone of a ramp: it begins where N.L reaches `from` (0 to 1; the first tone begins at 0). */
export interface Tone {
  from: number;
  color: Color;
}

/** How one material answers light: its tones in the light, and its tones in shadow. Both start with the same tone. */
export interface Ramp {
  lit: readonly Tone[];
  unlit: readonly Tone[];
}

/** N.L below which no ramp may turn lighter: shadow volumes start behind everything that can be lit from there on. */
export const FIRST_BORDER = 0.3;

// An even count puts a border at 1/2 exactly between two texels.
const TEXELS = 256;

/**
 * The quantisation q of Eq. 2 (McGuire and Fein 2006) as a texture: for each material a row of final colours in the
 * light and a row in shadow, over max(0, N.L); the clamped address is the max. Colours arrive on the screen exactly.
 */
export class RampTexture {
  readonly texture: DataTexture;
  private readonly materials: number;

  /** @param materials how many ramps it holds */
  constructor(materials: number) {
    this.materials = materials;
    this.texture = new DataTexture(
      new Uint8Array(TEXELS * materials * 2 * 4),
      TEXELS,
      materials * 2,
      RGBAFormat,
      UnsignedByteType,
    );
    this.texture.wrapS = ClampToEdgeWrapping;
    this.texture.wrapT = ClampToEdgeWrapping;
    this.texture.minFilter = NearestFilter;
    this.texture.magFilter = NearestFilter;
  }

  write(material: number, ramp: Ramp): void {
    this.writeRow(2 * material, ramp.lit);
    this.writeRow(2 * material + 1, ramp.unlit);
    this.texture.needsUpdate = true;
  }

  /** Texture coordinates of the two rows of a material. */
  rows(material: number): { litRow: number; unlitRow: number } {
    const row = (index: number) => (index + 0.5) / (this.materials * 2);
    return { litRow: row(2 * material), unlitRow: row(2 * material + 1) };
  }

  /** From one material to the next, as texture coordinate. */
  get pitch(): number {
    return 1 / this.materials;
  }

  dispose(): void {
    this.texture.dispose();
  }

  private writeRow(row: number, tones: readonly Tone[]): void {
    const data = this.texture.image.data as Uint8Array;
    for (let texel = 0; texel < TEXELS; ++texel) {
      data.set([...colorAt(tones, texel / TEXELS), 255], (row * TEXELS + texel) * 4);
    }
  }
}

/** The tone of a ramp at a value of max(0, N.L). */
export function colorAt(tones: readonly Tone[], facing: number): Color {
  let color = tones[0].color;
  for (const tone of tones) {
    if (facing >= tone.from) color = tone.color;
  }
  return color;
}
