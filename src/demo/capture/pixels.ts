/** By how much a channel that is read may deviate: some browsers falsify the lowest bits against fingerprinting. */
export const NOISE = 1;

/** Whether two pixels as 0xAABBGGRR may be the same colour. */
export function isSame(a: number, b: number): boolean {
  return [0, 8, 16, 24].every((shift) => Math.abs(((a >>> shift) & 0xff) - ((b >>> shift) & 0xff)) <= NOISE);
}

/** Converts an sRGB code (0 to 255) to linear light (0 to 1). */
export function linear(code: number): number {
  const value = code / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
