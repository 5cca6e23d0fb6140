import { BufferAttribute, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry } from 'three';
import type { Rows } from '../sim/rows.ts';

/** Packed words per row; see shaders/lib/attributes.glsl. */
const ATTRIBUTE_WORDS = 2;

/** Corners of the quads that a pass draws per instance, x and y each. `index` lists their triangles. */
export interface QuadLayout {
  corners: readonly number[];
  index: readonly number[];
}

/** One front-facing quad. */
export const ONE_QUAD: QuadLayout = { corners: [-1, -1, 1, -1, 1, 1, -1, 1], index: [0, 1, 2, 0, 2, 3] };

/** Two coincident quads with opposite winding and separate vertices, so that gl_VertexID distinguishes them. */
export const TWO_QUADS: QuadLayout = {
  corners: [...ONE_QUAD.corners, ...ONE_QUAD.corners],
  index: [...ONE_QUAD.index, 4, 6, 5, 4, 7, 6],
};

/**
 * Simulator rows as instanced attributes: `place` (world x, y, z, radius) and `attributes` (two packed words), 24 bytes
 * per row. The arrays are allocated in JavaScript, because growing WASM memory detaches views on it.
 */
export class Instances {
  readonly geometry = new InstancedBufferGeometry();
  private readonly place: InstancedBufferAttribute;
  private readonly attributes: InstancedBufferAttribute;

  /** @param capacity maximum number of rows; the buffers are never reallocated */
  constructor(capacity: number, layout: QuadLayout) {
    this.place = new InstancedBufferAttribute(new Float32Array(4 * capacity), 4);
    this.attributes = new InstancedBufferAttribute(new Uint32Array(ATTRIBUTE_WORDS * capacity), ATTRIBUTE_WORDS);
    this.place.setUsage(DynamicDrawUsage);
    this.attributes.setUsage(DynamicDrawUsage);
    this.geometry.setIndex([...layout.index]);
    this.geometry.setAttribute('corner', new BufferAttribute(new Float32Array(layout.corners), 2));
    this.geometry.setAttribute('place', this.place);
    this.geometry.setAttribute('attributes', this.attributes);
    this.geometry.instanceCount = 0;
  }

  get count(): number {
    return this.geometry.instanceCount;
  }

  /** x, y, z and radius of each row, metres. */
  get places(): Float32Array {
    return (this.place.array as Float32Array).subarray(0, 4 * this.count);
  }

  /** The packed words of each row. */
  protected get attributeWords(): Uint32Array {
    return this.attributes.array as Uint32Array;
  }

  /** Mean radius in metres; 0 if there are no rows. */
  get meanRadius(): number {
    let sum = 0;
    for (let row = 0; row < this.count; row++) sum += this.place.array[4 * row + 3];
    return sum / Math.max(1, this.count);
  }

  /** Copies the rows and marks only the copied range for upload. */
  fill(rows: Rows): void {
    copyPrefix(this.place, rows.place, 4 * rows.count);
    copyPrefix(this.attributes, rows.attributes, ATTRIBUTE_WORDS * rows.count);
    this.geometry.instanceCount = rows.count;
  }

  dispose(): void {
    this.geometry.dispose();
  }
}

/** Steps per radius of the shadow end, which is in the upper 16 bits of a caster's word 0. */
const END_STEPS = 256;

/** Rows of shadow casters, whose attributes contain the end of their shadows. */
export class CasterInstances extends Instances {
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
      const end = Math.max(0, Math.ceil((END_STEPS * ends[row]) / places[4 * row + 3]));
      const word = attributeWords[ATTRIBUTE_WORDS * row];
      if (end < word >>> 16) attributeWords[ATTRIBUTE_WORDS * row] = (end << 16) | (word & 0xffff);
    }
  }
}

function copyPrefix(attribute: InstancedBufferAttribute, source: Float32Array | Uint32Array, length: number): void {
  (attribute.array as Float32Array | Uint32Array).set(source.subarray(0, length));
  markPrefix(attribute, length);
}

function markPrefix(attribute: InstancedBufferAttribute, length: number): void {
  if (length === 0) return;
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, length);
  attribute.needsUpdate = true;
}
