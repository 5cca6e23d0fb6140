/**
 * Bakes puff shapes to the texture layers that the shaders read, one layer per shape, after section 4.1 of McGuire and
 * Fein (2006): one RGBA texture for normal and depth, one for colour and coverage.
 *
 * - `normalDepth`: rgb = (N + 1) / 2, a = d + 0.5 (Eq. 1), as half floats, or with a precision of 8 bits as integers, as
 *   in the paper. N is the unit view-space normal of the unrolled puff, d the relief in quad widths, positive towards the
 *   viewer. 8 bits cause visible steps of 0.4 % of the quad width where puffs intersect at grazing angles. Half floats
 *   make them eight times finer and are filterable on all devices. Texels outside the silhouette repeat the nearest
 *   inside value, so that linear filtering never mixes in background.
 * - `colorCoverage` (bytes): rgb = C, the colours of a mesh, a drawing or a sheet, else white. Texels outside the
 *   silhouette repeat the nearest inside value. Shaders select the ink by distance; ink painted into C would turn grey
 *   when filtered. a = 0.5 + distance / DISTANCE_RANGE, with the signed distance to the silhouette in particle radii,
 *   negative inside. A distance field keeps edge and ink crisp at any size; a mask would not.
 *
 * Row 0 of a layer is its bottom (texture v = 0). Layers are contiguous.
 */
import { findingNearest, measuringDistance } from './distance.ts';
import { puffMesh } from './mesh.ts';
import { PUFF_PAD, rasterising, SUPERSAMPLE, type PuffRaster } from './rasterise.ts';
import { readDrawings } from '../drawing/drawing.ts';
import { rasterisingDrawing } from '../drawing/relief.ts';
import { choosingDiscs } from './inscribedDiscs.ts';
import { isOwnPicture } from './sides.ts';
import { resamplingTile } from './resample.ts';
import type { Lobe, PuffShape } from '../shapes.ts';
import { finished, type Work } from '../../../base/work.ts';

/** Bits of normals and depths: 16 for half floats, 8 for the integers of the paper. */
export type Precision = 16 | 8;

/**
 * Range of the coverage channel in particle radii, half inside and half outside the silhouette. The outer half is the
 * room that the pad leaves for ink at the widest point of a puff. Larger distances are clamped.
 */
export const DISTANCE_RANGE = 2 * (PUFF_PAD - 1);

/** Measurements of a baked puff, in particle radii. */
export interface PuffFigures {
  /** Radius of the disc with the area of the silhouette. */
  readonly silhouetteRadius: number;
  /** Radius of the largest disc about the particle's centre inside the silhouette. */
  readonly inscribedRadius: number;
  /** How far the silhouette extends in 16 directions, evenly spaced from the x axis on. */
  readonly supports: Float32Array;
  /** Radius of the smallest disc about the particle's centre that contains the silhouette. */
  readonly outerRadius: number;
  /** Height of the highest point above the centre plane, towards the viewer. */
  readonly relief: number;
  /** Discs inside the silhouette, if it is that of a picture of its own and so throws shadow; else none. */
  readonly discs: readonly Lobe[];
  /** Depth of the deepest visible point below the centre plane; 0 if there is none. */
  readonly depth: number;
}

/** The baked layers of all variations. */
export interface PuffLayers {
  /** Texels along each side of a layer. */
  readonly size: number;
  /** Number of layers. */
  readonly count: number;
  /** Half the quad's width in particle radii. */
  readonly pad: number;
  /** Signed distance = (coverage - 0.5) * distanceRange, in particle radii, negative inside the silhouette. */
  readonly distanceRange: number;
  /** RGBA, 4 * size * size per layer: half floats, or bytes that hold 255 times the value. */
  readonly normalDepth: Uint16Array | Uint8Array;
  /** RGBA bytes, 4 * size * size per layer. */
  readonly colorCoverage: Uint8Array;
  /** One entry per layer. */
  readonly figures: readonly PuffFigures[];
}

interface LayerOptions {
  /** Texels along each side of a layer, default 128. */
  readonly size?: number;
  /** Bits of each channel of `normalDepth`, default 16. */
  readonly precision?: Precision;
}

/** Rasterises the shapes into layers. Pure and deterministic. */
export function bakePuffs(shapes: readonly PuffShape[], options?: LayerOptions): PuffLayers {
  return finished(bakingLayers(shapes, options));
}

