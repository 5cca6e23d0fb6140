/**
 * Bounds of baked meshes for the occlusion culling: the balls that approximate a mesh, enlarged or shrunk so that the
 * baked front deviates from them equally far inwards and outwards.
 */
import { samplePuff, type PuffLayers } from './layers.ts';
import type { Lobe } from '../shapes.ts';
import type { Work } from '../../../base/work.ts';

/** Balls, and the largest deviation of the front from them at the centres of texels, in particle radii. */
export interface BoundedFront {
  readonly balls: readonly Lobe[];
  readonly deviation: number;
}

/** Radius of a ball that covers nothing. A radius of 0 would mark it as missing. */
const LEAST_RADIUS = 1e-3;

/** Rows of texels in a slice of about two milliseconds. */
const ROWS_A_SLICE = 16;

/** Fits balls to the front of a layer, in slices. */
export function* boundingFront(layers: PuffLayers, layer: number, balls: readonly Lobe[]): Work<BoundedFront> {
  const { size, pad } = layers;
  const texel = (2 * pad) / size;
  let [beyond, within] = [0, 0];
  for (let at = 0; at < size * size; at++) {
    const x = ((at % size) + 0.5) * texel - pad;
    const y = (Math.floor(at / size) + 0.5) * texel - pad;
    const { height, distance } = samplePuff(layers, layer, x, y);
    // Outside the silhouette nothing is drawn at any height.
    const gaps = balls.map((ball) => gapTo(ball, x, y, distance <= 0 ? height : -Infinity));
    if (distance <= 0) beyond = Math.max(beyond, Math.min(...gaps));
    within = Math.max(within, -Math.min(...gaps));
    if (at % (ROWS_A_SLICE * size) === 0) yield;
  }
  const growth = (beyond - within) / 2;
  return {
    balls: balls.map(({ center, radius }) => ({ center, radius: Math.max(LEAST_RADIUS, radius + growth) })),
    deviation: (beyond + within) / 2,
  };
}

/** How far a ball ends before a point of the front; negative if the point is inside, or behind its middle. */
function gapTo({ center: [cx, cy, cz], radius }: Lobe, x: number, y: number, height: number): number {
  const beside = (x - cx) ** 2 + (y - cy) ** 2;
  return Math.sqrt(height > cz ? beside + (height - cz) ** 2 : beside) - radius;
}
