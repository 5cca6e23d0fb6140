/** Limits for share links that contain a take, and the values that takes do not record. */
import type { Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';

/** Maximum particle capacity that a take from a link may request. */
export function linkCapacity(): number {
  const row = findParameter('simulation.maxParticles');
  return row?.kind === 'integer' ? (row.linkMax ?? row.max) : 0;
}

/** Values for style, light and camera. The simulator does not read them, so takes do not record them per step. */
export function lookOf(values: Values): Values {
  const isLook = (key: string) => ['style', 'light', 'camera'].includes(findParameter(key)!.reader);
  return Object.fromEntries(Object.entries(values).filter(([key]) => isLook(key)));
}
