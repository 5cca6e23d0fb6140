/**
 * Replaces LOBES by the number of lobes. three.js unrolls loops only with literal bounds; unrolled loops need no
 * dynamic indexing.
 */
export function withLobes(shader: string, lobes: number): string {
  return shader.replaceAll(/\bLOBES\b/g, String(lobes));
}
