/** Discs inside a silhouette, which surely cover what is behind them. */
import { measuringDistance } from './distance.ts';
import { PUFF_PAD } from './rasterise.ts';
import { MAX_LOBES } from '../../../base/constants.ts';
import type { Work } from '../../../base/work.ts';
import type { Lobe } from '../shapes.ts';

/** About the most candidate centres along each side, and the fewest cells from one to the next. */
const MAX_PLACES = 64;
const MIN_STRIDE = 4;
/** Minimum area that a further disc adds, relative to the first one. */
const MIN_GAIN = 0.01;

interface Disc {
  /** Of the centre, in cells. */
  readonly x: number;
  readonly y: number;
  /** Cells. */
  readonly radius: number;
}

/**
 * Chooses discs inside a region, see {@link choosingDiscs}.
 * @param coverage 1 inside, per cell, row 0 at the bottom
 * @param size cells along each side of the grid, which spans a layer
 */
export function* discsInside(coverage: Uint8Array, size: number): Work<Lobe[]> {
  return yield* choosingDiscs(yield* measuringDistance(coverage, size), size);
}

/**
 * Chooses up to MAX_LOBES discs inside a silhouette, each time the one that adds the most area.
 * @param distance signed distance to the silhouette in cells, negative inside, row 0 at the bottom
 * @param size cells along each side of the grid, which spans a layer
 * @returns flat balls in the centre plane, in particle radii; a point if the silhouette has no room for a disc
 */
export function* choosingDiscs(distance: Float32Array, size: number): Work<Lobe[]> {
  const places = placesIn(distance, size);
  const chosen: Disc[] = [];
  for (let least = 0; chosen.length < MAX_LOBES; least = MIN_GAIN * chosen[0].radius ** 2) {
    let [best, gain] = [undefined as Disc | undefined, least];
    for (const place of places) {
      const added = chosen.reduce((area, disc) => area - overlap(place, disc), place.radius ** 2);
      if (added > gain) [best, gain] = [place, added];
    }
    if (!best) break;
    chosen.push(best);
    yield;
  }
  const unitsPerCell = (2 * PUFF_PAD) / size;
  const discs = chosen.map(({ x, y, radius }): Lobe => {
    const [right, up] = [x, y].map((at) => (at + 0.5) * unitsPerCell - PUFF_PAD);
    return { center: [right, up, 0], radius: radius * unitsPerCell };
  });
  return discs.length > 0 ? discs : [{ center: [0, 0, 0], radius: 1e-3 }];
}

/** Candidate discs that are at least half a cell inside the silhouette. */
function placesIn(distance: Float32Array, size: number): Disc[] {
  const places: Disc[] = [];
  const stride = Math.max(MIN_STRIDE, Math.floor(size / MAX_PLACES));
  for (let y = 0; y < size; y += stride) {
    for (let x = 0; x < size; x += stride) {
      const radius = -distance[y * size + x] - 0.5;
      if (radius > 0.5) places.push({ x, y, radius });
    }
  }
  return places;
}

/** About the common area of two discs, divided by pi. */
function overlap(a: Disc, b: Disc): number {
  const smaller = Math.min(a.radius, b.radius);
  const reach = a.radius + b.radius - Math.sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2);
  return smaller * smaller * Math.min(1, Math.max(0, reach / (2 * smaller)));
}
