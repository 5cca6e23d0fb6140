/**
 * A software rasteriser: projects a puff's mesh orthographically from +z to normal, depth, colour and coverage. It runs
 * on the CPU so that the layers are identical on every GPU and testable without one.
 *
 * Grids are square and span [-PUFF_PAD, PUFF_PAD]^2. Row 0 is at the bottom (y = -PUFF_PAD), as in WebGL textures.
 * Visibility is tested at the centres of SUPERSAMPLE^2 cells per texel. The normal, depth and colour of a texel are the
 * mean over its covered cells, because one sample per texel would alias two-tone shading at creases.
 */
import type { PuffMesh } from '../shapes.ts';
import { Paint } from './paint.ts';
import { finished, type Work } from '../../../base/work.ts';

/** Half the width of a nailboard in particle radii. It includes room for the ink ring around the silhouette. */
export const PUFF_PAD = 1.35;

/** Cells per texel of a layer, along x and along y. */
export const SUPERSAMPLE = 4;

/** Cells to test, and texels to gather, in a slice of about two milliseconds. */
const CELLS_A_SLICE = 40_000;
const TEXELS_A_SLICE = 1_000;
/** Cost of a triangle, in cells. */
const CELLS_A_TRIANGLE = 20;

/** The view of a puff from +z. */
export interface PuffRaster {
  /** Texels along each side. */
  readonly size: number;
  /** x, y, z per texel; unit length where covered, 0 elsewhere. */
  readonly normals: Float32Array;
  /** Relief in quad widths, positive towards the viewer, 0 in the centre plane; -Infinity where uncovered. */
  readonly depths: Float32Array;
  /** Red, green, blue per texel, 0..1, 0 where uncovered. Absent if the whole mesh is white. */
  readonly colors?: Float32Array;
  /** 1 where covered, on a grid with size * SUPERSAMPLE cells along each side. */
  readonly coverage: Uint8Array;
}

/** The nearest triangle at each cell's centre. */
interface Visibility {
  readonly cells: number;
  /** Position of the triangle in the mesh's `indices`; -1 where uncovered. */
  readonly triangles: Int32Array;
  /** z in particle radii. */
  readonly heights: Float32Array;
}

/** Rasterises the mesh into a grid of `size` by `size` texels. */
export function rasterise(mesh: PuffMesh, size: number): PuffRaster {
  return finished(rasterising(mesh, size));
}

/** As {@link rasterise}, in slices of a few milliseconds. */
export function* rasterising(mesh: PuffMesh, size: number): Work<PuffRaster> {
  const visible = yield* findingVisible(mesh, size * SUPERSAMPLE);
  const paint = Paint.of(mesh);
  const raster = {
    size,
    normals: new Float32Array(3 * size * size),
    depths: new Float32Array(size * size).fill(-Infinity),
    colors: paint && new Float32Array(3 * size * size),
    coverage: new Uint8Array(visible.triangles.length),
  };
  for (let cell = 0; cell < raster.coverage.length; cell++) raster.coverage[cell] = visible.triangles[cell] < 0 ? 0 : 1;
  yield;
  const texels = new TexelGatherer(mesh, visible, raster, paint);
  for (let texel = 0; texel < size * size; texel++) {
    texels.gather(texel);
    if (texel % TEXELS_A_SLICE === TEXELS_A_SLICE - 1) yield;
  }
  return raster;
}

/** Converts a coordinate of the unit space to grid coordinates. Cell centres have integer coordinates. */
function toCells(unit: number, cells: number): number {
  return (unit / PUFF_PAD + 1) * 0.5 * cells - 0.5;
}

function* findingVisible(mesh: PuffMesh, cells: number): Work<Visibility> {
  const visible = {
    cells,
    triangles: new Int32Array(cells * cells).fill(-1),
    heights: new Float32Array(cells * cells).fill(-Infinity),
  };
  let cost = 0;
  for (let triangle = 0; triangle < mesh.indices.length; triangle += 3) {
    cost += CELLS_A_TRIANGLE + scanTriangle(mesh, triangle, visible);
    if (cost < CELLS_A_SLICE) continue;
    cost = 0;
    yield;
  }
  return visible;
}

/**
 * Depth-tests one front-facing triangle. Shared edges belong to both triangles, so that there are no gaps.
 * @returns the number of tested cells
 */
