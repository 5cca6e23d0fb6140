/**
 * Replaces LOBES by the number of lobes. three.js unrolls loops only with literal bounds; unrolled loops need no
 * dynamic indexing.
 */
export function withLobes(shader: string, lobes: number): string {
  return shader.replaceAll(/\bLOBES\b/g, String(lobes));
}

/** Defines of programs whose puffs turn, stretch or unfold; see shaders/lib/orientation.glsl. */
export const DEFORMED = { DEFORMED: '' };
