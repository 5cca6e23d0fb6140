/**
 * What a puff is: a handful of overlapping spheres (lobes), one dominant mass and lobes of varied sizes around it.
 *
 * The unit frame of a puff: x right, y up, z towards the viewer, the particle's centre at 0, one unit = the
 * particle's radius.
 */

/** A sphere of a puff, in its unit frame. */
export interface Lobe {
  readonly center: readonly [x: number, y: number, z: number];
  readonly radius: number;
}

/** One variation of a puff. The first lobe is its dominant mass. */
export interface PuffShape {
  readonly name: string;
  readonly lobes: readonly Lobe[];
}
