/** Code of puffs with bites, in place of `#pragma insert_bites` in shaders. It is loaded on demand. */
export interface BiteShaders {
  /** Where the bites are, for vertex shaders. */
  readonly placing: string;
  readonly ofBodies: string;
  readonly ofVolumes: string;
}

/**
 * Replaces LOBES by the number of lobes. three.js unrolls loops only with literal bounds; unrolled loops need no
 * dynamic indexing.
 * @param bites code in place of `#pragma insert_bites`
 */
export function withLobes(shader: string, lobes: number, bites = ''): string {
  return shader.replace('#pragma insert_bites', () => bites).replaceAll(/\bLOBES\b/g, String(lobes));
}

/** How the puffs of a program differ from whole puffs in their baked shapes. */
export interface PuffChanges {
  /** Whether they turn, stretch or unfold; see shaders/lib/orientation.glsl. */
  readonly isDeformed: boolean;
  /** The code of their bites, if they have bites. */
  readonly bites?: BiteShaders;
}

export function puffDefines({ isDeformed, bites }: PuffChanges): Readonly<Record<string, string>> {
  return { ...(isDeformed && { DEFORMED: '' }), ...(bites && { ERODED: '' }) };
}

/** A key of a program for puffs with a number of lobes. */
export function puffKey(lobes: number, changes: PuffChanges): string {
  return [lobes, ...Object.keys(puffDefines(changes))].join(' ');
}