function scanTriangle({ positions, indices }: PuffMesh, triangle: number, visible: Visibility): number {
  const { cells, triangles, heights } = visible;
  const [a, b, c] = [3 * indices[triangle], 3 * indices[triangle + 1], 3 * indices[triangle + 2]];
  const [ax, ay] = [toCells(positions[a], cells), toCells(positions[a + 1], cells)];
  const [bx, by] = [toCells(positions[b], cells), toCells(positions[b + 1], cells)];
  const [cx, cy] = [toCells(positions[c], cells), toCells(positions[c + 1], cells)];
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (area <= 0) return 0;
  const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx)));
  const right = Math.min(cells - 1, Math.floor(Math.max(ax, bx, cx)));
  const bottom = Math.max(0, Math.ceil(Math.min(ay, by, cy)));
  const top = Math.min(cells - 1, Math.floor(Math.max(ay, by, cy)));
  for (let y = bottom; y <= top; y++) {
    for (let x = left; x <= right; x++) {
      const wa = (bx - x) * (cy - y) - (by - y) * (cx - x);
      const wb = (cx - x) * (ay - y) - (cy - y) * (ax - x);
      const wc = area - wa - wb;
      if (wa < 0 || wb < 0 || wc < 0) continue;
      const height = (wa * positions[a + 2] + wb * positions[b + 2] + wc * positions[c + 2]) / area;
      const cell = y * cells + x;
      if (height <= heights[cell]) continue;
      heights[cell] = height;
      triangles[cell] = triangle;
    }
  }
  return Math.max(0, right - left + 1) * Math.max(0, top - bottom + 1);
}

/** Writes the means over the covered cells of texels. An uncovered texel is left unchanged. */
class TexelGatherer {
  private readonly mesh: PuffMesh;
  private readonly visible: Visibility;
  private readonly raster: PuffRaster;
  private readonly paint: Paint | undefined;
  /** Barycentric weights of the cell in its triangle, times twice the area of the triangle. */
  private readonly weights: [number, number, number] = [0, 0, 0];

  constructor(mesh: PuffMesh, visible: Visibility, raster: PuffRaster, paint: Paint | undefined) {
    this.mesh = mesh;
    this.visible = visible;
    this.raster = raster;
    this.paint = paint;
  }

  gather(texel: number): void {
    const { size, normals, depths, colors } = this.raster;
    const { cells, triangles, heights } = this.visible;
    const [x, y] = [texel % size, Math.floor(texel / size)];
    const normal = normals.subarray(3 * texel, 3 * texel + 3);
    const color = colors?.subarray(3 * texel, 3 * texel + 3);
    let height = 0;
    let covered = 0;
    for (let j = y * SUPERSAMPLE; j < (y + 1) * SUPERSAMPLE; j++) {
      for (let i = x * SUPERSAMPLE; i < (x + 1) * SUPERSAMPLE; i++) {
        const triangle = triangles[j * cells + i];
        if (triangle < 0) continue;
        this.weigh(triangle, i, j);
        this.addNormal(triangle, normal);
        if (color) this.paint!.add(triangle, this.weights, color);
        height += heights[j * cells + i];
        covered++;
      }
    }
    if (covered === 0) return;
    depths[texel] = height / covered / (2 * PUFF_PAD);
    normalise(normal);
    if (color) for (let channel = 0; channel < 3; channel++) color[channel] /= covered;
  }

  private weigh(triangle: number, x: number, y: number): void {
    const { positions, indices } = this.mesh;
    const { cells } = this.visible;
    const a = 3 * indices[triangle];
    const b = 3 * indices[triangle + 1];
    const c = 3 * indices[triangle + 2];
    const ax = toCells(positions[a], cells) - x;
    const ay = toCells(positions[a + 1], cells) - y;
    const bx = toCells(positions[b], cells) - x;
    const by = toCells(positions[b + 1], cells) - y;
    const cx = toCells(positions[c], cells) - x;
    const cy = toCells(positions[c + 1], cells) - y;
    this.weights[0] = bx * cy - by * cx;
    this.weights[1] = cx * ay - cy * ax;
    this.weights[2] = ax * by - ay * bx;
  }

  /** Adds the interpolated unit normal of a triangle to `sum`. */
  private addNormal(triangle: number, sum: Float32Array): void {
    const { normals, indices } = this.mesh;
    const [wa, wb, wc] = this.weights;
    const a = 3 * indices[triangle];
    const b = 3 * indices[triangle + 1];
    const c = 3 * indices[triangle + 2];
    const nx = wa * normals[a] + wb * normals[b] + wc * normals[c];
    const ny = wa * normals[a + 1] + wb * normals[b + 1] + wc * normals[c + 1];
    const nz = wa * normals[a + 2] + wb * normals[b + 2] + wc * normals[c + 2];
    const scale = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
    sum[0] += nx * scale;
    sum[1] += ny * scale;
    sum[2] += nz * scale;
  }
}

function normalise(vector: Float32Array): void {
  const [x, y, z] = vector;
  const scale = 1 / Math.sqrt(x * x + y * y + z * z);
  vector[0] = x * scale;
  vector[1] = y * scale;
  vector[2] = z * scale;
}
