/**
 * The grammar of outlines in links: layers from back to front, joined by `;`, of closed lines, joined by `.`, as in
 * drawings of puffs (`src/renderer/puffs/drawing/drawing.ts`). A layer may be empty. The simulator takes an outline as
 * numbers and describes their layout in `forces/shape/outline.rs`.
 */

/** Maximum length of an outline in characters. */
export const OUTLINE_LIMIT = 1024;
/** Maximum number of layers. */
export const MAX_LAYERS = 8;

const CHARACTERS = 8;
const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.;';
const RADIX = 1 + DIGITS.length;
const LINE = String.raw`[\w-]{3}([\w-]{2})*`;
const LAYER = `(${LINE}(\\.${LINE})*)?`;
const OUTLINE = new RegExp(`^${LAYER}(;${LAYER}){0,${MAX_LAYERS - 1}}$`);

/** Whether a text is an outline, or empty for none. */
export function isOutline(text: string): boolean {
  return text.length <= OUTLINE_LIMIT && OUTLINE.test(text);
}

/** The numbers of a text, by the ends of their keys: `.000` and so on, 0 for those after it. */
export function packedOutline(text: string): [end: string, number: number][] {
  return Array.from({ length: OUTLINE_LIMIT / CHARACTERS }, (_, index) => {
    const part = text.slice(CHARACTERS * index, CHARACTERS * (index + 1)).split('');
    const number = part.reduceRight((sum, each) => sum * RADIX + DIGITS.indexOf(each) + 1, 0);
    return [`.${String(index).padStart(3, '0')}`, number];
  });
}

/** The text that numbers hold, the reverse of `packedOutline`. */
export function unpackedOutline(numbers: readonly number[]): string {
  const partOf = (number: number): string =>
    number > 0 ? (DIGITS[(number % RADIX) - 1] ?? '') + partOf(Math.floor(number / RADIX)) : '';
  return numbers.map(partOf).join('');
}
