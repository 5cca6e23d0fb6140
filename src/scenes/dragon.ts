import { BEAT, BREATH } from '../parameters/byScene/dragon.ts';
import { FIRST_PART } from '../simulator/layout.ts';
import { multiply } from '../simulator/exact/quaternion.ts';
import { quaternionFromAngles, rotate } from '../simulator/exact/rotation.ts';
import { sin } from '../simulator/exact/sine.ts';
import { STEP_SECONDS } from '../simulator/clock.ts';
import { emitterRig } from './emitterRig.ts';
import { dragonBody, gold, PIVOTS } from './models/dragon/dragon.ts';
import { dragonHead, EYES, HINGE, LIPS, NOSTRIL } from './models/dragon/dragonHead.ts';
import { wing } from './models/dragon/dragonWing.ts';
import { island } from './models/island.ts';
import { placement } from './models/place.ts';
import type { MovingPart, Placement, Scene, Vector } from './scene.ts';

const [CHEST, NECK, HEAD, JAW, LIDS, LEFT_WING, RIGHT_WING, TAIL] = [0, 1, 2, 3, 4, 5, 6, 7];
/** The top of the neck, from its foot. */
const NAPE: Vector = [0.26, 0.94, 0];

/** A dragon on a heap of gold. It draws breath and breathes fire once in each beat. */
export function dragon(): Scene {
  return {
    name: 'dragon',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    surfaces: [
      ...island(2.5, [150, 134, 172], [112, 92, 132]),
      ...gold(),
      ...dragonBody({ chest: CHEST, neck: NECK, tail: TAIL }),
      ...wing(1, LEFT_WING),
      ...wing(-1, RIGHT_WING),
      ...dragonHead({ head: HEAD, jaw: JAW, lids: LIDS }),
    ],
    parts: PARTS,
    camera: { target: [1.2, 1.32, 0], azimuth: 0.42, elevation: 0.12, distance: 8.7, fieldOfView: 0.52 },
    portrait: { target: [1.2, 1.5, 0], azimuth: 0.9, elevation: 0.16, distance: 10.4, minWidth: 0.56 },
    lightCentre: [0.6, 1.5, 0],
    backdrop: { top: [92, 152, 206], bottom: [255, 222, 190] },
  };
}

/** 0 before a time, 1 after another; smooth between them. */
function rise(seconds: number, from: number, to: number): number {
  const share = Math.min(Math.max((seconds - from) / (to - from), 0), 1);
  return share * share * (3 - 2 * share);
}

/** How full the lungs are, how far the neck is drawn back, and how open the mouth is at a time; 0 to 1 each. */
function breath(seconds: number): { full: number; back: number; open: number } {
  const length = BEAT * STEP_SECONDS;
  const time = seconds - length * Math.floor(seconds / length);
  const [start, end] = [BREATH.start * STEP_SECONDS, BREATH.end * STEP_SECONDS];
  return {
    full: rise(time, start - 0.95, start - 0.2) * (1 - rise(time, start - 0.05, end - 0.1)),
    back: rise(time, start - 0.9, start - 0.3) * (1 - rise(time, start - 0.28, start + 0.02)),
    open: rise(time, start - 0.2, start) * (1 - rise(time, end, end + 0.35)),
  };
}

/** A pose in the space of another. */
function within(outer: Placement, position: Vector, angles: Vector): Placement {
  const [x, y, z] = rotate(outer.rotation, position);
  return {
    position: [outer.position[0] + x, outer.position[1] + y, outer.position[2] + z],
    rotation: multiply(outer.rotation, quaternionFromAngles(angles)),
  };
}

/** The head sways slowly to both sides and is turned to the front. */
const sway = (seconds: number): number => 0.16 * sin(0.65 * seconds);

function neckPose(seconds: number): Placement {
  const { back, open } = breath(seconds);
  return placement(PIVOTS.neck, [0, -0.1 + 0.4 * sway(seconds), 0.24 * back - 0.26 * open + 0.02 * sin(1.9 * seconds)]);
}

function headPose(seconds: number): Placement {
  const { back, open } = breath(seconds);
  return within(neckPose(seconds), NAPE, [0, -0.16 + sway(seconds), 0.12 * back + 0.2 * open]);
}

function wingPose(pivot: Vector, side: 1 | -1, seconds: number): Placement {
  const { full, open } = breath(seconds);
  const roll = -side * (0.3 * full - 0.28 * open + 0.03 * sin(2.6 * seconds));
  const folded = quaternionFromAngles([0, -2.2 * side, 0]);
  return { position: pivot, rotation: multiply(quaternionFromAngles([roll, 0, 0.1 * full]), folded) };
}

const PARTS: readonly MovingPart[] = [
  {
    name: 'Chest',
    pose: (seconds) => {
      const { full } = breath(seconds);
      return placement([0.1 * full, 0.05 * full, 0], [0, 0, 0.03 * full]);
    },
  },
  { name: 'Neck', pose: neckPose },
  { name: 'Head', pose: headPose },
  {
    name: 'Jaw',
    pose: (seconds) => within(headPose(seconds), HINGE, [0, 0, -0.62 * breath(seconds).open]),
  },
  {
    name: 'Eyelids',
    pose: (seconds) => {
      const { full, open } = breath(seconds);
      return within(headPose(seconds), EYES, [0, 0, 0.5 + 0.2 * full - 0.62 * open]);
    },
  },
  { name: 'Left wing', pose: (seconds) => wingPose(PIVOTS.leftWing, 1, seconds) },
  { name: 'Right wing', pose: (seconds) => wingPose(PIVOTS.rightWing, -1, seconds) },
  { name: 'Tail', pose: (seconds) => placement(PIVOTS.tail, [0, 0.07 * sin(1.3 * seconds), 0]) },
];

/** Fire from the mouth, by bursts of a timeline, and thin smoke from both nostrils. */
const RIG: Readonly<Record<string, number>> = {
  ...emitter(0, LIPS, [1, 0.02, 0], { shape: 1, radius: 0.1, speed: 5, speedVariation: 0.25, spread: 0.15, size: 0.36, share: 0 }), // prettier-ignore
  ...emitter(1, NOSTRIL, [0.85, 0.4, 0.35], { shape: 0, speed: 0.55, spread: 0.1, size: 0.1, temperature: 0.25 }),
  ...emitter(2, [NOSTRIL[0], NOSTRIL[1], -NOSTRIL[2]], [0.85, 0.4, -0.35], { shape: 0, speed: 0.55, spread: 0.1, size: 0.1, temperature: 0.25 }), // prettier-ignore
  'gravity.acceleration': 0.2,
  'buoyancy.acceleration': 1.5,
  'buoyancy.coolingTime': 0.65,
  'drag.rate': 1.7,
};

function emitter(
  index: number,
  [x, y, z]: Vector,
  [i, j, k]: Vector,
  own: Record<string, number>,
): Record<string, number> {
  const all = { rigid: FIRST_PART + HEAD, 'position.x': x, 'position.y': y, 'position.z': z, 'direction.x': i, 'direction.y': j, 'direction.z': k, sizeVariation: 0.3, temperature: 1, ...own }; // prettier-ignore
  return emitterRig(index, all);
}
