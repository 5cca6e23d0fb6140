import { atan2, tan } from '../simulator/exact/arc.ts';
import { exp } from '../simulator/exact/power.ts';
import { anglesYZX, multiply } from '../simulator/exact/quaternion.ts';
import { sin } from '../simulator/exact/sine.ts';
import { quaternionFromAngles } from '../simulator/exact/rotation.ts';
import { airplane as airplaneModel, airplaneHull, HALF_SPAN, HUB, KNOT } from './models/airplane.ts';
import { placement } from './models/place.ts';
import type { Guide, Handle, SceneState, MovingPart, Scene, Vector } from './scene.ts';

const PLANE = 0;
/** Speed of the clouds past the airplane, m/s. The airplane stays in place and the air moves. */
export const AIRSPEED = 3.4;
/** Propeller revolutions per second, and the sense of rotation about the nose direction: clockwise for the pilot. */
const REVOLUTIONS_PER_SECOND = 3.2;
export const PROPELLER_SENSE = 1;

const HANDLE: Handle = {
  rigid: PLANE,
  radius: 0.8,
  start: [0, 0.35, 0],
  min: [-1.3, -0.6, -1.1],
  max: [1.3, 1.3, 1.1],
  steers: [0, 1, 2],
};

/** The paper's Fig. 2: an aircraft parts the clouds and leaves a swirl. The user steers it by pointer or keys. */
export function airplane(): Scene {
  return {
    name: 'airplane',
    rig: RIG,
    rigids: [{ kind: 'kinematic', shape: airplaneHull(), position: HANDLE.start, friction: 0.1, boundaryLayer: 0.25 }],
    rigidNames: ['Airplane'],
    guide: fly,
    surfaces: airplaneModel(PLANE),
    parts: PARTS,
    handle: HANDLE,
    camera: { target: [-0.5, 0.15, 0], azimuth: 0.42, elevation: 0.26, distance: 8.2, fieldOfView: 0.6 },
    portrait: { target: [-0.1, 0.3, 0], azimuth: 0.75, distance: 8.6, minWidth: 0.44 },
    cameraMove: (seconds) => ({ azimuth: 0.16 * sin(seconds / 5), elevation: 0.07 * sin(seconds / 3.7) }),
    backdrop: { top: [72, 138, 204], bottom: [232, 214, 232] },
  };
}

const PARTS: readonly MovingPart[] = [
  {
    name: 'Propeller',
    rigid: PLANE,
    pose: (seconds) => placement(HUB, [PROPELLER_SENSE * 2 * Math.PI * REVOLUTIONS_PER_SECOND * seconds, 0, 0]),
  },
  {
    name: 'Scarf',
    rigid: PLANE,
    pose: (seconds) =>
      placement(KNOT, [0.25 * sin(9 * seconds), 0.3 * sin(6.1 * seconds), 0.2 + 0.16 * sin(7.7 * seconds)]),
  },
];

/** Approach rate to the target position, 1/s, and the maximum speed, m/s. */
const EAGERNESS = 1.5;
const TOP_SPEED = 2.2;
/** Tilt rate, 1/s. Four times the approach rate, so that the airplane arrives without overshoot. */
const NIMBLENESS = 6;
/** Roll per m/s of sideways speed, rad. */
const ROLL = 0.4;

/**
 * Flies to the steered position. Climb follows the pitch and sideways movement follows the roll, and both have inertia.
 */
export const fly: Guide = (moment) => {
  const { position, rotation } = moment.pose(PLANE);
  const goal = goalOf(moment);
  const [ahead, climb, aside] = goal.map((place, axis) => wanted(place - position[axis]));
  const ease = 1 - exp(-NIMBLENESS * moment.dt);
  const [roll, , pitch] = anglesYZX(rotation);
  const nextPitch = pitch + ease * (atan2(climb, AIRSPEED) - pitch);
  const nextRoll = roll + ease * (ROLL * aside - roll);
  const sideways = nextRoll / ROLL;
  const heading = -0.5 * atan2(sideways, AIRSPEED);
  const velocity = [ahead, AIRSPEED * tan(nextPitch), sideways];
  const [x, y, z] = position.map((from, axis) => from + moment.dt * velocity[axis]);
  const nextRotation = multiply(quaternionFromAngles([0, heading, 0]), quaternionFromAngles([nextRoll, 0, nextPitch]));
  return [{ rigid: PLANE, position: [x, y, z], rotation: nextRotation }];
};

/** The steered position, plus a bobbing motion through the cloud tops. */
function goalOf({ seconds, control }: SceneState): Vector {
  const [x, y, z] = HANDLE.steers!.map((channel, axis) => {
    const [min, max] = [HANDLE.min[axis], HANDLE.max[axis]];
    return min + ((max - min) / 2) * (1 + control(channel));
  });
  return [x, y - 0.32 * sin(0.9 * seconds), z + 0.3 * sin(0.53 * seconds)];
}

