/**
 * Closed meshes by turning a profile about an axis that may itself be curved: lathe work, tubes, spouts, handles.
 *
 * A profile is a chain of smooth curves of [radius, along]. The first starts and the last ends on the axis, so that the
 * surface is closed; each begins where the one before ended, with a crease between them. A profile starts at the lower
 * end of its axis, runs along its outside and ends at the upper end, which winds all faces anticlockwise from outside.
 */
import type { TriangleMesh } from '../../passes/extrusion.ts';
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

export interface Turning {
  readonly axis: Axis;
  readonly profile: readonly Stretch[];
  /** Triangles round the axis. */
  readonly segments: number;
  /** Factor on the radius at a turn (radians) from `across` towards `side`; 1 when left out. */
  readonly swell?: (turn: number) => number;
}

/** The vertical through the origin; places along it are heights. Turns run from +x towards +z. */
export const uprightAxis: Axis = (along) => ({ origin: [0, along, 0], across: [1, 0, 0], side: [0, 0, 1] });

/** An axis in the plane z = 0 along a curve of [x, y]; places along it are the curve's parameter. */
export function planarAxis(path: Curve): Axis {
  return (along) => {
    const [x, y] = path(along);
    const [beforeX, beforeY] = path(along - STEP);
    const [afterX, afterY] = path(along + STEP);
    const length = Math.hypot(afterX - beforeX, afterY - beforeY);
    const [tx, ty] = [(afterX - beforeX) / length, (afterY - beforeY) / length];
    return { origin: [x, y, 0], across: [-ty, tx, 0], side: [0, 0, -1] };
  };
}

/** Step for derivatives, as a share of a curve. */
const STEP = 1e-4;

/** The closed mesh of a turning. */
export function revolve(turning: Turning): TriangleMesh {
  const mesh = new Builder();
  const last = turning.profile.length - 1;
  turning.profile.forEach(({ curve, bands }, i) => {
    let previous = mesh.ring(turning, curve, 0, i === 0);
    for (let band = 1; band <= bands; band++) {
      const ring = mesh.ring(turning, curve, band / bands, i === last && band === bands);
      mesh.join(previous, ring, turning.segments);
      previous = ring;
    }
  });
  return mesh.finish();
}

/** Vertices round the axis at one place of a profile, or the one vertex on it. */
interface Ring {
  readonly first: number;
  readonly isPole: boolean;
}

class Builder {
  private readonly positions: number[] = [];
  private readonly normals: number[] = [];
  private readonly indices: number[] = [];

  ring(turning: Turning, curve: Curve, parameter: number, isPole: boolean): Ring {
    const first = this.positions.length / 3;
    const pointAt = circle(turning, curve, parameter);
    const normalAt = isPole ? () => poleNormal(turning, curve, parameter) : normalsOn(turning, curve, parameter);
    for (let segment = 0; segment < (isPole ? 1 : turning.segments); segment++) {
      const turn = (2 * Math.PI * segment) / turning.segments;
      this.positions.push(...pointAt(turn));
      this.normals.push(...normalAt(turn));
    }
    return { first, isPole };
  }

  join(from: Ring, to: Ring, segments: number): void {
    for (let segment = 0; segment < segments; segment++) {
      const next = (segment + 1) % segments;
      const [a, d] = from.isPole ? [from.first, from.first] : [from.first + segment, from.first + next];
      const [b, c] = to.isPole ? [to.first, to.first] : [to.first + segment, to.first + next];
      if (!to.isPole) this.indices.push(a, b, c);
      if (!from.isPole) this.indices.push(a, c, d);
    }
  }

  finish(): TriangleMesh {
    return {
      positions: Float32Array.from(this.positions),
      normals: Float32Array.from(this.normals),
      indices: Uint32Array.from(this.indices),
    };
  }
}

/** What is at a turn (radians) from `across` towards `side`. */
type ByTurn = (turn: number) => Vector;

/** The points of a turning at a share of one of its curves. */
export function circle({ axis, swell }: Turning, curve: Curve, parameter: number): ByTurn {
  const [radius, along] = curve(parameter);
  const { origin, across, side } = axis(along);
  return (turn) => {
    const reach = radius * (swell?.(turn) ?? 1);
    const [u, v] = [reach * Math.cos(turn), reach * Math.sin(turn)];
    return [
      origin[0] + u * across[0] + v * side[0],
      origin[1] + u * across[1] + v * side[1],
      origin[2] + u * across[2] + v * side[2],
    ];
  };
}

/** Unit normals from differences along the profile and round the axis, one-sided at a crease. */
function normalsOn(turning: Turning, curve: Curve, parameter: number): ByTurn {
  const lower = circle(turning, curve, Math.max(0, parameter - STEP));
  const middle = circle(turning, curve, parameter);
  const higher = circle(turning, curve, Math.min(1, parameter + STEP));
  return (turn) => {
    const along = minus(higher(turn), lower(turn));
    const round = minus(middle(turn + STEP), middle(turn - STEP));
    return normalized(cross(along, round));
  };
}

/** At a pole the normals round it are averaged. */
function poleNormal(turning: Turning, curve: Curve, parameter: number): Vector {
  const normalAt = normalsOn(turning, curve, parameter === 0 ? STEP : 1 - STEP);
  const sum: [number, number, number] = [0, 0, 0];
  for (let segment = 0; segment < turning.segments; segment++) {
    const normal = normalAt((2 * Math.PI * segment) / turning.segments);
    normal.forEach((value, axis) => (sum[axis] += value));
  }
  return normalized(sum);
}

function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function normalized(vector: Vector): Vector {
  const length = Math.hypot(vector[0], vector[1], vector[2]);
  return [vector[0] / length, vector[1] / length, vector[2] / length];
}
