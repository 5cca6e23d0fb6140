/**
 * Closed meshes made by revolving a profile about an axis that may itself be curved: lathed shapes, tubes, spouts,
 * handles.
 *
 * A profile is a chain of smooth curves of [radius, along]. The first one starts on the axis and the last one ends on
 * it, so that the surface is closed. Each curve starts where the previous one ends, with a crease between them. A
 * profile starts at the lower end of its axis, follows the outside and ends at the upper end, so that all faces are
 * wound anticlockwise seen from outside.
 */
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { cos, hypot, sin } from '../../simulator/exact/sine.ts';
import { cross } from '../../simulator/exact/rotation.ts';

type Vector = readonly [x: number, y: number, z: number];

/** A point on an axis and the plane across it: two unit vectors with tangent x side = across. */
export interface Frame {
  readonly origin: Vector;
  readonly across: Vector;
  readonly side: Vector;
}

/** The frame at a position along an axis, in the unit of the profile. */
export type Axis = (along: number) => Frame;

/** A smooth curve of a profile. */
export interface Stretch {
  readonly curve: Curve;
  /** Number of triangle bands along it. */
  readonly bands: number;
}

export interface SurfaceOfRevolution {
  readonly axis: Axis;
  readonly profile: readonly Stretch[];
  /** Number of segments around the axis. */
  readonly segments: number;
  /** Radius factor at an angle (radians) from `across` towards `side`. Default: 1. */
  readonly swell?: (angle: number) => number;
}

/** The vertical axis through the origin; positions along it are heights. Angles run from +x towards +z. */
export const uprightAxis: Axis = (along) => ({ origin: [0, along, 0], across: [1, 0, 0], side: [0, 0, 1] });

/** An axis in the plane z = 0 along a curve of [x, y]; positions along it are curve parameters. */
export function planarAxis(path: Curve): Axis {
  return (along) => {
    const [x, y] = path(along);
    const [tx, ty] = normalized(minus(path(along + STEP), path(along - STEP)));
    return { origin: [x, y, 0], across: [-ty, tx, 0], side: [0, 0, -1] };
  };
}

/**
 * An axis along a curve of [x, y, z]; positions along it are curve parameters.
 * @param up a unit vector that the curve is never parallel to; `across` is as close to it as possible
 */
export function spatialAxis(path: Curve, up: Vector): Axis {
  return (along) => {
    // A smooth profile reaches slightly beyond both ends, where the path does not move.
    const within = Math.min(Math.max(along, STEP), 1 - STEP);
    const [x, y, z] = path(along);
    const tangent = normalized(minus(path(within + STEP), path(within - STEP)));
    const [a, b, c] = normalized(cross(up, tangent));
    return { origin: [x, y, z], across: cross(tangent, [a, b, c]), side: [a, b, c] };
  };
}

/** Step for finite differences, as a fraction of a curve. */
const STEP = 1e-4;

/** The vertices around an axis at one position of a profile, or the single vertex on the axis. */
interface Ring {
  /** Largest distance from the axis. */
  readonly radius: number;
  /** Two points on opposite sides. */
  readonly sides: readonly number[];
  /** Index of the vertex at a segment. */
  readonly vertexAt: (segment: number) => number;
}

/** The closed mesh of a surface of revolution. */
export function revolve(surface: SurfaceOfRevolution): TriangleMesh {
  const { profile, segments, swell = () => 1 } = surface;
  const positions: number[] = [];
  const normals: number[] = [];
  const ring = (curve: Curve, parameter: number, isPole: boolean): Ring => {
    const first = positions.length / 3;
    const pointAt = circle(surface, curve, parameter);
    const normalAt = isPole ? () => poleNormal(surface, curve, parameter) : normalsOn(surface, curve, parameter);
    const count = isPole ? 1 : segments;
    for (let segment = 0; segment < count; segment++) {
      const angle = (2 * Math.PI * segment) / segments;
      positions.push(...pointAt(angle));
      normals.push(...normalAt(angle));
    }
    return {
      radius: curve(parameter)[0] * swell(0),
      sides: [...pointAt(0), ...pointAt(Math.PI)],
      vertexAt: (segment) => first + (segment % count),
    };
  };
  const stretches = profile.map(({ curve, bands }, i) =>
    Array.from({ length: bands + 1 }, (_, band) =>
      ring(curve, band / bands, band === 0 ? i === 0 : i === profile.length - 1 && band === bands),
    ),
  );
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: trianglesBetween(stretches, every(1, segments)),
    coarser: (deviation) =>
      trianglesBetween(
        stretches.map((rings) => {
          const kept = simplifyPolyline(deviation, rings.map(({ sides }) => sides)); // prettier-ignore
          return kept.map((index) => rings[index]);
        }),
        every(strideWithin(deviation, largestRadius(stretches.flat()), segments), segments),
      ),
  };
}

/**
 * Leaves out points of a curve that are at most this far from the straight line between their neighbours. At least one
 * stays between the ends, because a curve from pole to pole needs it.
 * @param points of any dimension
 * @returns the indices of the points that stay
 */
function simplifyPolyline(deviation: number, points: readonly (readonly number[])[]): number[] {
  const last = points.length - 1;
  const kept = [0];
  for (let from = 0; from < last; kept.push(from)) {
    const length = largest(from > 0 ? last - from : last - 1, (bands) => {
      const way = minus(points[from + bands], points[from]);
      return points.slice(from + 1, from + bands).every((point) => {
        const offset = minus(point, points[from]);
        const share = dot(offset, way) / dot(way, way);
        return hypot(...offset.map((along, axis) => along - share * way[axis])) <= deviation;
      });
    });
    from += length;
  }
  return kept;
}

