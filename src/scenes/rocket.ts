import { cos, sin } from '../simulator/exact/sine.ts';
import { island } from './models/island.ts';
import { placement } from './models/place.ts';
import { launchPad, NOZZLE, rocket as rocketModel, rocketHull } from './models/rocket.ts';
import type { Placement, Scene } from './scene.ts';

const ROCKET = 0;
/** Height of the pad, metres. */
const PAD = 0.06;
/** Seconds from one launch to the next, to engine start, and to liftoff. */
const PERIOD = 18;
export const IGNITION = 1;
const LIFTOFF = 2;
/**
 * Duration of the climb, seconds, and its acceleration in the first half, m/s2. The second half decelerates equally,
 * and the descent mirrors the climb.
 */
const CLIMB = 6;
const THRUST = 1.1;
const LANDING = PERIOD - 3;
/** The camera follows this fraction of the flight, and its distance doubles at this height, metres. */
const FOLLOWING = 0.47;
const FAR_UP = 8.8;

/** A rocket takes off and lands again. Its exhaust spreads over the ground in a ring. */
export function rocket(): Scene {
  return {
    name: 'rocket',
    rig: RIG,
    rigids: [{ kind: 'kinematic', shape: rocketHull(), ...flight(0), friction: 0.2 }],
    rigidNames: ['Rocket'],
    guide: ({ seconds }) => [{ rigid: ROCKET, ...flight(seconds) }],
    surfaces: [...island(3.2, [232, 196, 138], [180, 124, 100]), ...launchPad(), ...rocketModel(ROCKET)],
    ground: [
      { shape: { type: 'cylinder', halfHeight: 0.3, radius: 3.15 }, position: [0, -0.3, 0] },
      { shape: { type: 'cuboid', halfExtents: [0.26, 1.15, 0.26] }, position: [-1.05, 1.15, -0.3] },
    ],
    camera: { target: [0, 1.3, 0], azimuth: 0.22, elevation: 0.2, distance: 10.6, fieldOfView: 0.6 },
    portrait: { target: [0, 1.5, 0], distance: 12.4, minWidth: 0.53 },
    cameraMove: (seconds) => ({
      target: [0, FOLLOWING * height(seconds), 0],
      azimuth: 0.22 * sin(seconds / 6),
      distance: 1 + height(seconds) / FAR_UP,
    }),
    backdrop: { top: [96, 116, 200], bottom: [255, 196, 180] },
  };
}

/** Height of the rocket above its pad, metres. */
function height(seconds: number): number {
  const since = seconds % PERIOD;
  const away = Math.min(since - LIFTOFF, LANDING - since, CLIMB);
  const gained = (duration: number) => (THRUST / 2) * duration * duration;
  return away < CLIMB / 2 ? gained(Math.max(away, 0)) : 2 * gained(CLIMB / 2) - gained(CLIMB - away);
}

function flight(seconds: number): Placement {
  const up = height(seconds);
  const sway = Math.min(up, 1) * 0.035;
  const shake = seconds % PERIOD > IGNITION && up < 0.5 ? 0.006 * sin(47 * seconds) : 0;
  return placement([shake, PAD + up, 0], [sway * sin(1.7 * seconds), 0.3 * sin(0.35 * up), sway * cos(1.3 * seconds)]);
}

const RIG: Readonly<Record<string, number>> = {
  'emitters.0.shape': 1,
  'emitters.0.rigid': ROCKET,
  'emitters.0.position.y': NOZZLE - 0.02,
  'emitters.0.direction.y': -1,
  'emitters.0.radius': 0.1,
  'emitters.0.speed': 4.2,
  'emitters.0.speedVariation': 0.3,
  'emitters.0.spread': 0.14,
  'emitters.0.inherit': 0.6,
  'emitters.0.size': 0.42,
  'emitters.0.sizeVariation': 0.45,
  'emitters.0.lifetimeVariation': 0.3,
  'emitters.0.temperature': 1.3,
  'emitters.0.share': 1,
  'emitters.0.envelope.start': IGNITION,
  'emitters.0.envelope.duration': LANDING - IGNITION,
  'emitters.0.envelope.period': PERIOD,
  'emitters.0.envelope.fade': 0.3,
  'colliders.0.shape': 0,
  'colliders.0.position.y': 0.16,
  'colliders.0.restitution': 0,
  'colliders.0.friction': 0.05,
  // The ground deflects the exhaust while the rocket is near it: at liftoff and at landing.
  ...blast(0, IGNITION, LIFTOFF + 2.6 - IGNITION),
  ...blast(1, LANDING - 2.6, 2.6),
  'buoyancy.acceleration': 0.25,
  'buoyancy.coolingTime': 0.7,
  'drag.rate': 1.8,
};

function blast(index: number, start: number, duration: number): Record<string, number> {
  const key = `spirals.${index}`;
  return {
    [`${key}.inward`]: -2.6,
    [`${key}.turn`]: 0,
    [`${key}.coreRadius`]: 0.35,
    [`${key}.reach`]: 4.2,
    [`${key}.region.shape`]: 2,
    [`${key}.region.size.x`]: 8,
    [`${key}.region.size.y`]: 0.5,
    [`${key}.region.size.z`]: 8,
    [`${key}.region.softness`]: 0.5,
    [`${key}.envelope.start`]: start,
    [`${key}.envelope.duration`]: duration,
    [`${key}.envelope.period`]: PERIOD,
    [`${key}.envelope.fade`]: 0.5,
  };
}
