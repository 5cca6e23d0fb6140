/**
 * Closed meshes made by revolving a profile about an axis that may itself be curved: lathed shapes, tubes, spouts,
 * handles.
 *
 * A profile is a chain of smooth curves of [radius, along]. The first one starts on the axis and the last one ends on
 * it, so that the surface is closed. Each curve starts where the previous one ends, with a crease between them. A
 * profile starts at the lower end of its axis, follows the outside and ends at the upper end, so that all faces are
 * wound anticlockwise seen from outside.
 */
import type { TriangleMesh } from '../../passes/extrusion.ts';
import { cos, hypot, sin } from '../../sim/exact/sine.ts';
import { cross } from '../../sim/exact/rotation.ts';
import type { Curve } from './spline.ts';

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

/** Step for finite differences, as a fraction of a curve. */
const STEP = 1e-4;

/** The closed mesh of a surface of revolution. */
export function revolve(surface: SurfaceOfRevolution): TriangleMesh {
  const { profile, segments } = surface;
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  /** Adds the vertices around the axis, or the single vertex on it. */
  const ring = (curve: Curve, parameter: number, isPole: boolean): ((segment: number) => number) => {
    const first = positions.length / 3;
    const pointAt = circle(surface, curve, parameter);
    const normalAt = isPole ? () => poleNormal(surface, curve, parameter) : normalsOn(surface, curve, parameter);
    const count = isPole ? 1 : segments;
    for (let segment = 0; segment < count; segment++) {
      const angle = (2 * Math.PI * segment) / segments;
      positions.push(...pointAt(angle));
      normals.push(...normalAt(angle));
    }
    return (segment) => first + (segment % count);
  };
  profile.forEach(({ curve, bands }, i) => {
    let from = ring(curve, 0, i === 0);
    for (let band = 1; band <= bands; band++) {
      const to = ring(curve, band / bands, i === profile.length - 1 && band === bands);
      for (let segment = 0; segment < segments; segment++) {
        const [a, b, c, d] = [from(segment), to(segment), to(segment + 1), from(segment + 1)];
        if (b !== c) indices.push(a, b, c);
        if (a !== d) indices.push(a, c, d);
      }
      from = to;
    }
  });
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint32Array.from(indices),
  };
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