/** The triangles between neighbouring rings of each stretch, at these segments. */
function trianglesBetween(stretches: readonly (readonly Ring[])[], segments: readonly number[]): Uint32Array {
  const indices: number[] = [];
  for (const rings of stretches) {
    rings.slice(1).forEach(({ vertexAt: to }, band) => {
      const { vertexAt: from } = rings[band];
      segments.slice(1).forEach((next, column) => {
        const segment = segments[column];
        const [a, b, c, d] = [from(segment), to(segment), to(next), from(next)];
        if (b !== c) indices.push(a, b, c);
        if (a !== d) indices.push(a, c, d);
      });
    });
  }
  return Uint32Array.from(indices);
}

function largestRadius(rings: readonly Ring[]): number {
  return Math.max(...rings.map(({ radius }) => radius));
}

/** A function of the angle (radians) from `across` towards `side`. */
type ByAngle = (angle: number) => readonly number[];

/** The points around the surface at a parameter of one of its curves. */
export function circle({ axis, swell }: SurfaceOfRevolution, curve: Curve, parameter: number): ByAngle {
  const [radius, along] = curve(parameter);
  const { origin, across, side } = axis(along);
  return (angle) => {
    const reach = radius * (swell?.(angle) ?? 1);
    const [u, v] = [reach * cos(angle), reach * sin(angle)];
    return origin.map((at, i) => at + u * across[i] + v * side[i]);
  };
}

/** Unit normals from finite differences along the profile and around the axis, one-sided at a crease. */
function normalsOn(surface: SurfaceOfRevolution, curve: Curve, parameter: number): ByAngle {
  const lower = circle(surface, curve, Math.max(0, parameter - STEP));
  const middle = circle(surface, curve, parameter);
  const higher = circle(surface, curve, Math.min(1, parameter + STEP));
  return (angle) => {
    const along = minus(higher(angle), lower(angle));
    const round = minus(middle(angle + STEP), middle(angle - STEP));
    return normalized(cross(along, round));
  };
}

/** The average of the normals around a pole. */
function poleNormal(surface: SurfaceOfRevolution, curve: Curve, parameter: number): readonly number[] {
  const normalAt = normalsOn(surface, curve, parameter === 0 ? STEP : 1 - STEP);
  const sum: [number, number, number] = [0, 0, 0];
  for (let segment = 0; segment < surface.segments; segment++) {
    const normal = normalAt((2 * Math.PI * segment) / surface.segments);
    normal.forEach((value, axis) => (sum[axis] += value));
  }
  return normalized(sum);
}

function minus(a: readonly number[], b: readonly number[]): number[] {
  return a.map((part, axis) => part - b[axis]);
}

/** Scaled to length 1. */
export function normalized(vector: readonly number[]): number[] {
  const length = hypot(...vector);
  return vector.map((part) => part / length);
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, along, axis) => sum + along * b[axis], 0);
}

/** A smooth curve for parameters 0 to 1, with the dimension of its control points. */
type Curve = (parameter: number) => number[];

/**
 * A Catmull-Rom spline through control points that are evenly spaced in its parameter. It ends exactly at the first and
 * the last point, so that curves with a common end meet bit-exactly.
 */
export function spline(points: readonly (readonly number[])[]): Curve {
  const last = points.length - 1;
  const before = (i: number): readonly number[] => points[i - 1] ?? mirrored(points[0], points[1]);
  const after = (i: number): readonly number[] => points[i + 1] ?? mirrored(points[last], points[last - 1]);
  return (parameter) => {
    const at = Math.min(1, Math.max(0, parameter)) * last;
    const i = Math.min(last - 1, Math.floor(at));
    const t = at - i;
    if (t === 1) return [...points[i + 1]];
    const [a, b, c, d] = [before(i), points[i], points[i + 1], after(i + 1)];
    return b.map((from, axis) => {
      const slope = (c[axis] - a[axis]) / 2;
      const endSlope = (d[axis] - from) / 2;
      const rise = c[axis] - from;
      return from + t * (slope + t * (3 * rise - 2 * slope - endSlope + t * (slope + endSlope - 2 * rise)));
    });
  };
}

/** A virtual control point beyond an end, the neighbour mirrored about it. */
function mirrored(end: readonly number[], neighbour: readonly number[]): number[] {
  return end.map((value, axis) => 2 * value - neighbour[axis]);
}

/** How much coarser the grid of a mesh can be. Deviations are in metres. */

/** Every n-th number from 0, and the last one. */
export function every(stride: number, last: number): number[] {
  return [...Array.from({ length: Math.ceil(last / stride) }, (_, index) => stride * index), last];
}

/** The largest stride along the segments of a circle whose chords deviate from it by at most this. At least four stay. */
export function strideWithin(deviation: number, radius: number, segments: number): number {
  return largest(segments / 4, (stride) => radius * (1 - cos((Math.PI * stride) / segments)) <= deviation);
}

/** The largest whole number above 1 for which this and all smaller ones hold, up to a limit; else 1. */
function largest(limit: number, holds: (number: number) => boolean): number {
  let number = 1;
  while (number + 1 <= limit && holds(number + 1)) number++;
  return number;
}