function wanted(way: number): number {
  return Math.min(Math.max(EAGERNESS * way, -TOP_SPEED), TOP_SPEED);
}

/** A sea of clouds with towers moves past. The propeller and the wing tips leave vortices in it. */
const RIG: Readonly<Record<string, number>> = {
  'winds.0.velocity.x': -AIRSPEED,
  // The sea of clouds.
  'emitters.0.shape': 5,
  'emitters.0.position.x': 9,
  'emitters.0.position.y': -1.5,
  'emitters.0.position.z': -0.5,
  'emitters.0.extent.x': 0.3,
  'emitters.0.extent.y': 0.45,
  'emitters.0.extent.z': 3.2,
  'emitters.0.speed': 0,
  'emitters.0.size': 0.68,
  'emitters.0.sizeVariation': 0.4,
  'emitters.0.temperature': 0,
  'emitters.0.share': 0.62,
  // Cloud towers, one after the other, at varying distances.
  'emitters.1.shape': 2,
  'emitters.1.position.x': 9,
  'emitters.1.position.y': -0.1,
  'emitters.1.position.z': -0.1,
  'emitters.1.radius': 0.95,
  'emitters.1.speed': 0,
  'emitters.1.size': 0.42,
  'emitters.1.sizeVariation': 0.45,
  'emitters.1.temperature': 0,
  'emitters.1.share': 1.7,
  'emitters.1.envelope.duration': 0.75,
  'emitters.1.envelope.period': 2.6,
  'emitters.1.envelope.fade': 0.25,
  'emitters.2.shape': 2,
  'emitters.2.position.x': 9,
  'emitters.2.position.y': 0.2,
  'emitters.2.position.z': -2.6,
  'emitters.2.radius': 1.4,
  'emitters.2.speed': 0,
  'emitters.2.size': 0.7,
  'emitters.2.sizeVariation': 0.4,
  'emitters.2.temperature': 0,
  'emitters.2.share': 1.2,
  'emitters.2.envelope.start': 1.1,
  'emitters.2.envelope.duration': 0.9,
  'emitters.2.envelope.period': 3.9,
  'emitters.2.envelope.fade': 0.3,
  // The clouds at the start.
  'emitters.3.shape': 5,
  'emitters.3.position.x': 2,
  'emitters.3.position.y': -1.3,
  'emitters.3.position.z': -0.5,
  'emitters.3.extent.x': 7,
  'emitters.3.extent.y': 0.5,
  'emitters.3.extent.z': 3.2,
  'emitters.3.speed': 0,
  'emitters.3.size': 0.7,
  'emitters.3.sizeVariation': 0.4,
  'emitters.3.temperature': 0,
  'emitters.3.share': 0,
  'emitters.3.burst.count': 160,
  'buoyancy.acceleration': 0,
  'gravity.acceleration': 0,
  'drag.rate': 3,
  // A repelling force parts the air in front of the nose.
  'attractors.0.rigid': PLANE,
  'attractors.0.acceleration': -20,
  'attractors.0.coreRadius': 0.45,
  'attractors.0.reach': 2,
  'attractors.0.position.x': 0.85,
  // The slipstream rotates with the propeller and decays.
  'shedders.0.rigid': PLANE,
  'shedders.0.rate': 30,
  'shedders.0.position.x': HUB[0] - 0.1,
  'shedders.0.position.y': HUB[1],
  'shedders.0.axis.x': PROPELLER_SENSE,
  'shedders.0.axis.z': 0,
  'shedders.0.jitter': 0,
  'shedders.0.strength': 0,
  'shedders.0.perSpeed': 0.5,
  'shedders.0.coreRadius': 0.42,
  'shedders.0.viscosity': 0.06,
  'shedders.0.lifetime': 2.4,
  // Wing-tip vortices: air flows around the tips from below to above.
  'shedders.1.rigid': PLANE,
  'shedders.1.rate': 24,
  'shedders.1.position.x': -0.1,
  'shedders.1.position.y': 0.3,
  'shedders.1.extent.z': HALF_SPAN,
  'shedders.1.axis.x': -1,
  'shedders.1.axis.z': 0,
  'shedders.1.alternate': 1,
  'shedders.1.jitter': 0.1,
  'shedders.1.strength': 0,
  'shedders.1.perSpeed': 0.4,
  'shedders.1.coreRadius': 0.3,
  'shedders.1.viscosity': 0.03,
  'shedders.1.lifetime': 2.6,
};
