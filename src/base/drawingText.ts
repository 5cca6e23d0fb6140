/** The grammar of drawn puffs in links, which `src/renderer/puffs/drawing/drawing.ts` describes and reads. */

/** Maximum length of one variation in characters. */
export const DRAWING_LIMIT = 1200;
/** Maximum number of variations. */
export const MAX_DRAWINGS = 4;

const LINES = String.raw`\*[\w-]{3}([\w-]{2})+(\.[\w-]{3}([\w-]{2})+)*`;
const VARIATION = new RegExp(`^[0-9a-f]{6}${LINES}(,[0-9a-f]{6}${LINES})*(,${LINES})?$`);

/** Whether a text is empty, for none, or one to four valid drawings. */
export function isDrawing(text: string): boolean {
  const variations = text.split(';');
  if (text === '') return true;
  return (
    variations.length <= MAX_DRAWINGS &&
    variations.every((each) => each.length <= DRAWING_LIMIT && VARIATION.test(each))
  );
}
