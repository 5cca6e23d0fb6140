/** Converts boxes of the page to obstacles and emitters in the plane that the camera looks at. */
import type { AnyValues, Values } from '../../preset/parameter.ts';
import type { ScenePlane } from '../../stage/sight.ts';
import type { Box } from './nearest.ts';

/**
 * Half depth of obstacles, in metres. Smoke spawns behind and in front of the plane, too, so boxes extend through all
 * of it.
 */
const DEPTH = 20;
/** Half thickness of the strip along an element's top edge in which puffs spawn, in metres. */
const SEAM = 0.02;
/** Circulation per metre of reach of the vortices at the ends of obstacles, in m/s. */
const CURL = 1.2;
/** Roughness of obstacles. Along a perfectly smooth box, dying puffs would form a straight edge. */
const ROUGHNESS = 1;
/**
 * The simulator's limit for each list. An obstacle needs one collider, and two vortices where smoke curls around it.
 */
export const MAX_FOLLOWED = 8;
const MILLIMETRE = 1000;
const MIN_HALF = 0.001;

type Triple = readonly [x: number, y: number, z: number];

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
 * Flat values of obstacles, starting at index 0. The simulator rotates a box about its up axis only, so a box cannot
 * face every camera. The box extends through the plane along its horizontal axis that is closest to the line of sight.
 * Its cross-section with the plane is the rectangle.
 */
export function colliderValues(places: readonly PlaneRectangle[], plane: ScenePlane): Values {
  const axis = unit(plane.up);
  const [x, , z] = unit(plane.right).map(Math.abs);
  return Object.assign(
    {},
    ...places.map(({ middle, halfWidth, halfHeight }, index) =>
      underKey(`colliders.${index}`, {
        shape: 'box',
        ...vector('position', middle),
        ...vector('axis', axis),
        'halfExtents.x': x < z ? DEPTH : halfOf(halfWidth * x),
        'halfExtents.y': halfOf(halfHeight),
        'halfExtents.z': x < z ? halfOf(halfWidth * z) : DEPTH,
        friction: 0,
        roughness: ROUGHNESS,
      }),
    ),
  );
}

function halfOf(metres: number): number {
  return rounded(Math.max(metres, MIN_HALF));
}

/** Maximum number of obstacles with vortices. @param first index of the first free vortex */
export function maxCurled(first: number): number {
  return Math.max(0, Math.floor((MAX_FOLLOWED - first) / 2));
}

/**
 * Flat values of vortices at both ends of obstacles, which move smoke out from under them and curl it around their
 * ends. With collisions alone, smoke would collect under a headline until it fades.
 * @param first index of the first free vortex
 */
export function curlValues(places: readonly PlaneRectangle[], plane: ScenePlane, first: number): Values {
  const axis = cross(unit(plane.right), unit(plane.up));
  const led = places.slice(0, maxCurled(first));
  return Object.assign({}, ...led.flatMap((place, index) => curls(place, plane, axis, first + 2 * index)));
}

function curls(
  { middle, halfWidth, halfHeight }: PlaneRectangle,
  plane: ScenePlane,
  axis: Triple,
  first: number,
): Values[] {
  const [right, up] = [unit(plane.right), unit(plane.up)];
  const reach = 1.1 * Math.max(halfWidth, halfHeight) + 0.2;
  const circulation = CURL * (0.5 + reach);
  return [-1, 1].map((side, index) =>
    underKey(`vortices.${first + index}`, {
      circulation: rounded(side * circulation),
      coreRadius: rounded(Math.max(0.15, 0.8 * halfHeight)),
      reach: rounded(reach),
      ...vector('position', sum(middle, [side * halfWidth, right], [-0.5 * halfHeight, up])),
      ...vector('axis', axis),
    }),
  );
}

/**
 * Flat values of emitters, each along the top edge of its rectangle and with its share of the emission rate. Emitters
 * do not rotate: where the camera looks at an angle, the strip is as wide as the rectangle.
 */
export function emitterValues(
  emitters: readonly { readonly place: PlaneRectangle; readonly isOn: boolean }[],
  plane: ScenePlane,
  rate: number,
): Values {
  if (emitters.length === 0) return {};
  const [x, , z] = unit(plane.right).map(Math.abs);
  const isAnyOn = emitters.some(({ isOn }) => isOn);
  const each = emitters.map(({ place, isOn }, index) =>
    underKey(`emitters.${index}`, {
      shape: 'box',
      ...vector('position', place.top),
      'extent.x': rounded(Math.max(place.halfWidth * x, SEAM)),
      'extent.y': SEAM,
      'extent.z': rounded(Math.max(place.halfWidth * z, SEAM)),
      // When no emitter is on, the rate is 0. Shares that add up to 0 would be rejected.
      share: isOn || !isAnyOn ? 1 : 0,
    }),
  );
  return Object.assign({ 'emission.rate': isAnyOn ? rate : 0 }, ...each);
}

function along({ middle, right, up }: ScenePlane, x: number, y: number): Triple {
  return sum(middle, [x, right], [y, up]);
}

function sum(start: Triple, ...ways: readonly (readonly [length: number, way: Triple])[]): Triple {
  const at = (axis: number) => ways.reduce((total, [length, way]) => total + length * way[axis], start[axis]);
  return [at(0), at(1), at(2)];
}

function cross([a, b, c]: Triple, [x, y, z]: Triple): Triple {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}

function vector(name: string, [x, y, z]: Triple): Record<string, number> {
  return { [`${name}.x`]: rounded(x), [`${name}.y`]: rounded(y), [`${name}.z`]: rounded(z) };
}

function underKey(prefix: string, values: AnyValues): Values {
  return Object.fromEntries(Object.entries(values).map(([key, value]) => [`${prefix}.${key}`, value]));
}

/** Rounds to millimetres, so that smaller movements send no message. */
function rounded(metres: number): number {
  return Math.round(metres * MILLIMETRE) / MILLIMETRE + 0;
}

function unit(given: Triple): Triple {
  const length = lengthOf(given);
  return [given[0] / length, given[1] / length, given[2] / length];
}

function lengthOf(given: Triple): number {
  return Math.hypot(...given);
}
