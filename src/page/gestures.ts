/** Gesture and key sensitivity, shared by the demo page and the element. */

/** Radians per CSS pixel of a drag. */
export const ORBIT_PER_PIXEL = 0.006;
/** Radians per press of an arrow key. */
export const ORBIT_PER_KEY = Math.PI / 24;

/** Characters of keys without a letter or digit on the US layout, without and with Shift. */
const US: Readonly<Record<string, string>> = {
  Comma: ',<',
  Period: '.>',
  Slash: '/?',
  BracketLeft: '[{',
  BracketRight: ']}',
  Minus: '-_',
  Equal: '=+',
};

/**
 * The key of an event, letters in lower case. A character that is neither ASCII nor a Latin letter, as on Cyrillic and
 * Greek layouts, is replaced by the one at this place on the US layout.
 */
export function keyOf({ key, code, shiftKey }: KeyboardEvent): string {
  if (/^[ -~\p{Script=Latin}]/u.test(key)) return key.length === 1 ? key.toLowerCase() : key;
  const character = /^(?:Key|Digit)(.)$/.exec(code)?.[1].toLowerCase();
  return character ?? US[code]?.[Number(shiftKey)] ?? key;
}

interface Point {
  readonly x: number;
  readonly y: number;
}

/** Distance between the first two points, in pixels; 0 for fewer than two. */
export function spread([a, b]: readonly Point[]): number {
  return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
}
