/** The words that smoke forms: their outlines, and the shapes of the parameter table that calls have. */
import { ParameterError } from '../../base/errors.ts';
import type { Values } from '../../parameters/parameter.ts';
import { traceShape } from '../outline/traceShape.ts';
import { rounded, underKey, vector, type PlaneRectangle } from '../plane.ts';
import { MAX_TEXT } from './options.ts';
import { Slots } from './slots.ts';
import type { Source } from './target.ts';

/** Width and height of a letter, metres; a word is not narrower than its target, nor wider than the maximum. */
const LETTER = { width: 0.36, height: 0.52 };
const MAX_WIDTH = 5;
/** Distance between a target and its word. */
const GAP = 0.12;
/** Seconds for which a word holds its smoke. */
export const HOLD = 2.6;
/** Where smoke goes to the word, besides the word and the target, metres. */
const MARGIN = 0.5;

/** A word in letters that it can be read in. */
export interface Word {
  readonly text: string;
  readonly outline: string;
}

/**
 * The word of a call: the one that it gives, or the text of its target.
 * @throws ParameterError if there is none
 */
export async function wordOf(given: string | undefined, { element }: Source): Promise<Word> {
  const text = (given ?? textOf(element)).replaceAll(/\s+/g, ' ').trim().slice(0, MAX_TEXT);
  if (text === '')
    throw new ParameterError('text', given, `1 to ${MAX_TEXT} characters, because the target has no text`);
  const family = element && getComputedStyle(element).fontFamily;
  return { text, outline: await traceShape({ text, font: `900 ${family || 'system-ui, sans-serif'}` }) };
}

function textOf(element: Element | undefined): string {
  return (element as HTMLInputElement | undefined)?.value || element?.textContent || '';
}

/** The size of a word over a target: metres. */
export function sizeOfWord(text: string, halfWidth: number): { width: number; height: number } {
  const letters = Math.max(3, text.length);
  const usual = letters * LETTER.width;
  const width = Math.min(MAX_WIDTH, Math.max(usual, 2 * halfWidth));
  return { width, height: (LETTER.height * width) / usual };
}

/** The shapes of words. When there are too many, the oldest goes. */
export class Words {
  private readonly slots = new Slots();

  /**
   * Values of a shape above a target, or below it where there is no room above.
   * @param owner frees it
   * @param top height of the upper edge of the picture, metres
   * @param time simulated time of the call
   */
  claim(owner: object, { text, outline }: Word, place: PlaneRectangle, top: number, time: number): Values {
    const { width, height } = sizeOfWord(text, place.halfWidth);
    const away = place.halfHeight + GAP + height / 2;
    const [x, y] = place.middle;
    const isAbove = y + away + height / 2 <= top;
    const middle = isAbove ? y + away : y - away;
    return underKey(`shapes.${this.slots.claim(owner)}`, {
      outline,
      speed: 3,
      hold: 8,
      size: rounded(width),
      depth: 0.2,
      ...vector('position', [rounded(x), rounded(middle), 0]),
      'region.shape': 'box',
      ...vector('region.position', [rounded(x), rounded((middle + y) / 2), 0]),
      ...vector('region.size', [rounded(width / 2 + MARGIN), rounded(away / 2 + height / 2 + MARGIN), 2]),
      'envelope.start': rounded(time),
      'envelope.duration': HOLD,
      'envelope.fade': 0.2,
    });
  }

  /** Values that end the shapes of an owner; of all without one. */
  release(owner?: object): Values {
    const gone = this.slots.release(owner);
    return Object.assign({}, ...gone.map((index) => underKey(`shapes.${index}`, { speed: 0 }))) as Values;
  }
}
