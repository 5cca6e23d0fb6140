/** The single file of `puff()` for CDNs, with warnings. */
import './puffScript.ts';
import { puff } from './puff.development.ts';

if (globalThis.window) window.puff = puff;

export { puff };
