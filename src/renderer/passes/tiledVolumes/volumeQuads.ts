import {
  DataTexture,
  RGBAIntegerFormat,
  UnsignedIntType,
  type IUniform,
  type RawShaderMaterial,
  type Texture,
} from 'three';
import { DEPTH_TILE, TILE_BITS } from '../../../base/constants.ts';
import {
  ATTRIBUTE_WORDS,
  markPrefix,
  ONE_QUAD,
  PLACE_FLOATS,
  RowGeometry,
  ROWS_PER_LINE,
  type RowTextures,
} from '../../gpu/drawnRows.ts';
import type { FrameView } from '../../gpu/frameView.ts';
import { VolumeBalls } from './volumeBalls.ts';

/** Tile number of a quad that covers a whole volume. */
const WHOLE = 2 ** TILE_BITS - 1;
/** Number of tiles up to which a volume has one quad. */
const FEW = 16;

/**
 * The quads of shadow volumes. A small volume has one for all of it. A large volume has one for each tile of the picture
 * that it may cover, so that the vertex shader can skip tiles: volumes near the camera cover much, and contain little of
 * it. The texture has a word for each quad, with the numbers of its row and of its tile.
 */
export class VolumeQuads extends RowGeometry {
  private texture!: DataTexture;
  private words!: Uint32Array<ArrayBuffer>;
  private count = 0;
  private columns = 0;
  /** For each tile, the last row that was added. */
  private lastRow = new Int32Array(0);
  private isTiled = false;

  constructor(rows: RowTextures) {
    super(rows, ONE_QUAD);
    this.allocate(rows.capacity);
  }

  /** Whether a quad covers a tile, not a whole volume. */
  get hasTiles(): boolean {
    return this.isTiled;
  }

  /**
   * Finds the quads of the current rows.
   * @param reach radius of the bounding sphere of a puff, in puff radii
   */
  find(eye: FrameView, reach: number): void {
    const { placeArray: places, attributeWords, count: rows } = this.rows;
    const hasNumbers = this.begin(eye) < WHOLE;
    const balls = new VolumeBalls(eye, reach);
    const box = new PixelBox(eye);
    for (let row = 0; row < rows; row++) {
      const at = PLACE_FLOATS * row;
      const word = attributeWords[ATTRIBUTE_WORDS * row];
      const isShadow = balls.select(places[at], places[at + 1], places[at + 2], places[at + 3], word);
      const isTiled = hasNumbers && isShadow && this.coversMuch(balls, box) && this.addTiles(row, balls, box);
      if (!isTiled) this.add(row, WHOLE);
    }
    markPrefix(this.texture, 1, this.count);
  }

  override bind(material: RawShaderMaterial): void {
    super.bind(material);
    this.setDrawRange(0, this.layout.index.length * this.count);
    (material.uniforms as { volumeQuads: IUniform<Texture> }).volumeQuads.value = this.texture;
  }

  override dispose(): void {
    super.dispose();
    this.texture.dispose();
  }

  /** Clears the quads. Returns the number of tiles of the picture. */
  private begin({ uniforms: { viewport } }: FrameView): number {
    this.columns = Math.ceil(viewport.value.x / DEPTH_TILE);
    const tiles = this.columns * Math.ceil(viewport.value.y / DEPTH_TILE);
    if (this.lastRow.length < tiles) this.lastRow = new Int32Array(tiles);
    this.lastRow.fill(-1);
    this.count = 0;
    this.isTiled = false;
    return tiles;
  }

  private coversMuch(balls: VolumeBalls, box: PixelBox): boolean {
    box.clear();
    balls.addEnds((...ball) => box.extend(...ball));
    box.crop();
    return (box.right - box.left) * (box.high - box.low) > FEW * DEPTH_TILE ** 2;
  }

  /** Adds a quad for each tile that a volume may cover; none if they are few. Returns whether it has. */
  private addTiles(row: number, balls: VolumeBalls, box: PixelBox): boolean {
    const first = this.count;
    balls.addChain((...ball) => {
      box.clear();
      box.extend(...ball);
      if (!box.isEmpty) this.addBox(row, box);
    });
    if (this.count - first <= FEW) this.count = first;
    else this.isTiled = true;
    return this.count > first;
  }

