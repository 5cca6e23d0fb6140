import { Vector3 } from 'three';
import type { Color } from '../renderer/gpu/ramps.ts';
import type { SurfaceDescription } from '../renderer/passes/surface.ts';
import { exp } from '../simulator/exact/power.ts';
import { slerp } from '../simulator/exact/quaternion.ts';
import { sin } from '../simulator/exact/sine.ts';
import { quaternionFromAngles } from '../simulator/exact/rotation.ts';
import type { RigidDescription } from '../simulator/rigid.ts';
import { emitterRig } from './emitterRig.ts';
import { genie as genieModel, HEAD, HEAD_RADIUS, HIP, SHOULDER, WAVE } from './models/genie.ts';
import { lampModel, type LampRole } from './models/lamp.ts';
import { placed, placement } from './models/place.ts';
import { tableMesh } from './models/table.ts';
import type { Guide, Handle, SceneState, MovingPart, Scene, Vector } from './scene.ts';

const GENIE = 0;
const HAND = 0;
/** Position of the lamp. */
const LAMP: Vector = [-0.55, 0, 0];
const RUG = 1.9;

const LAMP_COLORS: Record<LampRole, Color> = {
  metal: [246, 196, 74],
  fitting: [214, 136, 52],
  gem: [219, 64, 92],
};
const GROWS_FROM: Record<string, string> = { curl: 'handle', spout: 'belly' };

/** The movable rigid: the centre of the chest. */
const HANDLE: Handle = {
  rigid: GENIE,
  radius: 0.9,
  start: [-0.2, 2.05, 0],
  min: [-1.3, 1.75, -0.5],
  max: [0.9, 2.5, 0.6],
  steers: [0, 1, 2],
};

/** A genie rises from the lamp. His chest and tail are smoke, and the user steers him. */
export function genie(): Scene {
  const { spout } = lampModel();
  const mouth = spout.position.map((at, axis) => at + LAMP[axis]) as unknown as Vector;
  return {
    name: 'genie',
    rig: { ...RIG, ...tail(mouth, spout.direction, spout.radius) },
    rigids: [GENIE_RIGID],
    rigidNames: ['Genie'],
    guide: float,
    surfaces: [...lamp(), ...rug(), ...genieModel(GENIE, HAND)],
    parts: PARTS,
    handle: HANDLE,
    ground: [
      { shape: { type: 'cylinder', halfHeight: 0.3, radius: RUG }, position: [0, -0.3, 0] },
      { shape: { type: 'ball', radius: 0.36 }, position: [LAMP[0], 0.2, LAMP[2]] },
    ],
    camera: { target: [0, 1.8, 0], azimuth: 0.1, elevation: 0.1, distance: 7.4, fieldOfView: 0.58 },
    portrait: { target: [-0.05, 1.6, 0], distance: 7.6, minWidth: 0.4 },
    cameraMove: (seconds) => ({ azimuth: 0.18 * sin(seconds / 5), elevation: 0.05 * sin(seconds / 3.3) }),
    backdrop: { top: [58, 38, 92], bottom: [240, 140, 112] },
  };
}

/** Only the head is a collider: the rest of him is smoke. */
const GENIE_RIGID: RigidDescription = {
  kind: 'kinematic',
  shape: { type: 'compound', parts: [{ shape: { type: 'ball', radius: HEAD_RADIUS + 0.06 }, position: [...HEAD] }] },
  position: [...HANDLE.start],
  friction: 0.1,
};

const PARTS: readonly MovingPart[] = [
  { name: 'Hand', rigid: GENIE, pose: (seconds) => placement(WAVE, [0, -0.2, -0.35 + 0.4 * sin(5.2 * seconds)]) },
];

/** Approach rate to the target position, 1/s, and the maximum speed, m/s. */
const EAGERNESS = 2.2;
const TOP_SPEED = 2.4;
/** Lean per m/s of target velocity, rad. */
const LEAN = 0.22;

/** Floats to the steered position and leans into the movement. */
export const float: Guide = (moment) => {
  const { position, rotation } = moment.pose(GENIE);
  const goal = goalOf(moment);
  const pull = new Vector3(...goal)
    .sub(new Vector3(...position))
    .multiplyScalar(EAGERNESS)
    .clampLength(0, TOP_SPEED);
  const [x, y, z] = new Vector3(...position).addScaledVector(pull, moment.dt);
  const nod = 0.07 * sin(1.7 * moment.seconds);
  const lean = quaternionFromAngles([nod + LEAN * pull.z, 0.12 * sin(0.6 * moment.seconds), -LEAN * pull.x]);
  return [{ rigid: GENIE, position: [x, y, z], rotation: slerp(rotation, lean, 1 - exp(-5 * moment.dt)) }];
};

