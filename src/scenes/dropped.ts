import { Vector3 } from 'three';
import type { Quaternion } from '../simulator/exact/rotation.ts';
import { hypot } from '../simulator/exact/sine.ts';
import { POSE_FLOATS } from '../simulator/layout.ts';
import type { RigidDescription } from '../simulator/rigid.ts';

/** It shows a crate's face from above its edge. */
const TUMBLED = [0.18, -0.16, 0.24, 0.94] as const;

/**
 * Objects start at least this high, metres; the ground is at a height of about 0. A fixed rigid below CELLAR is not
 * ground: it holds the objects that are not in use.
 */
const MIN_HEIGHT = 0.7;
const CELLAR = -100;

/**
 * Objects that the user drops into a scene. Selects the next one and keeps its start position until the next step.
 */
export class Dropped {
  /** Initial rotation of dropped objects, a quaternion, and the same of length 1. */
  readonly tumbled = TUMBLED;
  readonly rotation = unit(TUMBLED);
  private readonly rigids: readonly number[];
  /** Lowest start height, metres. */
  private readonly least: number;
  private readonly places = new Map<number, Vector3>();

  /**
   * @param drops indices of the objects
   * @param rigids all rigids of the scene
   */
  constructor(drops: readonly number[], rigids: readonly RigidDescription[]) {
    this.rigids = drops;
    const hasGround = rigids.some(({ kind, position }) => kind === 'fixed' && position[1] > CELLAR);
    this.least = hasGround ? MIN_HEIGHT : -Infinity;
  }

  get count(): number {
    return this.rigids.length;
  }

  /** The position, raised above the ground if the scene has one. */
  above(place: Vector3): Vector3 {
    return place.clone().setY(Math.max(place.y, this.least));
  }

  /**
   * The object farthest from a position; undefined if there is none.
   * @param poses of all rigids
   * @param held a rigid that must not be used
   */
  next(place: Vector3, poses: Float32Array, held?: number): number | undefined {
    const placeOf = (rigid: number) => this.places.get(rigid) ?? new Vector3().fromArray(poses, POSE_FLOATS * rigid);
    const far = (rigid: number) => placeOf(rigid).distanceTo(place);
    return this.rigids.filter((rigid) => rigid !== held).toSorted((a, b) => far(b) - far(a))[0];
  }

  put(rigid: number, place: Vector3): void {
    this.places.set(rigid, place);
  }

  /** The start positions of the objects that do not fall yet. */
  get waiting(): Iterable<readonly [rigid: number, place: Vector3]> {
    return this.places;
  }

  /** Forgets the start positions: the objects fall now, or the simulation was reset. */
  clear(): void {
    this.places.clear();
  }
}

function unit(quaternion: Quaternion): Quaternion {
  const length = hypot(...quaternion);
  const [x, y, z, w] = quaternion.map((component) => component / length);
  return [x, y, z, w];
}
