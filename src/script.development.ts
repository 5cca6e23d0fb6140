/** The single file for CDNs, with warnings. */
import './page/element/warnings.ts';
import { puff } from './puff.development.ts';
import { puff as production } from './script.ts';

if (globalThis.window?.puff === production) window.puff = puff;

export { puff };
export { CartoonSmokeElement } from './script.ts';
