import type { Values } from '../../preset.ts';

/** Turns off what the paper does not have, so that its figures differ by the method alone. */
export const PLAIN_LOOK: Values = {
  'puff.turn': 0,
  'puff.stretch': 1,
  'puff.billow': 0,
  'emission.dissolve': 'shrink',
  'style.simplify': 0,
  'style.form': 0,
  'style.strokes': 0,
};
