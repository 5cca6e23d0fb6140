/**
 * Intersects lobe puffs with rays along -z. CPU version of shaders/bodies/lobes.frag, for baking, tools and tests.
 */
import { middleOf } from './normals.ts';
import type { Lobe, PuffShape } from './shapes.ts';
import { minus, type Vector } from './vector.ts';
import { ShapeError } from '../../base/errors.ts';
import { isDrawing } from '../../base/drawingText.ts';
import { MAX_LOBES } from '../../base/constants.ts';

/** Intersection of a ray with a puff, in particle radii. */
export interface LobeHit {
  /** Height above the centre plane: of the surface, or, outside the silhouette, of the nearest lobe's centre. */
  readonly height: number;
  /** Signed distance to the silhouette, negative inside. Inside, the true distance can be larger in magnitude. */
  readonly distance: number;
}

/** Intersects the lobes with the ray at (x, y) of the image plane, in particle radii. */
export function meetLobes(lobes: readonly Lobe[], x: number, y: number): LobeHit {
  let [distance, top, rim] = [Infinity, -Infinity, 0];
  for (const { center, radius } of lobes) {
    const beside = Math.sqrt((x - center[0]) ** 2 + (y - center[1]) ** 2);
    if (beside - radius < distance) {
      distance = beside - radius;
      rim = center[2];
    }
    if (beside < radius) top = Math.max(top, center[2] + Math.sqrt(radius * radius - beside * beside));
  }
  return { height: distance < 0 ? top : rim, distance };
}

/** Radius of the bounding sphere of all lobes about the particle's centre. */
export function reachOf(lobes: readonly Lobe[]): number {
  return Math.max(...lobes.map(({ center, radius }) => Math.hypot(...center) + radius));
}

/** Moves the lobes' centroid to the origin and scales the bounding sphere to radius 1. */
export function inUnitBall(lobes: readonly Lobe[]): Lobe[] {
  const middle = middleOf(lobes);
  const centred = lobes.map(({ center, radius }): Lobe => ({ center: minus(center, middle), radius }));
  const scale = 1 / reachOf(centred);
  // Rounded towards zero to thousandths, because the last bits of sines differ between engines.
  const short = (value: number): number => Math.trunc(value * scale * 999) / 1000;
  return centred.map(({ center, radius }) => ({
    center: center.map(short) as unknown as Vector,
    radius: short(radius),
  }));
}

/** Radius of the disc with the area of the silhouette seen from +z. @param cells sampling grid along each side */
export function silhouetteRadius(lobes: readonly Lobe[], cells = 64): number {
  const reach = reachOf(lobes);
  let covered = 0;
  for (let cell = 0; cell < cells * cells; cell++) {
    const x = reach * (((cell % cells) + 0.5) * (2 / cells) - 1);
    const y = reach * ((Math.floor(cell / cells) + 0.5) * (2 / cells) - 1);
    if (isCovered(lobes, x, y)) covered++;
  }
  return (2 * reach * Math.sqrt(covered / Math.PI)) / cells;
}

function isCovered(lobes: readonly Lobe[], x: number, y: number): boolean {
  for (const { center, radius } of lobes) {
    if ((x - center[0]) ** 2 + (y - center[1]) ** 2 < radius * radius) return true;
  }
  return false;
}

/** Depth of the deepest surface point behind the centre plane that is visible from +z; 0 if there is none. */
export function deepestSeen(lobes: readonly Lobe[], cells = 24): number {
  const reach = reachOf(lobes);
  let deepest = 0;
  for (let cell = 0; cell < cells * cells; cell++) {
    const x = reach * (((cell % cells) + 0.5) * (2 / cells) - 1);
    const y = reach * ((Math.floor(cell / cells) + 0.5) * (2 / cells) - 1);
    const { distance, height } = meetLobes(lobes, x, y);
    if (distance < 0) deepest = Math.max(deepest, -height);
  }
  return deepest;
}

/** Maximum number of variations. */
export const MAX_VARIATIONS = 32;
/** Rounding can move lobes slightly out of the unit ball. */
const LARGEST_REACH = 1.001;

/**
 * Validates puff shapes from the host.
 * @throws ShapeError for an invalid number of shapes or lobes, for lobes outside the unit ball, or for radii not above
 * 0
 */
export function requireShapes(shapes: readonly PuffShape[]): void {
  if (shapes.length < 1 || shapes.length > MAX_VARIATIONS) {
    throw new ShapeError(`Smoke cannot have ${shapes.length} puff shapes: use 1 to ${MAX_VARIATIONS}.`);
  }
  for (const { name, lobes, drawing } of shapes) {
    if (lobes.length < 1 || lobes.length > MAX_LOBES) {
      throw new ShapeError(`The puff ${name} has ${lobes.length} lobes: use 1 to ${MAX_LOBES}.`);
    }
    if (!lobes.every(({ radius }) => radius > 0) || !(reachOf(lobes) <= LARGEST_REACH)) {
      throw new ShapeError(`The puff ${name} must fit into the unit ball, and its lobe radii must be above 0.`);
    }
    if (drawing !== undefined && (!drawing || drawing.includes(';') || !isDrawing(drawing))) {
      throw new ShapeError(`The drawing of the puff ${name} is damaged: make the puff with drawPuff.`);
    }
  }
}
