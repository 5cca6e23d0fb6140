/** The single file of `puff()` for CDNs, with warnings. */
import '../puff/script.ts';
import { puff } from './puff.ts';

if (globalThis.window) window.puff = puff;

export { puff };
