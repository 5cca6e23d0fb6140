/** The measurements of `npm run bench -- sim`, in one page. */
import type { Figure } from '../support/figures.ts';
import { measureCollisions } from './collide/collisions.ts';
import { measureFlows } from './flows.ts';
import { measureLooks } from './looks.ts';
import { measureParts } from './parts.ts';
import { measureShapes } from './shapes.ts';
import { measureSizes } from './sizes.ts';
import { measureTimeline } from './timeline.ts';
import { measureAgainstCompat } from './collide/versusCompat.ts';
import { measureAgainstOthers } from './versusOthers.ts';
import { measureVortexParticles } from './vortexParticles.ts';

export async function measure(quick: boolean): Promise<Figure[]> {
  if (!globalThis.crossOriginIsolated) throw new Error('The page is not isolated, so its clock is too coarse.');
  return [
    ...(await measureAgainstOthers(quick)),
    ...(await measureParts(quick)),
    ...(await measureLooks(quick)),
    ...(await measureSizes(quick)),
    ...(await measureShapes(quick)),
    ...(await measureFlows(quick)),
    ...(await measureTimeline(quick)),
    ...(await measureVortexParticles(quick)),
    ...(await measureAgainstCompat(quick)),
    ...(await measureCollisions(quick)),
  ];
}
