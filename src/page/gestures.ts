/** Gesture and key sensitivity, shared by the demo page and the element. */

/** Radians per CSS pixel of a drag. */
export const ORBIT_PER_PIXEL = 0.006;
/** Radians per press of an arrow key. */
export const ORBIT_PER_KEY = Math.PI / 24;

interface Point {
  readonly x: number;
  readonly y: number;
}

/** Distance between the first two points, in pixels; 0 for fewer than two. */
export function spread([a, b]: readonly Point[]): number {
  return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
}
