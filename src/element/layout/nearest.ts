export type Box = Pick<DOMRect, 'left' | 'top' | 'width' | 'height'>;

/**
 * Those boxes that smoke meets first, in the order in which they were given: of what the smoke's container shows, those nearest to where
 * smoke rises, and only then what lies outside.
 * @param container of the smoke on the page
 * @param sources what smoke rises from; none where the page does not know
 */
export function nearest<Given extends Box>(
  boxes: readonly Given[],
  count: number,
  container: Box,
  sources: readonly Box[],
): Given[] {
  if (boxes.length <= count) return [...boxes];
  const ranked = boxes.map((box) => ({ box, outside: gap(box, container), way: gapToAny(box, sources) }));
  ranked.sort((one, other) => one.outside - other.outside || one.way - other.way);
  const chosen = new Set(ranked.slice(0, count).map(({ box }) => box));
  return boxes.filter((box) => chosen.has(box));
}

function gapToAny(box: Box, others: readonly Box[]): number {
  return others.length === 0 ? 0 : Math.min(...others.map((other) => gap(box, other)));
}

/** Pixels between two boxes; 0 where they touch. */
function gap(one: Box, other: Box): number {
  const across = Math.max(one.left - other.left - other.width, other.left - one.left - one.width, 0);
  const down = Math.max(one.top - other.top - other.height, other.top - one.top - one.height, 0);
  return Math.hypot(across, down);
}
