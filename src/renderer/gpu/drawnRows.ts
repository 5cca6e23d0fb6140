import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  FloatType,
  RGBAFormat,
  RGBAIntegerFormat,
  UnsignedIntType,
  type IUniform,
  type RawShaderMaterial,
  type Texture,
  type WebGLRenderer,
} from 'three';
import { DrawnMesh } from './drawnMesh.ts';

/** Rows in a row of texels. */
export const ROWS_PER_LINE = 1024;
/** Floats of a row's place, a texel. */
export const PLACE_FLOATS = 4;
/** Packed words per row; see shaders/lib/attributes.glsl. */
export const ATTRIBUTE_WORDS = 4;
/** Steps per radius of the shadow end, which is in the upper 16 bits of a caster's word 0. */
export const END_STEPS = 256;

/** Uniforms of shaders/lib/rows.glsl. */
export interface RowUniforms extends Record<string, IUniform> {
  rowPlaces: IUniform<Texture | null>;
  rowAttributes: IUniform<Texture | null>;
  rowVertices: IUniform<number>;
}

export function rowUniforms(): RowUniforms {
  return { rowPlaces: { value: null }, rowAttributes: { value: null }, rowVertices: { value: 4 } };
}

/** Vertices of a row, and three of them for each of its triangles. Vertices n and n + 4 are at the same corner. */
export interface RowLayout {
  vertices: number;
  index: readonly number[];
}

/** One front-facing quad. */
export const ONE_QUAD: RowLayout = { vertices: 4, index: [0, 1, 2, 0, 2, 3] };
/** Two coincident quads with opposite winding and separate vertices, so that gl_VertexID distinguishes them. */
export const TWO_QUADS: RowLayout = { vertices: 8, index: [...ONE_QUAD.index, 4, 6, 5, 4, 7, 6] };

/**
 * Rows of the simulator in two textures: `place` (world x, y, z, radius) and `attributes` (four packed words), 32 bytes per
 * row. The arrays are allocated in JavaScript, because growing WASM memory detaches views on it.
 */
export class RowTextures {
  readonly places: DataTexture;
  readonly attributes: DataTexture;
  readonly capacity: number;
  count = 0;
  /** Number of rows without bites. They come first. */
  whole = 0;
  /** The first row that is drawn. */
  first = 0;

  /** @param capacity maximum number of rows; the textures are never reallocated */
  constructor(capacity: number) {
    this.capacity = capacity;
    const lines = Math.max(1, Math.ceil(capacity / ROWS_PER_LINE));
    const rows = lines * ROWS_PER_LINE;
    this.places = new DataTexture(new Float32Array(PLACE_FLOATS * rows), ROWS_PER_LINE, lines, RGBAFormat, FloatType);
    this.attributes = new DataTexture(
      new Uint32Array(ATTRIBUTE_WORDS * rows),
      ROWS_PER_LINE,
      lines,
      RGBAIntegerFormat,
      UnsignedIntType,
    );
  }

  get placeArray(): Float32Array {
    return this.places.image.data as Float32Array;
  }

  get attributeWords(): Uint32Array {
    return this.attributes.image.data as unknown as Uint32Array;
  }

  /**
   * Uploads the first `count` rows at the next draw.
   * @param whole number of rows without bites
   */
  update(count: number, whole = count): void {
    this.count = count;
    this.whole = whole;
    markPrefix(this.places, PLACE_FLOATS, count);
    markPrefix(this.attributes, ATTRIBUTE_WORDS, count);
  }

  dispose(): void {
    this.places.dispose();
    this.attributes.dispose();
  }
}

/**
 * Marks the first rows of a texture for upload.
 * @param components of a row
 */
export function markPrefix(texture: DataTexture, components: number, rows: number): void {
  if (rows === 0) return;
  texture.clearUpdateRanges();
  for (let row = 0; row < rows; row += ROWS_PER_LINE) {
    const length = components * Math.min(ROWS_PER_LINE, rows - row);
    // three.js uploads one line of the texture for each range.
    texture.addUpdateRange(components * row, length);
  }
  texture.needsUpdate = true;
}

/**
 * The triangles of rows, without vertex attributes: shaders find the row of a vertex by gl_VertexID. Instances of a quad
 * would be less code, but some GPUs draw each instance on its own; SwiftShader takes longer for that than for its pixels.
 */
export class RowGeometry extends BufferGeometry {
  readonly rows: RowTextures;
  readonly layout: RowLayout;

  constructor(rows: RowTextures, layout: RowLayout) {
    super();
    this.rows = rows;
    this.layout = layout;
    this.reserve(rows.capacity);
  }

  /** Selects the current rows for the next draw call with a material. */
  bind({ uniforms }: RawShaderMaterial): void {
    const { rows, layout } = this;
    const { length } = layout.index;
    this.setDrawRange(length * rows.first, length * (rows.count - rows.first));
    uniforms.rowPlaces.value = rows.places;
    uniforms.rowAttributes.value = rows.attributes;
    uniforms.rowVertices.value = layout.vertices;
  }

  /** Makes the indices for this many rows. */
  protected reserve(rows: number): void {
    const { index, vertices } = this.layout;
    const indices = new Uint32Array(index.length * rows);
    for (let row = 0; row < rows; row++) {
      for (let at = 0; at < index.length; at++) indices[row * index.length + at] = row * vertices + index[at];
    }
    this.setIndex(new BufferAttribute(indices, 1));
  }
}

/** Draws rows of puffs that may have bites: see src/renderer/bites.ts. */
export interface BiteDrawing {
  draw(renderer: WebGLRenderer, mesh: DrawnRows, geometry: RowGeometry): void;
}

/** A mesh whose vertices are those of rows. Its material has the uniforms of rows. */
export class DrawnRows extends DrawnMesh<RowGeometry> {
  /** What draws the rows if they may have bites. */
  bites: BiteDrawing | undefined;

  override draw(renderer: WebGLRenderer, geometry: RowGeometry): void {
    // Textures that were never filled do not match their samplers.
    if (geometry.rows.count === 0) return;
    if (this.bites) this.bites.draw(renderer, this, geometry);
    else this.drawPlain(renderer, geometry);
  }

  /** Draws rows with the material as it is. */
  drawPlain(renderer: WebGLRenderer, geometry: RowGeometry): void {
    geometry.bind(this.material);
    super.draw(renderer, geometry);
  }
}
