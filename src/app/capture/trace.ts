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
 * The outlines of all pixels of one number, closed, what is inside on the right hand; holes run the other way round.
 * Where two regions meet, both get the very same points: outlines are cut where three regions meet, and each piece is made
 * simpler by itself, in one direction.
 * @param tolerance how far a simpler line may lie beside the pixels' edges, in pixels
 */
export function traceRegion(labels: Labels, number: number, tolerance: number): Point[][] {
  const seen = new Uint8Array(labels.of.length);
  const outlines: Point[][] = [];
  for (let at = 0; at < labels.of.length; ++at) {
    // Each outline has an edge on top of a pixel, which is walked to the right.
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

/** The number at a place; nothing of the picture lies outside of it. */
function numberAt({ of, width, height }: Labels, x: number, y: number): number {
  return x < 0 || y < 0 || x >= width || y >= height ? OUTSIDE : of[y * width + x];
}

/** Follows an outline from the top left corner of a pixel back to it, and marks the tops that it passes. */
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

/** Keeps the region on the right; where two of its pixels touch by a corner alone, they stay apart. */
function nextHeading(labels: Labels, number: number, x: number, y: number, heading: number): number {
  const isInside = (ahead: number) => {
    const [px, py] = [STEPS[ahead], STEPS[(ahead + 1) % 4]].reduce(([sx, sy], [dx, dy]) => [sx + dx, sy + dy], [0, 0]);
    return numberAt(labels, x + (px - 1) / 2, y + (py - 1) / 2) === number;
  };
  if (!isInside(heading)) return (heading + 1) % 4;
  return isInside((heading + 3) % 4) ? (heading + 3) % 4 : heading;
}

/** Cuts an outline where three regions meet, or the border is reached, and makes each piece simpler. */
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

/** Where a closed outline without joints begins, whichever side it is walked from. */
function lowest(corners: Point[]): number {
  let best = 0;
  corners.forEach(([x, y], at) => {
    const [bestX, bestY] = corners[best];
    if (y < bestY || (y === bestY && x < bestX)) best = at;
  });
  return best;
}