/** As {@link bakePuffs}, in slices of a few milliseconds. */
export function* bakingLayers(
  shapes: readonly PuffShape[],
  { size = 128, precision = 16 }: LayerOptions = {},
): Work<PuffLayers> {
  const texels = size * size;
  const normalDepth = new (precision === 8 ? Uint8Array : Uint16Array)(4 * texels * shapes.length);
  const colorCoverage = new Uint8Array(4 * texels * shapes.length);
  const figures: PuffFigures[] = [];
  const areOwn = shapes.some(isOwnPicture);
  for (const [layer, shape] of shapes.entries()) {
    const raster = yield* rasterisingShape(shape, size);
    yield;
    const distance = yield* measuringDistance(raster.coverage, size * SUPERSAMPLE);
    const nearest = yield* findingCovered(raster);
    yield;
    writeNormalDepth(raster, nearest, normalDepth.subarray(4 * texels * layer));
    yield;
    writeColorCoverage(raster, nearest, distance, colorCoverage.subarray(4 * texels * layer));
    yield;
    const discs = areOwn ? yield* choosingDiscs(distance, size * SUPERSAMPLE) : [];
    figures.push({ ...measure(raster, distance), discs });
  }
  return {
    size,
    count: shapes.length,
    pad: PUFF_PAD,
    distanceRange: DISTANCE_RANGE,
    normalDepth,
    colorCoverage,
    figures,
  };
}

/** The view of a shape from +z: of its drawing, its sheet, its mesh or its lobes. */
export function* rasterisingShape({ lobes, mesh, drawing, sheet }: PuffShape, size: number): Work<PuffRaster> {
  if (drawing) return yield* rasterisingDrawing(readDrawings(drawing)[0], size);
  if (sheet) return yield* resamplingTile(sheet, size);
  const triangles = mesh ?? puffMesh(lobes);
  yield;
  return yield* rasterising(triangles, size);
}

/** The nearest covered texel of each texel. */
export function* findingCovered({ size, depths }: PuffRaster): Work<Int32Array> {
  const isCovered = Uint8Array.from(depths, (depth) => (depth > -Infinity ? 1 : 0));
  return (yield* findingNearest(isCovered, 1, size)).nearest;
}

function writeNormalDepth(raster: PuffRaster, nearest: Int32Array, layer: Uint16Array | Uint8Array): void {
  const { size, normals, depths } = raster;
  const encoded = layer instanceof Uint8Array ? (share: number) => Math.round(255 * share) : toHalf;
  for (let texel = 0; texel < size * size; texel++) {
    const from = nearest[texel];
    for (let axis = 0; axis < 3; axis++) layer[4 * texel + axis] = encoded((normals[3 * from + axis] + 1) / 2);
    layer[4 * texel + 3] = encoded(depths[from] + 0.5);
  }
}

function writeColorCoverage(
  { size, colors }: PuffRaster,
  nearest: Int32Array,
  distance: Float32Array,
  layer: Uint8Array,
): void {
  const fine = size * SUPERSAMPLE;
  const unitsPerCell = (2 * PUFF_PAD) / fine;
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const units = middleDistance(distance, fine, x, y) * unitsPerCell;
      const share = Math.min(1, Math.max(0, 0.5 + units / DISTANCE_RANGE));
      const texel = y * size + x;
      for (let channel = 0; channel < 3; channel++) {
        layer[4 * texel + channel] = colors ? Math.round(255 * colors[3 * nearest[texel] + channel]) : 255;
      }
      layer[4 * texel + 3] = Math.round(share * 255);
    }
  }
}

/** Distance at the centre of texel (x, y): the mean of the four fine cells that meet there. */
function middleDistance(distance: Float32Array, fine: number, x: number, y: number): number {
  const cell = (y * SUPERSAMPLE + SUPERSAMPLE / 2 - 1) * fine + x * SUPERSAMPLE + SUPERSAMPLE / 2 - 1;
  return (distance[cell] + distance[cell + 1] + distance[cell + fine] + distance[cell + fine + 1]) / 4;
}

function measure(raster: PuffRaster, distance: Float32Array): Omit<PuffFigures, 'discs'> {
  const fine = raster.size * SUPERSAMPLE;
  let covered = 0;
  let inscribed = Infinity;
  let outer = 0;
  const supports = new Float32Array(SUPPORTS).fill(-Infinity);
  for (let cell = 0; cell < distance.length; cell++) {
    const x = (cell % fine) + 0.5 - fine / 2;
    const y = Math.floor(cell / fine) + 0.5 - fine / 2;
    const squared = x * x + y * y;
    if (distance[cell] < 0) {
      covered++;
      outer = Math.max(outer, squared);
      if (distance[cell] > -BORDER) support(supports, x, y);
    } else {
      inscribed = Math.min(inscribed, squared);
    }
  }
  const unitsPerCell = (2 * PUFF_PAD) / fine;
  return {
    silhouetteRadius: Math.sqrt(covered / Math.PI) * unitsPerCell,
    inscribedRadius: Math.sqrt(inscribed) * unitsPerCell,
    supports: supports.map((extent) => extent * unitsPerCell),
    outerRadius: Math.sqrt(outer) * unitsPerCell,
    relief: raster.depths.reduce((a, b) => Math.max(a, b)) * 2 * PUFF_PAD,
    depth: -raster.depths.reduce((a, b) => (b > -Infinity ? Math.min(a, b) : a), 0) * 2 * PUFF_PAD,
  };
}

