/** Traces masks of pixels to closed lines in whole units. */
import { SIDE, type Line, type Point } from '../../renderer/puffs/drawing/drawing.ts';
import { simplifyArc } from './simplify.ts';

const STEPS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
];

/** The outlines of a mask along the edges of its pixels. The mask is empty at the border. */
export function ringsOf(mask: Uint8Array): Line[] {
  // Edges that leave each corner, one bit a direction, with the mask on their right.
  const edges = new Uint8Array(SIDE * SIDE);
  mask.forEach((isIn, at) => {
    if (!isIn) return;
    if (!mask[at - SIDE]) edges[at] |= 1;
    if (!mask[at + 1]) edges[at + 1] |= 2;
    if (!mask[at + SIDE]) edges[at + SIDE + 1] |= 4;
    if (!mask[at - 1]) edges[at + SIDE] |= 8;
  });
  const rings: Line[] = [];
  for (let corner = 0; corner < edges.length; corner++) while (edges[corner]) rings.push(ringFrom(corner, edges));
  return rings;
}

/** Follows edges from a corner back to it, and removes them. */
function ringFrom(start: number, edges: Uint8Array): Line {
  const ring: Point[] = [];
  let corner = start;
  let heading = 31 - Math.clz32(edges[start]);
  do {
    // Where pixels meet at a corner, they stay apart.
    const next = [heading + 1, heading, heading + 3].map((way) => way & 3).find((way) => edges[corner] & (1 << way));
    heading = next ?? heading;
    edges[corner] &= ~(1 << heading);
    ring.push([corner % SIDE, Math.floor(corner / SIDE)]);
    corner += STEPS[heading][0] + SIDE * STEPS[heading][1];
  } while (corner !== start);
  return [...ring, ring[0]];
}

/** The area inside a ring. */
export function areaOf(ring: Line): number {
  const twice = ring.reduce((sum, [x, y], at) => {
    const [nextX, nextY] = ring[at + 1] ?? ring[0];
    return sum + x * nextY - y * nextX;
  }, 0);
  return Math.abs(twice) / 2;
}

/** The line with fewer points, in whole units. */
export function simplified(line: Line, tolerance: number): Line {
  const points = simplifyArc(line, tolerance).map(([x, y]): Point => [rounded(x), rounded(y)]);
  return points.filter(([x, y], at) => at === 0 || x !== points[at - 1][0] || y !== points[at - 1][1]);
}

/** Rounds halves away from the middle, so that symmetric drawings stay symmetric. */
function rounded(place: number): number {
  const away = place - SIDE / 2;
  return SIDE / 2 + Math.sign(away) * Math.min(SIDE / 2 - 1, Math.round(Math.abs(away)));
}
