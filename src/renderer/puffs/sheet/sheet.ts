/** Images that hold up to four puffs, and their validation. */
import { ShapeError } from '../../../base/errors.ts';
import type { PixelImage } from '../shapes.ts';

/** The two textures of Fig. 3 of McGuire and Fein (2006), of the same size. docs/three.md has the format. */
export interface PuffTextures {
  /** Red, green, blue: (N + 1) / 2. Alpha: d + 0.5. */
  readonly normalDepth: PixelImage;
  /** Red, green, blue: C, sRGB. Alpha: coverage. */
  readonly colorCoverage: PixelImage;
}

/** One image for stylised smoke. Red and green, light from a side and from behind, are not read. */
export interface PackedPuffs {
  /** Blue: depth, white is near. Alpha: coverage. */
  readonly lightRimDepthMask: PixelImage;
}

/** The channels that are read of a valid sheet. */
export interface SheetSource {
  /** Pixels along each side of a tile. */
  readonly tile: number;
  /** Tiles along each side of the sheet. */
  readonly tiles: 1 | 2;
  /** RGBA. */
  readonly surface: ArrayLike<number>;
  readonly depthChannel: 2 | 3;
  /** RGBA. */
  readonly paint: ArrayLike<number>;
  /** Whether the sheet has normals and colours. */
  readonly hasNormals: boolean;
}

/** Puffs of a sheet, along each side. */
export const MAX_TILES = 2;
/** Pixels along each side of an image, and of the smallest tile. */
const MAX_PIXELS = 8192;
export const MIN_TILE = 16;

const ACCEPTED =
  'Pass { normalDepth, colorCoverage }, or { lightRimDepthMask }. Each is an image with width, height and RGBA bytes.';

/**
 * @param tiles along each side; if undefined, one if the middle of the sheet is covered
 * @throws ShapeError with the fault and what is accepted
 */
export function requireSheet(sheet: PuffTextures | PackedPuffs, tiles: unknown): SheetSource {
  if (typeof sheet !== 'object' || sheet === null) throw new ShapeError(`This is not a puff sheet. ${ACCEPTED}`);
  const given = sheet as Partial<PuffTextures & PackedPuffs>;
  const names = (['normalDepth', 'colorCoverage', 'lightRimDepthMask'] as const).filter((name) => given[name]);
  if (names.length === 1 && names[0] !== 'lightRimDepthMask') {
    const missing = names[0] === 'normalDepth' ? 'colorCoverage' : 'normalDepth';
    throw new ShapeError(`The puff sheet has ${names[0]}, but its second image, ${missing}, is missing. ${ACCEPTED}`);
  }
  const isPair = names.join() === 'normalDepth,colorCoverage';
  if (!isPair && names.join() !== 'lightRimDepthMask') throw new ShapeError(`This is not a puff sheet. ${ACCEPTED}`);
  const [surface, paint = surface] = names.map((name) => requireImage(name, given[name]!));
  if (surface.width !== paint.width) {
    const sizes = [surface, paint].map(({ width }) => `${width} x ${width}`).join(' and ');
    throw new ShapeError(`The images of the puff sheet have ${sizes} pixels. Save both in the same size.`);
  }
  const columns = requireTiles(tiles ?? tilesOf(paint), surface.width);
  return {
    tile: surface.width / columns,
    tiles: columns,
    surface: surface.data,
    depthChannel: isPair ? 3 : 2,
    paint: paint.data,
    hasNormals: isPair,
  };
}

function requireImage(name: string, image: PixelImage): PixelImage {
  const { width, height, data } = image;
  const size = `${width} x ${height}`;
  if (![width, height].every((length) => Number.isInteger(length) && length > 0)) {
    throw new ShapeError(`${name} has ${size} pixels. Its width and height must be whole numbers.`);
  }
  if (width !== height) {
    throw new ShapeError(`${name} has ${size} pixels. It must be square: one tile, or two rows of two square tiles.`);
  }
  if (width > MAX_PIXELS) {
    throw new ShapeError(`${name} has ${size} pixels. The limit is ${MAX_PIXELS} x ${MAX_PIXELS}. Make it smaller.`);
  }
  if (!ArrayBuffer.isView(data) || data.BYTES_PER_ELEMENT !== 1) {
    throw new ShapeError(`${name} must hold bytes: its data must be a Uint8Array or a Uint8ClampedArray.`);
  }
  if (data.length !== 4 * width * height) {
    throw new ShapeError(
      `${name} has ${data.length} bytes. An image of ${size} pixels has ${4 * width * height}: four for each pixel.`,
    );
  }
  return image;
}

function requireTiles(tiles: unknown, width: number): 1 | 2 {
  if (tiles !== 1 && tiles !== MAX_TILES) {
    throw new ShapeError(`A puff sheet cannot have ${String(tiles)} tiles along each side: use 1 or ${MAX_TILES}.`);
  }
  if (width % tiles !== 0 || width / tiles < MIN_TILE) {
    throw new ShapeError(
      `The puff sheet has ${width} pixels along each side. With ${tiles} tiles there, it must be a multiple of ${tiles}, and at least ${tiles * MIN_TILE}.`,
    );
  }
  return tiles;
}

/** The middle of a sheet is covered if it has one tile, and is the corner of four tiles otherwise. */
function tilesOf({ width, data }: PixelImage): 1 | 2 {
  const middle = Math.floor(width / 2);
  return width % 2 === 1 || data[4 * (middle * width + middle) + 3] >= 128 ? 1 : 2;
}
