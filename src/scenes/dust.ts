import type { Color } from '../renderer/gpu/ramps.ts';
import { cos, hypot, sin } from '../simulator/exact/sine.ts';
import { quaternionFromAngles } from '../simulator/exact/rotation.ts';
import type { RigidDescription } from '../simulator/rigid.ts';
import { cloudOf, dustRule, type Cloud, type Toy } from './dustRule.ts';
import { emitterRig } from './emitterRig.ts';
import { desert, desertRigids, DESERT_RADIUS } from './models/desert.ts';
import { mole, MOLE_HALF, MOLE_RADIUS } from './models/mole.ts';
import { placement } from './models/place.ts';
import { ballModel, crateModel, jollyBall, jollyCrate } from './models/toys.ts';
import { MOLE_START, moleGuide, moleHeight } from './moleGuide.ts';
import type { Guide, Handle, MovingSceneState, Scene, Vector } from './scene.ts';

const CREAM: Color = [252, 226, 178];

/** The toys, in the order of their rigids and emitters: start position and appearance. */
const TOYS: readonly (Toy & { start: Vector; name: string; colors?: readonly [Color, Color] })[] = [
  { rigid: 0, size: 0.42, isCrate: false, start: [0.7, 1.9, 0.5], name: 'Red ball', colors: [[232, 92, 80], CREAM] },
  { rigid: 1, size: 0.34, isCrate: true, start: [-0.75, 3.1, 0.35], name: 'Crate' },
  { rigid: 2, size: 0.28, isCrate: false, start: [1.3, 4.6, -0.5], name: 'Blue ball', colors: [[70, 172, 176], CREAM] },
  { rigid: 3, size: 0.22, isCrate: false, start: [-1.2, 6.2, -0.4], name: 'Yellow ball', colors: [[250, 186, 72], [226, 100, 90]] },
]; // prettier-ignore
const MOLE = TOYS.length;
const MOLEHILL = 0;

const HANDLE: Handle = {
  rigid: 0,
  radius: TOYS[0].size,
  start: TOYS[0].start,
  min: [-2.6, 0.45, -1.8],
  max: [2.6, 3.4, 2.2],
};

/**
 * Balls and a crate fall on a piece of desert and raise dust in proportion to the impact; a mole kicks them up again.
 */
export function dust(): Scene {
  return {
    name: 'dust',
    rig: RIG,
    rigids: [...TOYS.map(toyRigid), MOLE_RIGID, ...desertRigids()],
    rigidNames: [...TOYS.map(({ name }) => name), 'Mole', 'Sand', 'Cacti', 'Rocks'],
    guide,
    rule: dustRule(MOLE + 1, clouds),
    surfaces: [...desert(), ...mole(MOLE, MOLEHILL), ...TOYS.flatMap(toySurfaces)],
    parts: [{ name: 'Molehill', rigid: MOLE, pose: (seconds) => placement([0, -moleHeight(seconds), 0]) }],
    handle: HANDLE,
    drops: TOYS.map(({ rigid }) => rigid),
    camera: { target: [0, 0.75, 0], azimuth: 0.1, elevation: 0.28, distance: 9.4, fieldOfView: 0.56 },
    portrait: { target: [0, 0.55, 0], elevation: 0.36, distance: 11.5, minWidth: 0.54 },
    cameraMove: (seconds) => ({ azimuth: 0.16 * sin(seconds / 6), elevation: 0.03 * sin(seconds / 4.3) }),
    backdrop: { top: [104, 122, 190], bottom: [255, 196, 148] },
  };
}

function toyRigid({ size, isCrate, start }: (typeof TOYS)[number]): RigidDescription {
  const shape = isCrate
    ? ({ type: 'cuboid', halfExtents: [size, size, size] } as const)
    : ({ type: 'ball', radius: size } as const);
  const rotation = quaternionFromAngles(isCrate ? [0.5, 0.4, 0.3] : [-0.15, 0, 0]);
  return { kind: 'dynamic', shape, position: start, rotation, restitution: isCrate ? 0.25 : 0.75, friction: 0.7 };
}

function toySurfaces({ rigid, size, colors }: (typeof TOYS)[number]): Scene['surfaces'] {
  return colors ? jollyBall(rigid, ballModel(size), ...colors) : jollyCrate(rigid, crateModel(size));
}

const MOLE_RIGID: RigidDescription = {
  kind: 'kinematic',
  shape: { type: 'capsule', halfHeight: MOLE_HALF, radius: MOLE_RADIUS },
  position: [...MOLE_START.position],
  restitution: 0.3,
};

const dig = moleGuide(
  MOLE,
  TOYS.map(({ rigid }) => rigid),
);
/** Toys that fall below ABYSS reappear at height SKY; metres. */
const ABYSS = -6;
const SKY = 5.5;

const guide: Guide = (moment) => {
  const { seconds } = moment;
  const fallen = TOYS.filter(({ rigid }) => moment.pose(rigid).position[1] < ABYSS);
  const above: Vector = [1.3 * sin(7.3 * seconds), SKY, 0.8 * cos(5.1 * seconds)];
  const again = fallen.map(({ rigid }) => ({ rigid, ...placement(above, [2 * seconds, seconds, 0]) }));
  return [...dig(moment), ...again];
};

function clouds(moment: MovingSceneState): Cloud[] {
  return [...TOYS.map((toy) => cloudOf(toy, moment, DESERT_RADIUS)), moleCloud(moment)];
}

/** Dust that the mole raises while it digs, emerges or retreats. */
function moleCloud({ pose, before, dt }: MovingSceneState): Cloud {
  const [now, then] = [pose(MOLE).position, before(MOLE).position];
  const [across, up] = [hypot(now[0] - then[0], now[2] - then[2]) / dt, Math.abs(now[1] - then[1]) / dt];
  return {
    puffs: 0.1 * across + 0.22 * up,
    at: [now[0], 0.1, now[2]],
    speed: 0.4 * (across + up),
    radius: MOLE_RADIUS,
  };
}

const RIG: Readonly<Record<string, number>> = {
  ...Object.assign({}, ...TOYS.map((_, emitter) => dustEmitter(emitter)), dustEmitter(MOLE)),
  // An emitter that never emits takes the remaining share of the emission rate.
  [`emitters.${MOLE + 1}.share`]: 1,
  [`emitters.${MOLE + 1}.envelope.start`]: 3600,
  'buoyancy.acceleration': 0.16,
  'buoyancy.coolingTime': 2,
  'gravity.acceleration': 0.05,
  'drag.rate': 2.6,
};

function dustEmitter(emitter: number): Record<string, number> {
  const values = {
    shape: 1,
    'direction.y': 1,
    spread: 1.35,
    speedVariation: 0.5,
    sizeVariation: 0.4,
    lifetimeVariation: 0.35,
    temperature: 1,
    share: 0,
  };
  return emitterRig(emitter, values);
}
