/**
 * A puff is a union of a few overlapping spheres (lobes): one dominant mass and lobes of different sizes around it.
 *
 * The unit space of a puff: x right, y up, z towards the viewer, the particle's centre at the origin, one unit = the
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
 * The shapes for billboards, seen from +z. Lobes behind the centre plane move up to it. The outline does not change,
 * and the relief has no deep steps along it that would interrupt the outline where a puff touches the floor.
 */
export function billboardShapes(shapes: readonly PuffShape[]): readonly PuffShape[] {
  return shapes.map(({ name, lobes }) => ({
    name,
    lobes: lobes.map(({ center: [x, y, z], radius }) => ({ center: [x, y, Math.max(z, 0)], radius })),
  }));
}
