import type { AnyValues } from '../../index.ts';

/** What a case has besides the defaults of `CartoonSmoke`. */
export interface CostCase {
  readonly name: string;
  readonly puffs: number;
  /** Pixels per CSS pixel; default 1. */
  readonly pixelRatio?: number;
  /** Whether smoke collides with the mesh in the scene. */
  readonly collides?: boolean;
  /** Whether the mesh casts shadow volumes onto the smoke. */
  readonly casts?: boolean;
  readonly values?: AnyValues;
}

/** The case that the others are compared with. */
export const BASE: CostCase = { name: '2,000 puffs', puffs: 2000 };

/** What everybody can measure. */
export const CASES: readonly CostCase[] = [
  { name: '500 puffs', puffs: 500 },
  { name: '10,000 puffs', puffs: 10_000 },
  { name: 'pixel ratio 2', puffs: BASE.puffs, pixelRatio: 2 },
  { name: '`collide` with a mesh', puffs: BASE.puffs, collides: true },
  { name: '`cast` of a mesh', puffs: BASE.puffs, casts: true },
];