  private addBox(row: number, box: PixelBox): void {
    box.crop();
    const [left, right] = [Math.floor(box.left / DEPTH_TILE), Math.ceil(box.right / DEPTH_TILE)];
    const [low, high] = [Math.floor(box.low / DEPTH_TILE), Math.ceil(box.high / DEPTH_TILE)];
    for (let line = low; line < high; line++) {
      for (let tile = line * this.columns + left; tile < line * this.columns + right; tile++) {
        if (this.lastRow[tile] === row) continue;
        this.lastRow[tile] = row;
        this.add(row, tile);
      }
    }
  }

  private add(row: number, tile: number): void {
    if (this.count === this.words.length) this.grow();
    this.words[this.count++] = ((row << TILE_BITS) | tile) >>> 0;
  }

  private grow(): void {
    const { words } = this;
    this.dispose();
    this.allocate(2 * words.length);
    this.words.set(words);
  }

  /** Makes the texture and the indices for at least this many quads. */
  private allocate(capacity: number): void {
    const lines = Math.max(1, Math.ceil(capacity / ROWS_PER_LINE));
    this.words = new Uint32Array(lines * ROWS_PER_LINE);
    // three.js uploads parts of a texture only with four components.
    this.texture = new DataTexture(this.words, ROWS_PER_LINE / 4, lines, RGBAIntegerFormat, UnsignedIntType);
    this.reserve(this.words.length);
  }
}

/** A box in pixels around the pictures of balls. */
class PixelBox {
  left = 0;
  low = 0;
  right = 0;
  high = 0;
  private readonly isPerspective: boolean;
  private readonly near: number;
  private readonly width: number;
  private readonly height: number;
  /** Pixels for each unit of slope, or for each metre of an orthographic camera, and pixel of the view axis. */
  private readonly scaleX: number;
  private readonly scaleY: number;
  private readonly axisX: number;
  private readonly axisY: number;

  constructor({ uniforms }: FrameView) {
    const e = uniforms.clipFromView.value.elements;
    const { x, y } = uniforms.viewport.value;
    this.isPerspective = e[11] !== 0;
    this.near = uniforms.near.value;
    [this.width, this.height] = [x, y];
    [this.scaleX, this.scaleY] = [0.5 * x * e[0], 0.5 * y * e[5]];
    this.axisX = 0.5 * x * (1 + (this.isPerspective ? -e[8] : e[12]));
    this.axisY = 0.5 * y * (1 + (this.isPerspective ? -e[9] : e[13]));
  }

  clear(): void {
    this.left = this.low = Infinity;
    this.right = this.high = -Infinity;
  }

  /** Whether the box has no pixels of the picture. */
  get isEmpty(): boolean {
    return !(this.left < this.width && this.right > 0 && this.low < this.height && this.high > 0);
  }

  /** Extends the box by a ball in view space, metres; the part behind the near plane does not count. */
  extend(x: number, y: number, distance: number, radius: number): void {
    const far = distance + radius;
    if (far <= this.near) return;
    const close = this.isPerspective ? Math.max(distance - radius, this.near) : 1;
    const away = this.isPerspective ? far : 1;
    this.left = Math.min(this.left, this.axisX + this.scaleX * slope(x - radius, away, close));
    this.low = Math.min(this.low, this.axisY + this.scaleY * slope(y - radius, away, close));
    this.right = Math.max(this.right, this.axisX + this.scaleX * slope(x + radius, close, away));
    this.high = Math.max(this.high, this.axisY + this.scaleY * slope(y + radius, close, away));
  }

  /** Reduces the box to the picture. */
  crop(): void {
    this.left = Math.max(0, this.left);
    this.low = Math.max(0, this.low);
    this.right = Math.min(this.width, this.right);
    this.high = Math.min(this.height, this.high);
  }
}

function slope(aside: number, distanceIfPositive: number, distanceIfNegative: number): number {
  return aside / (aside > 0 ? distanceIfPositive : distanceIfNegative);
}
