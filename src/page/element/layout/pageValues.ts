/** Obstacles, vortices and emitters for boxes of the page, in the plane that the camera looks at. */
import { obstacleOf, rounded, sum, underKey, unit, vector, type PlaneRectangle, type Triple } from '../../plane.ts';
import type { Values } from '../../../parameters/parameter.ts';
import type { ScenePlane } from '../../../stage/sight.ts';

/** Half thickness of the strip along an element's top edge in which puffs spawn, in metres. */
const SEAM = 0.02;
/** Circulation per metre of reach of the vortices at the ends of obstacles, in m/s. */
const CURL = 1.2;
/**
 * The simulator's limit for each list. An obstacle needs one collider, and two vortices where smoke curls around it.
 */
export const MAX_FOLLOWED = 8;
/** Flat values of obstacles, starting at index 0. */
export function colliderValues(places: readonly PlaneRectangle[], plane: ScenePlane): Values {
  return Object.assign({}, ...places.map((place, index) => underKey(`colliders.${index}`, obstacleOf(place, plane))));
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

function cross([a, b, c]: Triple, [x, y, z]: Triple): Triple {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}
