/** `cartoon-smoke/puff` with warnings. */
import { puff as production } from './puff.ts';
import { watch } from './page/puff/warnings.ts';

export * from './puff.ts';
export const puff = watch(production);