/** Directions in which supports are measured; a multiple of four. */
const SUPPORTS = 16;
/** Largest distance from the silhouette of the cells that can be farthest in a direction, in cells. */
const BORDER = 2;

/** Extends supports to a point. */
function support(supports: Float32Array, x: number, y: number): void {
  for (let direction = 0; direction < SUPPORTS; direction++) {
    const angle = (2 * Math.PI * direction) / SUPPORTS;
    supports[direction] = Math.max(supports[direction], x * Math.cos(angle) + y * Math.sin(angle));
  }
}

/** A texture sample of a puff, linearly filtered, with a normalised normal as in the shaders. */
export interface PuffSample {
  /** Unit normal in the view space of the unrolled puff. */
  readonly normal: readonly [x: number, y: number, z: number];
  /** Height above the centre plane in particle radii. */
  readonly height: number;
  /** Signed distance to the silhouette in particle radii, negative inside, clamped to half of distanceRange. */
  readonly distance: number;
}

/** Samples a layer at (x, y) in particle radii, clamped to the outermost texel centres. */
export function samplePuff(layers: PuffLayers, layer: number, x: number, y: number): PuffSample {
  const { size, pad, distanceRange } = layers;
  const u = Math.min(size - 1, Math.max(0, (x / pad + 1) * 0.5 * size - 0.5));
  const v = Math.min(size - 1, Math.max(0, (y / pad + 1) * 0.5 * size - 0.5));
  const left = Math.min(size - 2, Math.floor(u));
  const bottom = Math.min(size - 2, Math.floor(v));
  const texel = 4 * (layer * size * size + bottom * size + left);
  const [right, up] = [u - left, v - bottom];
  const nx = filtered(layers.normalDepth, size, texel, right, up) * 2 - 1;
  const ny = filtered(layers.normalDepth, size, texel + 1, right, up) * 2 - 1;
  const nz = filtered(layers.normalDepth, size, texel + 2, right, up) * 2 - 1;
  const scale = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
  return {
    normal: [nx * scale, ny * scale, nz * scale],
    height: (filtered(layers.normalDepth, size, texel + 3, right, up) - 0.5) * 2 * pad,
    distance: (filtered(layers.colorCoverage, size, texel + 3, right, up) - 0.5) * distanceRange,
  };
}

function filtered(data: Uint16Array | Uint8Array, size: number, at: number, right: number, up: number): number {
  const above = at + 4 * size;
  const [a, b, c, d] = [data[at], data[at + 4], data[above], data[above + 4]];
  if (data instanceof Uint8Array) return blended(a, b, c, d, right, up) / 255;
  return blended(fromHalf(a), fromHalf(b), fromHalf(c), fromHalf(d), right, up);
}

function blended(a: number, b: number, c: number, d: number, right: number, up: number): number {
  return (a * (1 - right) + b * right) * (1 - up) + (c * (1 - right) + d * right) * up;
}

/** Half floats (IEEE 754 binary16), in the format of WebGL's HALF_FLOAT textures. */

const float = new Float32Array(1);
const bits = new Uint32Array(float.buffer);

/** Bits of the half float nearest to `value`, ties to even. Overflow gives an infinity, below 2^-25 a zero. */
export function toHalf(value: number): number {
  float[0] = value;
  const sign = (bits[0] >>> 16) & 0x8000;
  const magnitude = bits[0] & 0x7fffffff;
  if (magnitude >= 0x7f800001) return sign | 0x7e00;
  if (magnitude >= 0x477ff000) return sign | 0x7c00;
  if (magnitude >= 0x38800000) {
    const rebased = magnitude - 0x38000000;
    return sign | ((rebased + 0xfff + ((rebased >>> 13) & 1)) >>> 13);
  }
  // Adding 0.5 lets the hardware round the subnormal's mantissa into the low bits, ties to even.
  float[0] = Math.abs(value) + 0.5;
  return sign | (bits[0] - 0x3f000000);
}

/** The value of a half float's bits. */
export function fromHalf(half: number): number {
  const sign = half & 0x8000 ? -1 : 1;
  const magnitude = half & 0x7fff;
  if (magnitude >= 0x7c00) return magnitude > 0x7c00 ? NaN : sign * Infinity;
  if (magnitude < 0x0400) return sign * magnitude * 2 ** -24;
  bits[0] = (magnitude << 13) + 0x38000000;
  return sign * float[0];
}
