/** Boxes of the page in the plane that the camera looks at. */
import type { AnyValues, Values } from '../parameters/parameter.ts';
import type { ScenePlane } from '../stage/sight.ts';

/**
 * Half depth of obstacles, in metres. Smoke spawns behind and in front of the plane, too, so boxes extend through all
 * of it.
 */
const DEPTH = 20;
/** Roughness of obstacles. Along a perfectly smooth box, dying puffs would form a straight edge. */
const ROUGHNESS = 1;
const MILLIMETRE = 1000;
const MIN_HALF = 0.001;

export type Triple = readonly [x: number, y: number, z: number];

/** A box in client pixels; a point has no size. */
export type Box = Pick<DOMRect, 'left' | 'top' | 'width' | 'height'>;

/** A rectangle on the plane, in metres. */
export interface PlaneRectangle {
  readonly middle: Triple;
  readonly top: Triple;
  readonly halfWidth: number;
  readonly halfHeight: number;
}

/**
 * @param box on the page
 * @param container of the smoke on the page
 * @param scale CSS pixels of the smoke per CSS pixel of the page; not 1 where the page is transformed
 */
export function placeOnPlane(box: Box, container: Box, scale: number, plane: ScenePlane): PlaneRectangle {
  const x = (box.left + box.width / 2 - container.left - container.width / 2) * scale;
  const y = (container.top + container.height / 2 - box.top - box.height / 2) * scale;
  const up = (box.height / 2) * scale;
  return {
    middle: along(plane, x, y),
    top: along(plane, x, y + up),
    halfWidth: ((box.width * scale) / 2) * lengthOf(plane.right),
    halfHeight: up * lengthOf(plane.up),
  };
}

/**
 * Values of an obstacle. The simulator rotates a box about its up axis only, so a box cannot face every camera. It extends
 * through the plane along its horizontal axis that is closest to the line of sight. Its cross-section with the plane is
 * the rectangle.
 */
export function obstacleOf({ middle, halfWidth, halfHeight }: PlaneRectangle, plane: ScenePlane): AnyValues {
  const [x, , z] = unit(plane.right).map(Math.abs);
  return {
    shape: 'box',
    ...vector('position', middle),
    ...vector('axis', unit(plane.up)),
    'halfExtents.x': x < z ? DEPTH : halfOf(halfWidth * x),
    'halfExtents.y': halfOf(halfHeight),
    'halfExtents.z': x < z ? halfOf(halfWidth * z) : DEPTH,
    friction: 0,
    roughness: ROUGHNESS,
  };
}

function halfOf(metres: number): number {
  return rounded(Math.max(metres, MIN_HALF));
}

function along({ middle, right, up }: ScenePlane, x: number, y: number): Triple {
  return sum(middle, [x, right], [y, up]);
}

export function sum(start: Triple, ...ways: readonly (readonly [length: number, way: Triple])[]): Triple {
  const at = (axis: number) => ways.reduce((total, [length, way]) => total + length * way[axis], start[axis]);
  return [at(0), at(1), at(2)];
}

export function vector(name: string, [x, y, z]: Triple): Record<string, number> {
  return { [`${name}.x`]: rounded(x), [`${name}.y`]: rounded(y), [`${name}.z`]: rounded(z) };
}

export function underKey(prefix: string, values: AnyValues): Values {
  return Object.fromEntries(Object.entries(values).map(([key, value]) => [`${prefix}.${key}`, value]));
}

/** Rounds to millimetres, so that smaller movements send no message. */
export function rounded(metres: number): number {
  return Math.round(metres * MILLIMETRE) / MILLIMETRE + 0;
}

export function unit(given: Triple): Triple {
  const length = lengthOf(given);
  return [given[0] / length, given[1] / length, given[2] / length];
}

function lengthOf(given: Triple): number {
  return Math.hypot(...given);
}
