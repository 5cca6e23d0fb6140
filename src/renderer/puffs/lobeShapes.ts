/**
 * Variations of lobe puffs from one seed and a few knobs. The seeds of the default variations were selected from
 * contact sheets (`npm run puffs:sheet`) for a clear silhouette from every side and a few crescent-shaped highlights.
 * Other seeds are not curated.
 */
import { proceduralPuff, type PuffKnobs } from './procedural.ts';
import type { PuffShape } from './shapes.ts';

/** Parameters shared by all variations. */
export interface PuffDesign extends PuffKnobs {
  /** Lobes per puff, 5..12. */
  readonly lobes: number;
  /** An integer; 0 selects the curated variations. */
  readonly seed: number;
}

export const DEFAULT_DESIGN: PuffDesign = { lumpiness: 0.8, flatness: 0.2, roughness: 0.6, lobes: 10, seed: 0 };
/** Default number of variations. */
export const DEFAULT_VARIATIONS = 4;

/** Offsets added to the knobs of a variation, used in rotation. Some variations are flatter, some lumpier. */
const LEANS: readonly (Partial<PuffKnobs> & { readonly name: string })[] = [
  { name: 'cauliflower', flatness: -0.1 },
  { name: 'drifter', flatness: 0.15, roughness: -0.05 },
  { name: 'crown', lumpiness: 0.05, flatness: -0.05 },
  { name: 'tumble', lumpiness: 0.05, flatness: -0.05 },
];
/** Curated seeds by variation. */
const CHOSEN_SEEDS = [7, 3, 13, 14, 4, 23, 11, 16, 21, 8, 25, 31];
/** Distance between the seed ranges of two designs. */
const SEED_STRIDE = 1000;

/** The first `count` variations of a design. A variation does not depend on `count`. */
export function designedShapes(design: PuffDesign, count: number): PuffShape[] {
  return Array.from({ length: count }, (_, variation) => designedShape(design, variation));
}

function designedShape(design: PuffDesign, variation: number): PuffShape {
  const lean = LEANS[variation % LEANS.length];
  const chosen = design.seed === 0 ? CHOSEN_SEEDS[variation] : undefined;
  const seed = chosen ?? design.seed * SEED_STRIDE + 100 + variation;
  const knobs: PuffKnobs = {
    lumpiness: leant(design.lumpiness, lean.lumpiness),
    flatness: leant(design.flatness, lean.flatness),
    roughness: leant(design.roughness, lean.roughness),
  };
  const isFirst = design.seed === 0 && variation < LEANS.length;
  return proceduralPuff(isFirst ? lean.name : `${lean.name} ${seed}`, seed, knobs, design.lobes);
}

function leant(knob: number, lean = 0): number {
  return Math.min(1, Math.max(0, knob + lean));
}

/** The default puffs, in the order of variations. */
export const LOBE_SHAPES: readonly PuffShape[] = designedShapes(DEFAULT_DESIGN, DEFAULT_VARIATIONS);
