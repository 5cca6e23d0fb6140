/**
 * Closed meshes by turning a profile about an axis that may itself be curved: lathe work, tubes, spouts, handles.
 *
 * A profile is a chain of smooth curves of [radius, along]. The first starts and the last ends on the axis, so that the
 * surface is closed; each begins where the one before ended, with a crease between them. A profile starts at the lower
 * end of its axis, runs along its outside and ends at the upper end, which winds all faces anticlockwise from outside.
 */
import type { TriangleMesh } from '../../passes/extrusion.ts';
import { cos, hypot, sin } from '../../sim/exact/sine.ts';
import { cross } from '../../sim/exact/rotation.ts';
import type { Curve } from './spline.ts';

type Vector = readonly [x: number, y: number, z: number];

/** A place on an axis and the plane across it: two unit vectors, such that tangent x side = across. */
export interface Frame {
  readonly origin: Vector;
  readonly across: Vector;
  readonly side: Vector;
}

/** The frame at a place along an axis; places are in whatever unit the profile uses. */
export type Axis = (along: number) => Frame;

/** One smooth stretch of a profile. */
export interface Stretch {
  readonly curve: Curve;
  /** Bands of triangles along it. */
  readonly bands: number;
}

export interface SurfaceOfRevolution {
  readonly axis: Axis;
  readonly profile: readonly Stretch[];
  /** Triangles round the axis. */
  readonly segments: number;
  /** Factor on the radius at a turn (radians) from `across` towards `side`; 1 when left out. */
  readonly swell?: (angle: number) => number;
}

/** The vertical through the origin; places along it are heights. Turns run from +x towards +z. */
export const uprightAxis: Axis = (along) => ({ origin: [0, along, 0], across: [1, 0, 0], side: [0, 0, 1] });

/** An axis in the plane z = 0 along a curve of [x, y]; places along it are the curve's parameter. */
export function planarAxis(path: Curve): Axis {
  return (along) => {
    const [x, y] = path(along);
    const [tx, ty] = normalized(minus(path(along + STEP), path(along - STEP)));
    return { origin: [x, y, 0], across: [-ty, tx, 0], side: [0, 0, -1] };
  };
}

/** Step for derivatives, as a share of a curve. */
const STEP = 1e-4;

/** The closed mesh of a turning. */
export function revolve(surface: SurfaceOfRevolution): TriangleMesh {
  const { profile, segments } = surface;
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  /** Vertices round the axis, or the one on it. */
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

/** What is at a turn (radians) from `across` towards `side`. */
type ByAngle = (angle: number) => readonly number[];

/** The points of a turning at a share of one of its curves. */
export function circle({ axis, swell }: SurfaceOfRevolution, curve: Curve, parameter: number): ByAngle {
  const [radius, along] = curve(parameter);
  const { origin, across, side } = axis(along);
  return (angle) => {
    const reach = radius * (swell?.(angle) ?? 1);
    const [u, v] = [reach * cos(angle), reach * sin(angle)];
    return origin.map((at, i) => at + u * across[i] + v * side[i]);
  };
}

/** Unit normals from differences along the profile and round the axis, one-sided at a crease. */
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

/** At a pole the normals round it are averaged. */
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

/** At length 1. */
export function normalized(vector: readonly number[]): number[] {
  const length = hypot(...vector);
  return vector.map((part) => part / length);
}
