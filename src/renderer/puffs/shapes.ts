/**
 * A puff is a union of a few overlapping spheres (lobes): one dominant mass and lobes of different sizes around it.
 *
 * The unit space of a puff: x right, y up, z towards the viewer, the particle's centre at the origin, one unit = the
 * particle's radius.
 */

/** A sphere of a puff, in its unit space. */
export interface Lobe {
  readonly center: readonly [x: number, y: number, z: number];
  readonly radius: number;
}

/** An image in bytes, as the browser's `ImageData`: RGBA, top row first, alpha not multiplied into the colours. */
export interface PixelImage {
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  /** 4 * width * height. */
  readonly data: Uint8Array | Uint8ClampedArray;
}

/** Triangles, counter-clockwise seen from outside, in the unit space of a puff. */
export interface PuffMesh {
  /** x, y, z per vertex. */
  readonly positions: Float32Array;
  /** x, y, z per vertex, unit length. */
  readonly normals: Float32Array;
  /** Three vertices per triangle. */
  readonly indices: Uint32Array;
  /** Red, green, blue per vertex, sRGB, 0..1. White where absent. */
  readonly colors?: Float32Array;
  /** u to the right and v down per vertex, in sides of `texture`, which repeats. */
  readonly uvs?: Float32Array;
  readonly texture?: PixelImage;
}

/**
 * A picture of the front of a puff, its centre at the centre of the particle, top row first. Texels that are not covered
 * have any value in the other channels.
 */
export interface PuffTile {
  /** Texels along each side. */
  readonly size: number;
  /** Half the width of the tile in particle radii. */
  readonly pad: number;
  /** x right, y up, z towards the viewer per texel; unit length where covered. */
  readonly normals: Float32Array;
  /** Height above the centre plane per texel, in widths of the tile. */
  readonly depths: Float32Array;
  /** Covered share per texel, 0..1. The silhouette is where it crosses 0.5. */
  readonly mask: Float32Array;
  /** Red, green, blue per texel, sRGB, 0..1. White where absent. */
  readonly colors?: Float32Array;
}

/** One variation of a puff. The first lobe is its dominant mass. */
export interface PuffShape {
  readonly name: string;
  readonly lobes: readonly Lobe[];
  /** What billboards are baked from instead of the lobes, made by `fitPuff`. It must not change afterwards. */
  readonly mesh?: PuffMesh;
  /** What billboards show instead of the lobes: the text of a drawing, made by `drawPuff`. */
  readonly drawing?: string;
  /** What billboards are baked from instead of the lobes, made by `readPuffSheet`. It must not change afterwards. */
  readonly sheet?: PuffTile;
}

const sourceKeys = new WeakMap<object, number>();
let sources = 0;

/** Equal for shapes that are drawn alike. */
export function keyOf(shapes: readonly PuffShape[]): string {
  const keyOfSource = (source: object): number => {
    if (!sourceKeys.has(source)) sourceKeys.set(source, ++sources);
    return sourceKeys.get(source)!;
  };
  return JSON.stringify(
    shapes.map(({ lobes, mesh, drawing, sheet }) => {
      const source = sheet ?? mesh;
      return [lobes, drawing ?? (source && keyOfSource(source))];
    }),
  );
}
