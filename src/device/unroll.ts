/** Puts the number in as digits, which three.js needs to unroll the loops, and then the shader has no dynamic index. */
export function withLobes(shader: string, lobes: number): string {
  return shader.replaceAll(/\bLOBES\b/g, String(lobes));
}
