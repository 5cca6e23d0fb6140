/** Warnings for the script for CDNs, which this module imports. */
import './page/element/warnings.ts';
import { watch } from './page/puff/warnings.ts';
import { puff as production } from './script.ts';

const puff = watch(production);
if (globalThis.window?.puff === production) window.puff = puff;

export { puff };
export { CartoonSmokeElement } from './script.ts';
