/** What a link that leads to one moment may ask for, and what of it no take keeps. */
import type { Values } from '../preset/parameter.ts';
import { findParameter } from '../preset/table.ts';

/** The most particles that the take of a link may make room for. */
export function linkCapacity(): number {
  const row = findParameter('simulation.maxParticles');
  return row?.kind === 'integer' ? (row.linkMax ?? row.max) : 0;
}

/** Style, light and camera: what the simulator does not read, and so no take keeps by step. */
export function lookOf(values: Values): Values {
  const isLook = (key: string) => ['style', 'light', 'camera'].includes(findParameter(key)!.reader);
  return Object.fromEntries(Object.entries(values).filter(([key]) => isLook(key)));
}
