/**
 * The puff shapes, each a handful of overlapping spheres (lobes) drawn by hand: one dominant mass, lobes of varied
 * sizes around it for a scalloped silhouette, and lobes towards the viewer so that two-tone light draws crescents
 * inside the puff.
 *
 * The unit frame of a puff: x right, y up, z towards the viewer, the particle's centre at 0, one unit = the
 * particle's radius. The silhouette fits in [-1, 1]^2 and has the area of a disc of radius 0.85.
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

function lobe(x: number, y: number, z: number, radius: number): Lobe {
  return { center: [x, y, z], radius };
}

/** The variations in layer order: a particle's variation selects one, modulo their number. */
export const PUFF_SHAPES: readonly PuffShape[] = [
  {
    name: 'cauliflower',
    lobes: [
      lobe(-0.05, 0.05, 0.0, 0.64),
      lobe(0.45, 0.3, 0.05, 0.42),
      lobe(-0.5, 0.35, 0.0, 0.38),
      lobe(-0.02, 0.62, 0.05, 0.34),
      lobe(-0.58, -0.22, 0.05, 0.32),
      lobe(0.45, -0.35, 0.0, 0.4),
      lobe(-0.1, -0.5, 0.1, 0.36),
      lobe(0.12, 0.12, 0.42, 0.36),
    ],
  },
  {
    name: 'drifter',
    lobes: [
      lobe(0.2, 0.0, 0.0, 0.6),
      lobe(-0.42, 0.12, 0.05, 0.44),
      lobe(0.05, 0.5, 0.0, 0.36),
      lobe(0.62, 0.32, 0.0, 0.28),
      lobe(0.6, -0.25, 0.1, 0.34),
      lobe(-0.68, -0.22, 0.0, 0.28),
      lobe(-0.1, -0.4, 0.15, 0.36),
    ],
  },
  {
    name: 'crown',
    lobes: [
      lobe(0.0, -0.15, 0.0, 0.62),
      lobe(-0.36, 0.42, 0.0, 0.38),
      lobe(0.3, 0.48, 0.1, 0.42),
      lobe(0.64, 0.02, 0.0, 0.3),
      lobe(-0.62, -0.1, 0.1, 0.34),
      lobe(-0.2, -0.1, 0.45, 0.34),
    ],
  },
  {
    name: 'tumble',
    lobes: [
      lobe(-0.12, -0.12, 0.0, 0.62),
      lobe(0.44, 0.3, 0.0, 0.46),
      lobe(-0.4, 0.46, 0.05, 0.34),
      lobe(0.08, 0.66, 0.0, 0.26),
      lobe(0.52, -0.28, 0.1, 0.36),
      lobe(-0.66, -0.05, 0.0, 0.26),
      lobe(-0.42, -0.54, 0.05, 0.3),
      lobe(0.12, -0.62, 0.0, 0.3),
      lobe(0.2, -0.05, 0.42, 0.34),
    ],
  },
];
