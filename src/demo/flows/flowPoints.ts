/** The stroke of a flow in the values, and its line in the picture. */
import { MAX_POINTS, MIN_POINTS, readPath, writePath, type PathPoint } from '../../internal.ts';
import type { AnyValues } from '../../preset.ts';

const AXES = ['x', 'y', 'z'] as const;
/** The stroke of a flow without points. */
const INITIAL: readonly PathPoint[] = [
  [0, 0, 0],
  [0, 1, 0],
];
/** Places on the line between two points. */
const PARTS = 8;

/** A flow of the parameter table. */
export interface FlowItem {
  readonly points: readonly PathPoint[];
  readonly isClosed: boolean;
  readonly position: PathPoint;
  readonly scale: number;
  /** Index of its carrier; -1 for none. */
  readonly carrier: number;
}

/** Reads a flow such as `flows.0`. */
export function flowIn(values: AnyValues, item: string): FlowItem {
  const number = (key: string, initial: number) => Number(values[`${item}.${key}`] ?? initial);
  const points = readPath(String(values[`${item}.points`] ?? ''));
  return {
    points: points.length > 0 ? points : INITIAL,
    isClosed: values[`${item}.closed`] === 'ring',
    position: AXES.map((axis) => number(`position.${axis}`, 0)) as unknown as PathPoint,
    scale: number('scale', 1),
    carrier: number('rigid', -1),
  };
}

/** A point in the space of the carrier. */
export function placeOf({ position, scale }: FlowItem, point: PathPoint): PathPoint {
  return point.map((part, axis) => position[axis] + scale * part) as unknown as PathPoint;
}

/** The point at a place in the space of the carrier, within the limits of points. */
export function pointAt({ position, scale }: FlowItem, place: PathPoint): PathPoint {
  const within = (metres: number) => Math.min(Math.max(Math.round(metres * 1000) / 1000, -99.999), 99.999) + 0;
  return place.map((part, axis) => within((part - position[axis]) / scale)) as unknown as PathPoint;
}

/** The points with another one in place of that at an index. */
export function moved(flow: FlowItem, index: number, point: PathPoint): string {
  return writePath(flow.points.map((each, at) => (at === index ? point : each)));
}

/** Without a point; undefined if no fewer are possible. */
export function removed({ points }: FlowItem, index: number): string | undefined {
  return points.length > MIN_POINTS ? writePath(points.filter((_, at) => at !== index)) : undefined;
}

/** With a point on the line after another one, or before the end; undefined if no more are possible. */
export function inserted(flow: FlowItem, index: number): { readonly text: string; readonly at: number } | undefined {
  const { points, isClosed } = flow;
  if (points.length >= MAX_POINTS) return undefined;
  const span = isClosed ? index : Math.min(index, points.length - 2);
  const middle = onSpan(flow, span, 0.5).map((part) => Math.round(part * 1000) / 1000 + 0) as unknown as PathPoint;
  return { text: writePath(points.toSpliced(span + 1, 0, middle)), at: span + 1 };
}

/** Places on the stroke, in the space of the carrier. */
export function lineOf(flow: FlowItem): PathPoint[] {
  const { points, isClosed } = flow;
  const spans = isClosed && points.length > 2 ? points.length : points.length - 1;
  const places = Array.from({ length: spans * PARTS + 1 }, (_, part) => {
    const span = Math.min(Math.floor(part / PARTS), spans - 1);
    return onSpan(flow, span, part / PARTS - span);
  });
  return places.map((point) => placeOf(flow, point));
}

/** A point of the centripetal Catmull-Rom spline, as the simulator has it. */
function onSpan({ points, isClosed }: FlowItem, span: number, share: number): PathPoint {
  const count = points.length;
  const isRing = isClosed && count > 2;
  const at = (index: number) => points[(index + count) % count];
  const [b, c] = [at(span), at(span + 1)];
  const beyond = (end: PathPoint, other: PathPoint) => mix(other, end, 2);
  const a = isRing || span > 0 ? at(span - 1) : beyond(b, c);
  const d = isRing || span + 2 < count ? at(span + 2) : beyond(c, b);
  const knot = (from: PathPoint, to: PathPoint) => Math.sqrt(Math.hypot(...from.map((part, axis) => to[axis] - part)));
  const [, one, two, three] = [0, knot(a, b), knot(b, c), knot(c, d)];
  const [k1, k2, k3] = [one, one + two, one + two + three];
  const t = k1 + share * two;
  const between = (from: PathPoint, to: PathPoint, start: number, end: number) =>
    mix(from, to, end > start ? (t - start) / (end - start) : 0);
  const [ab, bc, cd] = [between(a, b, 0, k1), between(b, c, k1, k2), between(c, d, k2, k3)];
  return between(between(ab, bc, 0, k2), between(bc, cd, k1, k3), k1, k2);
}

function mix(from: PathPoint, to: PathPoint, share: number): PathPoint {
  return from.map((part, axis) => part + share * (to[axis] - part)) as unknown as PathPoint;
}
