import { ATTRIBUTE_WORDS, PLACE_FLOATS, RowGeometry, RowTextures, type RowLayout } from '../../device/drawnRows.ts';

/** Segments of a stroke. */
export const SEGMENTS = 20;
const MIN_CAPACITY = 256;

const STRIP: RowLayout = {
  vertices: 2 * (SEGMENTS + 1),
  index: Array.from({ length: SEGMENTS }, (_, segment) => [0, 1, 2, 2, 1, 3].map((at) => 2 * segment + at)).flat(),
};

/**
 * The rows of strokes: those of the bodies that have one, with the number of the lobe in place of the tint. Variation and
 * seed of a particle decide which of its lobes have a stroke, so strokes stay with their lobes.
 */
export class StrokeRows {
  private strips = stripsFor(MIN_CAPACITY);

  /**
   * Finds the strokes of the bodies.
   * @param lobes number of lobes of a puff
   * @param strokes `style.strokes`, 0..1; a larger value keeps all strokes of a smaller one
   */
  find(bodies: RowTextures, lobes: number, strokes: number): RowGeometry {
    const { placeArray, attributeWords } = bodies;
    const found: number[] = [];
    for (let row = 0; row < bodies.count; row++) {
      const look = attributeWords[ATTRIBUTE_WORDS * row + 1] & 0xffff;
      for (let lobe = 0; lobe < lobes; lobe++) {
        if (hashOf(look | (lobe << 16)) < strokes) found.push(row, lobe);
      }
    }
    const { rows } = this.withRoomFor(found.length / 2);
    for (let stroke = 0; stroke < found.length / 2; stroke++) {
      const [row, lobe] = [found[2 * stroke], found[2 * stroke + 1]];
      const [place, words] = [PLACE_FLOATS * row, ATTRIBUTE_WORDS * row];
      rows.placeArray.set(placeArray.subarray(place, place + PLACE_FLOATS), PLACE_FLOATS * stroke);
      rows.attributeWords.set(attributeWords.subarray(words, words + ATTRIBUTE_WORDS), ATTRIBUTE_WORDS * stroke);
      rows.attributeWords[ATTRIBUTE_WORDS * stroke + 1] = (attributeWords[words + 1] & 0xffffff) | (lobe << 24);
    }
    rows.update(found.length / 2);
    return this.strips;
  }

  dispose(): void {
    this.strips.dispose();
    this.strips.rows.dispose();
  }

  private withRoomFor(strokes: number): RowGeometry {
    const { capacity } = this.strips.rows;
    if (strokes > capacity) {
      this.dispose();
      this.strips = stripsFor(Math.max(strokes, 2 * capacity));
    }
    return this.strips;
  }
}

function stripsFor(capacity: number): RowGeometry {
  return new RowGeometry(new RowTextures(capacity), STRIP);
}

/** Hashes 32 bits to [0, 1): the finalizer of MurmurHash3. */
function hashOf(bits: number): number {
  let mixed = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b);
  mixed = Math.imul(mixed ^ (mixed >>> 13), 0xc2b2ae35);
  return ((mixed ^ (mixed >>> 16)) >>> 0) / 2 ** 32;
}
