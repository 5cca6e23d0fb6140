import type { Values } from '../../src/preset/parameter.ts';

/** Turns off what presets add to the plain drawing, for tests of the drawing itself. */
export const PLAIN_LOOK: Values = {
  'puff.turn': 0,
  'puff.stretch': 1,
  'puff.billow': 0,
  'style.simplify': 0,
  'style.strokes': 0,
};
