/**
 * The default puffs of lobes, in the order of variations. Their seeds were chosen by eye from contact sheets
 * (`npm run puffs:sheet`) for a silhouette that reads from every side and light that draws a few crescents inside.
 */
import { proceduralPuff } from './procedural.ts';
import type { PuffShape } from './shapes.ts';

export const LOBE_SHAPES: readonly PuffShape[] = [
  proceduralPuff('cauliflower', 7, { lumpiness: 0.8, flatness: 0.1, roughness: 0.6 }),
  proceduralPuff('drifter', 3, { lumpiness: 0.8, flatness: 0.35, roughness: 0.55 }),
  proceduralPuff('crown', 13, { lumpiness: 0.85, flatness: 0.15, roughness: 0.6 }),
  proceduralPuff('tumble', 14, { lumpiness: 0.85, flatness: 0.15, roughness: 0.6 }),
];
