import type { Labels } from './labels.ts';
import { simplifyArc, type Point } from './simplify.ts';

const OUTSIDE = -1;

/** Right, down, left, up. */
const STEPS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
] as const;

/**
 * Traces the closed outlines of all pixels with one index. The inside is on the right; holes run in the opposite
 * direction. Adjacent regions share exactly the same points: outlines are split where three regions meet, and each
 * piece is simplified separately, in a canonical direction.
 * @param tolerance maximum distance between the simplified line and the pixel edges, in pixels
 */
export function traceRegion(labels: Labels, number: number, tolerance: number): Point[][] {
  const seen = new Uint8Array(labels.of.length);
  const outlines: Point[][] = [];
  for (let at = 0; at < labels.of.length; ++at) {
    // Each outline contains a top edge of a pixel, which is traversed to the right.
    if (seen[at] || labels.of[at] !== number || above(labels, at) === number) continue;
    const corners = walk(labels, number, at, seen);
    const outline = simplified(corners, labels, tolerance);
    if (outline.length > 2) outlines.push(outline);
  }
  return outlines;
}

function above({ of, width }: Labels, at: number): number | undefined {
  return of[at - width];
}

/** The index at a position; outside the image a value that no pixel has. */
function numberAt({ of, width, height }: Labels, x: number, y: number): number {
  return x < 0 || y < 0 || x >= width || y >= height ? OUTSIDE : of[y * width + x];
}

/** Follows an outline from the top left corner of a pixel back to it, and marks the top edges that it passes. */
function walk(labels: Labels, number: number, first: number, seen: Uint8Array): Point[] {
  const start: Point = [first % labels.width, Math.floor(first / labels.width)];
  const points: Point[] = [];
  let [x, y] = start;
  let heading = 0;
  do {
    points.push([x, y]);
    if (heading === 0) seen[y * labels.width + x] = 1;
    x += STEPS[heading][0];
    y += STEPS[heading][1];
    heading = nextHeading(labels, number, x, y, heading);
  } while (x !== start[0] || y !== start[1] || heading !== 0);
  return points;
}

/** Keeps the region on the right. Two pixels of a region that touch only at a corner stay separate. */
function nextHeading(labels: Labels, number: number, x: number, y: number, heading: number): number {
  const isInside = (ahead: number) => {
    const [px, py] = [STEPS[ahead], STEPS[(ahead + 1) % 4]].reduce(([sx, sy], [dx, dy]) => [sx + dx, sy + dy], [0, 0]);
    return numberAt(labels, x + (px - 1) / 2, y + (py - 1) / 2) === number;
  };
  if (!isInside(heading)) return (heading + 1) % 4;
  return isInside((heading + 3) % 4) ? (heading + 3) % 4 : heading;
}

/** Splits an outline where three regions meet or at the image border, and simplifies each piece. */
function simplified(corners: Point[], labels: Labels, tolerance: number): Point[] {
  const joints = corners.flatMap((corner, at) => (isJoint(labels, corner) ? [at] : []));
  if (joints.length === 0) joints.push(lowest(corners));
  return joints.flatMap((joint, piece) => {
    const end = joints[(piece + 1) % joints.length];
    const arc = between(corners, joint, end);
    return simplifyArc(arc, tolerance).slice(0, -1);
  });
}

function between(corners: Point[], from: number, to: number): Point[] {
  return to > from ? corners.slice(from, to + 1) : [...corners.slice(from), ...corners.slice(0, to + 1)];
}

function isJoint(labels: Labels, [x, y]: Point): boolean {
  const around = [
    numberAt(labels, x - 1, y - 1),
    numberAt(labels, x, y - 1),
    numberAt(labels, x, y),
    numberAt(labels, x - 1, y),
  ];
  const changes = around.filter((number, at) => number !== around[(at + 1) % 4]).length;
  const isCornerOfPicture = around.filter((number) => number === OUTSIDE).length === 3;
  return changes > 2 || isCornerOfPicture;
}

/** Start of a closed outline without joints, independent of its direction. */
function lowest(corners: Point[]): number {
  let best = 0;
  corners.forEach(([x, y], at) => {
    const [bestX, bestY] = corners[best];
    if (y < bestY || (y === bestY && x < bestX)) best = at;
  });
  return best;
}
