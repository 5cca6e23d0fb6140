/** Hand-made puffs for tests of their front side. */
import type { Lobe, PuffShape } from '../../../../src/renderer/puffs/shapes.ts';

function lobe(x: number, y: number, z: number, radius: number): Lobe {
  return { center: [x, y, z], radius };
}

/** Puffs with lobes near the centre plane or in front of it, so that their silhouettes have no deep steps. */
export const FRONTS: readonly PuffShape[] = [
  {
    name: 'cauliflower',
    lobes: [
      lobe(0, 0, -0.04, 0.63),
      lobe(-0.08, 0.5, 0, 0.44),
      lobe(0.5, 0.37, 0.21, 0.31),
      lobe(0.47, -0.23, 0, 0.42),
      lobe(0.02, -0.63, 0.23, 0.28),
      lobe(-0.43, -0.34, 0.05, 0.4),
      lobe(-0.64, 0.14, 0.25, 0.27),
      lobe(-0.11, 0.18, 0.46, 0.35),
      lobe(0.19, -0.15, 0.48, 0.27),
    ],
  },
  {
    name: 'drifter',
    lobes: [
      lobe(0.06, -0.02, -0.02, 0.61),
      lobe(-0.43, 0.04, 0.1, 0.45),
      lobe(-0.06, 0.42, 0, 0.41),
      lobe(0.5, 0.35, 0.18, 0.3),
      lobe(0.51, -0.16, 0.02, 0.41),
      lobe(-0.69, -0.28, 0.12, 0.24),
      lobe(-0.13, -0.47, 0.22, 0.35),
      lobe(0.11, 0.16, 0.43, 0.34),
    ],
  },
  {
    name: 'crown',
    lobes: [
      lobe(0, -0.12, -0.04, 0.68),
      lobe(-0.32, 0.35, 0.06, 0.39),
      lobe(0.25, 0.34, 0, 0.47),
      lobe(0.66, -0.1, 0.21, 0.31),
      lobe(-0.61, -0.21, 0.17, 0.35),
      lobe(-0.1, -0.38, 0.44, 0.34),
      lobe(-0.03, 0.06, 0.44, 0.32),
    ],
  },
  {
    name: 'tumble',
    lobes: [
      lobe(0, 0, -0.04, 0.59),
      lobe(0.33, 0.31, 0.04, 0.48),
      lobe(-0.22, 0.6, 0.21, 0.26),
      lobe(-0.5, 0.25, 0.02, 0.38),
      lobe(-0.59, -0.28, 0.23, 0.25),
      lobe(-0.24, -0.52, 0.04, 0.37),
      lobe(0.34, -0.55, 0.21, 0.26),
      lobe(0.64, -0.13, 0.1, 0.29),
      lobe(-0.16, -0.04, 0.45, 0.34),
    ],
  },
];
