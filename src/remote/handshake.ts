/** The first words between a page and the smoke in one of its frames, before they have a port of their own. */
import { isPlain } from './shapes.ts';

/** The frame says that it is there; the page, with a port, that it wants the stage. */
export type Word = 'here' | 'connect';

export function say(word: Word): { cartoonSmoke: Word } {
  return { cartoonSmoke: word };
}

export function isWord(message: unknown, word: Word): boolean {
  return isPlain(message) && message.cartoonSmoke === word && Object.keys(message).length === 1;
}
