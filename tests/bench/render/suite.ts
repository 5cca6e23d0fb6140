/** The measurements of `npm run bench -- render`, in one page. */
import type { Figure } from '../support/figures.ts';
import { measureMemory } from './memory.ts';
import { measureDrawings } from './drawings.ts';
import { measureForms } from './forms.ts';
import { measureLights, measureLooks, measurePatterns } from './looks.ts';
import { measureHost } from './host.ts';
import { measurePasses } from './passes.ts';
import { measureInside } from './inside.ts';
import { measureSmall } from './small.ts';
import { measureTargets } from './targets.ts';
import { measureVisible } from './visible.ts';
import { measureUploads } from './uploads.ts';
import { measureAgainstQuarks } from './versusQuarks.ts';
import { measureAgainstSelle } from './versusSelle.ts';

export async function measure(quick: boolean): Promise<Figure[]> {
  if (!globalThis.crossOriginIsolated) throw new Error('The page is not isolated, so its clock is too coarse.');
  return [
    ...(await measurePasses(quick)),
    ...(await measureForms(quick)),
    ...(await measureDrawings(quick)),
    ...(await measureAgainstQuarks(quick)),
    ...(await measureLooks(quick)),
    ...(await measureLights(quick)),
    ...(await measurePatterns(quick)),
    ...(await measureAgainstSelle(quick)),
    ...(await measureInside(quick)),
    ...(await measureVisible(quick)),
    ...(await measureSmall(quick)),
    ...(await measureHost(quick)),
    ...(await measureUploads()),
    ...(await measureTargets()),
    ...(await measureMemory()),
  ];
}
