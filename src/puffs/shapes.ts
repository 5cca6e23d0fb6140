/**
 * What a puff is: a handful of overlapping spheres (lobes), one dominant mass and lobes of varied sizes around it.
 *
 * The unit space of a puff: x right, y up, z towards the viewer, the particle's centre at 0, one unit = the
 * particle's radius.
 */

/** A sphere of a puff, in its unit space. */
export interface Lobe {
  readonly center: readonly [x: number, y: number, z: number];
  readonly radius: number;
}

/** One variation of a puff. The first lobe is its dominant mass. */
export interface PuffShape {
  readonly name: string;
  readonly lobes: readonly Lobe[];
}

/**
 * The shapes as a billboard shows them from +z: lobes behind the centre plane come up to it. The outline stays, and the
 * relief has no deep steps along it, at which the line that closes on a floor would break.
 */
export function billboardShapes(shapes: readonly PuffShape[]): readonly PuffShape[] {
  return shapes.map(({ name, lobes }) => ({
    name,
    lobes: lobes.map(({ center: [x, y, z], radius }) => ({ center: [x, y, Math.max(z, 0)], radius })),
  }));
}
