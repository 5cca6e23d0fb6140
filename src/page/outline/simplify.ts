/** A pixel corner, or a point between two corners. */
export type Point = readonly [x: number, y: number];

/**
 * Simplifies a polyline and smooths pixel staircases. The result does not depend on direction, and the end points stay.
 * @param tolerance maximum deviation in pixels
 */
export function simplifyArc(corners: readonly Point[], tolerance: number): Point[] {
  const isReversed = comesLater(corners);
  const line = smoothed(isReversed ? corners.toReversed() : corners);
  const kept = withoutNeedless(line, tolerance);
  return isReversed ? kept.toReversed() : kept;
}

/** Whether the reversed direction is the canonical one. */
function comesLater(corners: readonly Point[]): boolean {
  const last = corners.length - 1;
  for (let at = 0; at <= last / 2; ++at) {
    const [x, y] = corners[at];
    const [otherX, otherY] = corners[last - at];
    if (x !== otherX || y !== otherY) return x > otherX || (x === otherX && y > otherY);
  }
  return false;
}

/** Replaces corners with the midpoints of edges, which turns a pixel staircase into a slope. The end points stay. */
function smoothed(corners: readonly Point[]): Point[] {
  const middles = corners.slice(1).map(([x, y], at): Point => [(x + corners[at][0]) / 2, (y + corners[at][1]) / 2]);
  return [corners[0], ...middles, corners.at(-1)!];
}

/** Douglas-Peucker simplification (1973). It is iterative because outlines have many thousand points. */
function withoutNeedless(line: readonly Point[], tolerance: number): Point[] {
  const keeps = new Uint8Array(line.length);
  keeps[0] = keeps[line.length - 1] = 1;
  const open: [first: number, last: number][] = [[0, line.length - 1]];
  for (let piece = open.pop(); piece; piece = open.pop()) {
    const [first, last] = piece;
    const { at, away } = farthest(line, first, last);
    if (away <= tolerance) continue;
    keeps[at] = 1;
    open.push([first, at], [at, last]);
  }
  return line.filter((_, at) => keeps[at]);
}

function farthest(line: readonly Point[], first: number, last: number): { at: number; away: number } {
  let [at, away] = [first, 0];
  for (let between = first + 1; between < last; ++between) {
    const here = distanceTo(line[between], line[first], line[last]);
    if (here > away) [at, away] = [between, here];
  }
  return { at, away };
}

/** Distance from a point to the line through two others, or to the point where they coincide. */
function distanceTo([x, y]: Point, [fromX, fromY]: Point, [toX, toY]: Point): number {
  const [alongX, alongY] = [toX - fromX, toY - fromY];
  const length = Math.hypot(alongX, alongY);
  if (length === 0) return Math.hypot(x - fromX, y - fromY);
  return Math.abs(alongX * (y - fromY) - alongY * (x - fromX)) / length;
}
