import { DataTexture, RGBAIntegerFormat, UnsignedIntType } from 'three';
import { ATTRIBUTE_WORDS, markPrefix, ROWS_PER_LINE, type RowTextures } from '../../gpu/drawnRows.ts';

const ROW_BITS = 24;

/**
 * The arcs on which strokes may lie: a word for each, with the numbers of its row and, in the upper 8 bits, of its lobe, four
 * words in a texel. Variation and seed of a particle decide which of its lobes have an arc, so strokes stay with their
 * lobes.
 */
export class StrokeArcs {
  texture = textureFor(1);
  count = 0;

  get words(): Uint32Array {
    return this.texture.image.data as unknown as Uint32Array;
  }

  /**
   * Finds the arcs of the bodies.
   * @param lobes number of lobes of a puff
   * @param strokes `style.strokes`, 0..1; a larger value keeps all strokes of a smaller one
   */
  find({ attributeWords, count }: RowTextures, lobes: number, strokes: number): void {
    this.reserve(lobes * count);
    const { words } = this;
    this.count = 0;
    for (let row = 0; row < count; row++) {
      const look = attributeWords[ATTRIBUTE_WORDS * row + 1] & 0xffff;
      for (let lobe = 0; lobe < lobes; lobe++) {
        if (hashOf(look | (lobe << 16)) < strokes) words[this.count++] = row | (lobe << ROW_BITS);
      }
    }
    markPrefix(this.texture, 1, this.count);
  }

  dispose(): void {
    this.texture.dispose();
  }

  private reserve(arcs: number): void {
    const { length } = this.words;
    if (arcs <= length) return;
    this.dispose();
    this.texture = textureFor(Math.max(arcs, 2 * length));
  }
}

function textureFor(arcs: number): DataTexture {
  const lines = Math.ceil(arcs / ROWS_PER_LINE);
  const words = new Uint32Array(lines * ROWS_PER_LINE);
  // three.js uploads parts of a texture only with four components.
  return new DataTexture(words, ROWS_PER_LINE / 4, lines, RGBAIntegerFormat, UnsignedIntType);
}

/** Hashes 32 bits to [0, 1): the finalizer of MurmurHash3. */
function hashOf(bits: number): number {
  let mixed = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b);
  mixed = Math.imul(mixed ^ (mixed >>> 13), 0xc2b2ae35);
  return ((mixed ^ (mixed >>> 16)) >>> 0) / 2 ** 32;
}
