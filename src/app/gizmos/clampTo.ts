import { findParameter } from '../../preset/table.ts';

/** A number that the row of this key takes, with so many decimals: what comes from pixels has no use for more. */
export function clampTo(key: string, value: number, decimals: number): number {
  const row = findParameter(key);
  if (row?.kind !== 'number') return value;
  const rounded = Number(value.toFixed(decimals));
  // The addition turns -0 into 0, as a link does.
  return Math.min(Math.max(rounded, row.min), row.max) + 0;
}
