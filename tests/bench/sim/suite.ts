/** What `npm run bench -- sim` measures, inside one page. */
import type { Figure } from '../support/figures.ts';
import { measureAgainstCompat } from './versusCompat.ts';
import { measureAgainstJavaScript, measureSteps } from './versusJavaScript.ts';

export async function measure(quick: boolean): Promise<Figure[]> {
  if (!globalThis.crossOriginIsolated) throw new Error('The page is not isolated, so its clock is too coarse.');
  return [
    ...(await measureAgainstJavaScript(quick)),
    ...(await measureAgainstCompat(quick)),
    ...(await measureSteps(quick)),
  ];
}
