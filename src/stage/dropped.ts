import { Quaternion, Vector3, type Matrix4 } from 'three';
import type { Scene } from '../scenes/scene.ts';
import { POSE_FLOATS } from '../sim/rows.ts';

/** How things are turned when they begin to fall: a quaternion that shows a crate's face from above its edge. */
export const TUMBLED = [0.18, -0.16, 0.24, 0.94] as const;

/** The ground of scenes that have one lies at about 0, metres; what is lower than the cellar carries what waits. */
const MIN_HEIGHT = 0.7;
const CELLAR = -100;
const UNSCALED = new Vector3(1, 1, 1);

/** What people drop into a scene: which thing is next, and where it is shown until the coming step lets it fall. */
export class Dropped {
  private readonly rigids: readonly number[];
  /** Nothing begins to fall lower, metres. */
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

  /** The place, or one above the ground where it is meant to fall on one. */
  above(place: Vector3): Vector3 {
    return place.clone().setY(Math.max(place.y, this.least));
  }

  /**
   * The thing that is farthest from a place; undefined where there is none.
   * @param poses of all rigids
   * @param held one that is not free
   */
  next(place: Vector3, poses: Float32Array, held?: number): number | undefined {
    const placeOf = (rigid: number) => this.places.get(rigid) ?? new Vector3().fromArray(poses, POSE_FLOATS * rigid);
    const far = (rigid: number) => placeOf(rigid).distanceTo(place);
    return this.rigids.filter((rigid) => rigid !== held).toSorted((a, b) => far(b) - far(a))[0];
  }

  put(rigid: number, place: Vector3): void {
    this.places.set(rigid, place);
  }

  /** Writes the world transforms of what has been put somewhere and does not fall yet. */
  show(matrices: readonly Matrix4[]): void {
    for (const [rigid, place] of this.places) matrices[rigid].compose(place, this.rotation, UNSCALED);
  }

  /** All of it falls now, or never was. */
  clear(): void {
    this.places.clear();
  }
}
