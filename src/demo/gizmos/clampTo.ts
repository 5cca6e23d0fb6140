import { findParameter } from '../../preset.ts';

/** Rounds a value and clamps it to the parameter's range. Values from pixel positions need only a few decimals. */
export function clampTo(key: string, value: number, decimals: number): number {
  const row = findParameter(key);
  if (row?.kind !== 'number') return value;
  const rounded = Number(value.toFixed(decimals));
  // Adding 0 converts -0 to 0, as a link does.
  return Math.min(Math.max(rounded, row.min), row.max) + 0;
}
