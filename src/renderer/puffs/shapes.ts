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

/** An image in bytes, as the browser's `ImageData`: RGBA, sRGB, top row first. Alpha is ignored. */
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

/** One variation of a puff. The first lobe is its dominant mass. */
export interface PuffShape {
  readonly name: string;
  readonly lobes: readonly Lobe[];
  /** What billboards are baked from instead of the lobes, made by `fitPuff`. It must not change afterwards. */
  readonly mesh?: PuffMesh;
  /** What billboards show instead of the lobes: the text of a drawing, made by `drawPuff`. */
  readonly drawing?: string;
}

const meshKeys = new WeakMap<PuffMesh, number>();
let meshes = 0;

/** Equal for shapes that are drawn alike. */
export function keyOf(shapes: readonly PuffShape[]): string {
  const keyOfMesh = (mesh: PuffMesh): number => {
    if (!meshKeys.has(mesh)) meshKeys.set(mesh, ++meshes);
    return meshKeys.get(mesh)!;
  };
  return JSON.stringify(
    shapes.map(({ lobes, mesh, drawing }) => (mesh ? [lobes, keyOfMesh(mesh)] : drawing ? [lobes, drawing] : lobes)),
  );
}
