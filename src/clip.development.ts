/** `cartoon-smoke/clip` with warnings. */
import { clip as production } from './clip.ts';
import { watch } from './page/clip/warnings.ts';

export * from './clip.ts';
export const clip = watch(production);
