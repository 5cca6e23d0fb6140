/** How much dust rises where objects touch the sand: more for harder impacts and faster rolling. */
import { pow } from '../simulator/exact/power.ts';
import type { Quaternion } from '../simulator/exact/rotation.ts';
import { hypot } from '../simulator/exact/sine.ts';
import type { MovingSceneState, Placement, Rule, Vector } from './scene.ts';

/** An object that falls on the sand. */
export interface Toy {
  readonly rigid: number;
  /** Radius of a ball, or half of a crate's side; metres. */
  readonly size: number;
  readonly isCrate: boolean;
}

/** The emission of one emitter in the next step. */
export interface Cloud {
  puffs: number;
  at: Vector;
  /** m/s. */
  speed: number;
  radius: number;
}

/** Puffs of an impact at 1 m/s, and the exponent of the speed. */
export const BY_HIT = 0.8;
export const POWER = 1.5;
/** Maximum puffs per impact. */
export const MAX_PUFFS = 20;
/** Puffs per step when rolling at 1 m/s, and the minimum rolling speed, m/s. */
const BY_ROLLING = 0.1;
const SLOWEST = 0.35;
/** Distance to the sand that counts as contact, metres. */
const TOUCH = 0.02;
const GRAVITY = 9.81;
/** Total emission rate of all emitters, puffs per second. Each emitter has a share. Equal to the preset's rate. */
export const DUST_RATE = 5000;

/**
 * Dust that a toy raises in the next step.
 * @param radius of the sand about the origin
 */
export function cloudOf(toy: Toy, { pose, before, dt }: MovingSceneState, radius: number): Cloud {
  const [now, then] = [pose(toy.rigid), before(toy.rigid)];
  const [x, , z] = now.position;
  const low = lowest(toy, now);
  // Includes the acceleration of the next step, in which the impact happens.
  const falls = (lowest(toy, then) - low) / dt + GRAVITY * dt;
  const rolls = hypot(x - then.position[0], z - then.position[2]) / dt;
  const isOver = hypot(x, z) < radius;
  const hits = isOver && low > TOUCH && low - falls * dt <= TOUCH;
  const isLow = isOver && Math.abs(low) <= TOUCH;
  const puffs = hits ? hitPuffs(falls) : isLow ? BY_ROLLING * Math.max(0, rolls - SLOWEST) : 0;
  return { puffs, at: [x, 0.06, z], speed: hits ? falls : 0.4 * rolls, radius: (hits ? 0.7 : 0.3) * toy.size };
}

/** Puffs of an impact at this speed, m/s. */
export function hitPuffs(speed: number): number {
  return Math.min(BY_HIT * pow(speed, POWER), MAX_PUFFS);
}

/**
 * Assigns the clouds to the emitters in order. The emitter after the last one never emits and takes the remaining
 * share.
 * @param count of clouds
 */
export function dustRule(count: number, clouds: (moment: MovingSceneState) => readonly Cloud[]): Rule {
  const numbers = Array.from({ length: count }, (_, emitter) => emitter);
  return {
    keys: [...numbers.flatMap(emitterKeys), `emitters.${count}.share`],
    values: (moment) => {
      const all = clouds(moment);
      const shares = all.map(({ puffs }) => puffs / (DUST_RATE * moment.dt));
      const rest = Math.max(0, 1 - shares.reduce((sum, share) => sum + share, 0));
      const values = all.flatMap((cloud, emitter) => emitterValues(emitter, cloud, shares[emitter]));
      return Object.fromEntries([...values, [`emitters.${count}.share`, rest]]);
    },
  };
}

const KEYS = ['share', 'position.x', 'position.y', 'position.z', 'speed', 'size', 'radius'];

function emitterKeys(emitter: number): string[] {
  return KEYS.map((key) => `emitters.${emitter}.${key}`);
}

/** An emitter without a share keeps its position. */
function emitterValues(emitter: number, { at, speed, radius }: Cloud, share: number): [string, number][] {
  const values = [share, ...at, Math.min(0.3 + 0.32 * speed, 3), Math.min(0.17 + 0.03 * speed, 0.38), radius];
  const keys = emitterKeys(emitter);
  return (share > 0 ? values : [0]).map((value, index) => [keys[index], value]);
}

/** Height of the lowest point. */
function lowest({ size, isCrate }: Toy, { position: [, y], rotation }: Placement): number {
  return y - size * (isCrate ? upShares(rotation) : 1);
}

/** Distance of a rotated cube's lowest corner below its centre, in half sides. */
function upShares([x, y, z, w]: Quaternion): number {
  return Math.abs(2 * (x * y + z * w)) + Math.abs(1 - 2 * (x * x + z * z)) + Math.abs(2 * (y * z - x * w));
}
