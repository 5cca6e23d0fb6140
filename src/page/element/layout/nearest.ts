import type { Box } from '../../plane.ts';

/**
 * Selects the boxes that smoke is most likely to reach, in their original order. Boxes within the container come first,
 * nearest to a source; boxes outside it follow by their distance to it.
 * @param container of the smoke on the page
 * @param sources boxes that emit smoke; empty when unknown
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

/** Distance between two boxes in pixels; 0 where they touch or overlap. */
function gap(one: Box, other: Box): number {
  const across = Math.max(one.left - other.left - other.width, other.left - one.left - one.width, 0);
  const down = Math.max(one.top - other.top - other.height, other.top - one.top - one.height, 0);
  return Math.hypot(across, down);
}
