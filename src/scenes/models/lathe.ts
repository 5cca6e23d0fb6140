/** Surfaces of revolution about a vertical axis, defined by a few outline points. */
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { Vector } from '../scene.ts';
import { planarAxis, revolve, spatialAxis, uprightAxis, type Axis, type Stretch, spline } from './revolve.ts';

/** Points [radius, height] of a smooth curve. */
export type Outline = readonly (readonly [radius: number, height: number])[];

/** Triangle bands between two points of a curved outline. */
const BANDS = 4;

/**
 * The closed mesh of an outline, from the lowest point on the axis to the highest, along the outside.
 * @param outlines smooth curves, with a crease where one ends and the next begins
 */
export function lathe(segments: number, ...outlines: readonly Outline[]): TriangleMesh {
  return revolve({ axis: uprightAxis, segments, profile: outlines.map(stretch) });
}

/**
 * A bent pipe in the plane z = 0.
 * @param path points [x, y] of its centre line
 * @param outlines [radius, fraction of the path], as for `lathe`
 */
export function pipe(
  segments: number,
  path: readonly (readonly [number, number])[],
  ...outlines: readonly Outline[]
): TriangleMesh {
  return along(planarAxis(spline(path)), segments, path.length, outlines);
}

/**
 * A pipe that is bent in space.
 * @param path points of its centre line
 * @param up a unit vector that the centre line is never parallel to
 * @param outlines [radius, fraction of the path], as for `lathe`
 */
export function tube(
  segments: number,
  path: readonly Vector[],
  up: Vector,
  ...outlines: readonly Outline[]
): TriangleMesh {
  return along(spatialAxis(spline(path), up), segments, path.length, outlines);
}

function along(axis: Axis, segments: number, points: number, outlines: readonly Outline[]): TriangleMesh {
  const bends = BANDS * (points - 1);
  const profile = outlines.map((outline) => {
    const { curve, bands } = stretch(outline);
    return { curve, bands: Math.max(bands, Math.ceil(bends * Math.abs(outline.at(-1)![1] - outline[0][1]))) };
  });
  return revolve({ axis, segments, profile });
}

function stretch(outline: Outline): Stretch {
  return { curve: spline(outline), bands: outline.length === 2 ? 1 : BANDS * (outline.length - 1) };
}
