import { Quaternion, Vector3, type Matrix4 } from 'three';
import type { Scene } from '../scenes/scene.ts';
import { POSE_FLOATS } from '../sim/layout.ts';

/** Initial rotation of dropped objects, a quaternion: it shows a crate's face from above its edge. */
export const TUMBLED = [0.18, -0.16, 0.24, 0.94] as const;

/**
 * Objects start at least this high, metres; the ground is at a height of about 0. A fixed rigid below CELLAR is not
 * ground: it holds the objects that are not in use.
 */
const MIN_HEIGHT = 0.7;
const CELLAR = -100;
const UNSCALED = new Vector3(1, 1, 1);

/**
 * Objects that the user drops into a scene. Selects the next one and draws it at its start position until the next
 * step.
 */
export class Dropped {
  private readonly rigids: readonly number[];
  /** Lowest start height, metres. */
  private readonly least: number;
  private readonly places = new Map<number, Vector3>();
  private readonly rotation = new Quaternion(...TUMBLED).normalize();

  constructor({ drops = [], rigids }: Scene) {
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

  /** Writes the world transforms of the objects that have a start position and do not fall yet. */
  show(matrices: readonly Matrix4[]): void {
    for (const [rigid, place] of this.places) matrices[rigid].compose(place, this.rotation, UNSCALED);
  }

  /** Forgets the start positions: the objects fall now, or the simulation was reset. */
  clear(): void {
    this.places.clear();
  }
}