/** The steered position, plus a swaying motion. */
function goalOf({ seconds, control }: SceneState): Vector {
  const [x, y, z] = HANDLE.steers!.map((channel, axis) => {
    const [start, end] = [HANDLE.start[axis], control(channel) < 0 ? HANDLE.min[axis] : HANDLE.max[axis]];
    return start + (end - start) * Math.abs(control(channel));
  });
  return [x + 0.16 * sin(0.8 * seconds), y + 0.09 * sin(1.3 * seconds), z];
}

function lamp(): SurfaceDescription[] {
  return lampModel().parts.map(({ name, role, mesh }) => ({
    name,
    mesh: placed(mesh, { at: LAMP }),
    color: LAMP_COLORS[role],
    casts: true,
    inked: true,
    group: GROWS_FROM[name] ?? name,
  }));
}

/** A round rug with a border. */
function rug(): SurfaceDescription[] {
  const disc = (radius: number, top: number) => placed(tableMesh(radius, 0.05), { at: [0, top, 0] });
  const look = { casts: false, inked: true };
  return [
    { name: 'fringe', mesh: disc(RUG, -0.06), color: [246, 190, 92], ...look },
    { name: 'border', mesh: disc(RUG - 0.12, -0.03), color: [70, 74, 148], ...look },
    { name: 'rug', mesh: disc(RUG - 0.42, 0), color: [206, 74, 104], ...look },
  ];
}

/** Smoke leaves the spout and is attracted to the genie's waist, wherever that is: his tail. */
function tail(mouth: Vector, direction: Vector, radius: number): Record<string, number> {
  return {
    ...emitter(0, { shape: 1, speed: 1.1, speedVariation: 0.15, spread: 0.12, radius: 0.5 * radius }),
    ...vector('emitters.0.position', mouth),
    ...vector('emitters.0.direction', direction),
    'emitters.0.size': 0.13,
    'emitters.0.sizeVariation': 0.25,
    'emitters.0.lifetime': 1.15,
    'emitters.0.lifetimeVariation': 0.1,
    'emitters.0.share': 1.5,
    'attractors.0.rigid': GENIE,
    'attractors.0.acceleration': 5.5,
    'attractors.0.coreRadius': 0.3,
    'attractors.0.reach': 6,
    ...vector('attractors.0.position', WAIST),
    // Limits the attraction to the space below the chest.
    'attractors.0.region.shape': 2,
    ...vector('attractors.0.region.position', [0, -2.4, 0]),
    ...vector('attractors.0.region.size', [4, 2, 4]),
    'attractors.0.region.softness': 0.15,
  };
}

const WAIST: Vector = [0, -0.5, 0];

const RIG: Readonly<Record<string, number>> = {
  'buoyancy.acceleration': 0,
  'gravity.acceleration': 0,
  'drag.rate': 3.4,
  // The tail widens as it rises.
  'emission.entrainment': 0.12,
  ...body(1, { shape: 2, radius: 0.3, size: 0.4, share: 1.6, at: [0, 0, 0] }),
  ...body(2, { shape: 2, radius: 0.16, size: 0.34, share: 0.8, at: [0, -0.38, 0] }),
  ...body(3, { shape: 7, size: 0.24, share: 0.7, ...line(mirrored(SHOULDER), SHOULDER) }),
  // One arm akimbo, the other one raised.
  ...body(4, { shape: 7, size: 0.18, share: 0.5, ...line(mirrored(SHOULDER), [-0.86, -0.16, 0.12]) }),
  ...body(5, { shape: 7, size: 0.17, share: 0.4, ...line([-0.86, -0.16, 0.12], HIP) }),
  ...body(6, { shape: 7, size: 0.18, share: 0.5, ...line(SHOULDER, [0.92, 0.12, 0.1]) }),
  ...body(7, { shape: 7, size: 0.17, share: 0.4, ...line([0.92, 0.12, 0.1], WAVE) }),
};

interface Limb {
  shape: number;
  size: number;
  share: number;
  at: Vector;
  extent?: Vector;
  radius?: number;
}

/** A part of the body: puffs with a short lifetime that move with the rigid. */
function body(index: number, { at, extent, ...values }: Limb): Record<string, number> {
  return {
    ...emitter(index, { ...values, rigid: GENIE, inherit: 1, speed: 0, sizeVariation: 0.2 }),
    [`emitters.${index}.lifetime`]: 0.5,
    ...vector(`emitters.${index}.position`, at),
    ...(extent && vector(`emitters.${index}.extent`, extent)),
  };
}

function emitter(index: number, values: Record<string, number>): Record<string, number> {
  return emitterRig(index, { temperature: 0, ...values });
}

function line(from: Vector, to: Vector): { at: Vector; extent: Vector } {
  const at = from.map((start, axis) => (start + to[axis]) / 2) as unknown as Vector;
  const extent = from.map((start, axis) => (to[axis] - start) / 2) as unknown as Vector;
  return { at, extent };
}

function mirrored([x, y, z]: Vector): Vector {
  return [-x, y, z];
}

function vector(key: string, [x, y, z]: Vector): Record<string, number> {
  return { [`${key}.x`]: x, [`${key}.y`]: y, [`${key}.z`]: z };
}
