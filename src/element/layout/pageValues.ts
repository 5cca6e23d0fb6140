/** What boxes on the page are for the simulator: obstacles and emitters in the plane that the eye looks at. */
import type { Values } from '../../preset/parameter.ts';
import type { ScenePlane } from '../../stage/sight.ts';
import type { Box } from './nearest.ts';

/** Smoke is born behind and before the plane, too: boxes reach through all of it. Metres. */
const DEPTH = 20;
/** So thick is what smoke is born in along the top of an element, as half a side. Metres. */
const SEAM = 0.02;
/** How strongly smoke curls around the ends of obstacles: circulation for each metre that it reaches, m/s. */
const CURL = 1.2;
/** Dying puffs keep off unevenly: along a smooth box they would line up in one straight edge. */
const ROUGHNESS = 1;
/** As many as the simulator has of each list: a collider for an obstacle, and two vortices for one that smoke curls at. */
export const MAX_FOLLOWED = 8;
const MILLIMETRE = 1000;
const MIN_HALF = 0.001;

type Triple = readonly [x: number, y: number, z: number];

/** A box on the plane, metres. */
export interface PlaneRectangle {
  readonly middle: Triple;
  readonly top: Triple;
  readonly halfWidth: number;
  readonly halfHeight: number;
}

/**
 * @param box on the page
 * @param container of the smoke on the page
 * @param scale CSS pixels of the smoke for one of the page: not 1 where the page is transformed
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
 * Flat values of so many obstacles, from the first on. The simulator turns a box by its upright alone, so its sides do not look
 * at every eye; it reaches through the plane along the side that looks there most, and its cut with the plane is the
 * place, wherever the eye stands.
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

/** How many obstacles smoke can curl at. @param first vortex that is free */
export function maxCurled(first: number): number {
  return Math.max(0, Math.floor((MAX_FOLLOWED - first) / 2));
}

/**
 * Flat values of vortices at both ends of obstacles, which lead smoke out from under them and curl it around their ends:
 * smoke that only bumped would lie under a headline until it is gone.
 * @param first index that is free
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
 * Flat values of so many emitters, each along the top of its place and with its share of the births. Emitters do not turn:
 * where the eye looks slantwise, smoke is born in a strip as wide as the place.
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
      // While none of them smokes nothing is born; a share of nothing would be refused.
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

function underKey(prefix: string, values: Values): Values {
  return Object.fromEntries(Object.entries(values).map(([key, value]) => [`${prefix}.${key}`, value]));
}

/** To the millimetre: what moves by less is not worth a message. */
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
