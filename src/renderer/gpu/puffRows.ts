import { ATTRIBUTE_WORDS, END_STEPS, PLACE_FLOATS, RowGeometry, RowTextures, type RowLayout } from './drawnRows.ts';
import type { Rows } from '../../simulator/rows.ts';

/** Simulator rows for the passes that draw them. */
export class PuffRows {
  readonly geometry: RowGeometry;
  private readonly rows: RowTextures;

  /** @param capacity maximum number of rows */
  constructor(capacity: number, layout: RowLayout) {
    this.rows = new RowTextures(capacity);
    this.geometry = new RowGeometry(this.rows, layout);
  }

  get count(): number {
    return this.rows.count;
  }

  /** x, y, z and radius of each row, metres. */
  get places(): Float32Array {
    return this.rows.placeArray.subarray(0, PLACE_FLOATS * this.count);
  }

  /** The packed words of each row. */
  get attributeWords(): Uint32Array {
    return this.rows.attributeWords.subarray(0, ATTRIBUTE_WORDS * this.count);
  }

  /** Copies the rows and marks only the copied range for upload. */
  fill({ place, attributes, count, whole }: Rows): void {
    this.rows.placeArray.set(place.subarray(0, PLACE_FLOATS * count));
    this.rows.attributeWords.set(attributes.subarray(0, ATTRIBUTE_WORDS * count));
    this.rows.update(count, whole);
  }

  dispose(): void {
    this.geometry.dispose();
    this.rows.dispose();
  }
}

/** Rows of shadow casters, whose attributes contain the end of their shadows. */
export class CasterRows extends PuffRows {
  /**
   * Copies the rows and shortens their shadows. Shadows that already end earlier do not change.
   * @param ends for each row, the distance behind its centre at which its shadow may end, in metres; without them,
   * shadows end as in the rows
   */
  override fill(rows: Rows, ends?: Float32Array): void {
    super.fill(rows);
    if (ends) this.shorten(ends);
  }

  private shorten(ends: Float32Array): void {
    const { places, attributeWords, count } = this;
    for (let row = 0; row < count; row++) {
      const end = Math.max(0, Math.ceil((END_STEPS * ends[row]) / places[PLACE_FLOATS * row + 3]));
      const word = attributeWords[ATTRIBUTE_WORDS * row];
      if (end < word >>> 16) attributeWords[ATTRIBUTE_WORDS * row] = (end << 16) | (word & 0xffff);
    }
  }
}
