/**
 * The single file for CDNs. On a page it sets `window.puff`. The worker loads the same file, which is in the browser's
 * cache by then.
 */
import { puff, type Puff } from './page/puff/puff.ts';

declare global {
  interface Window {
    puff: Puff;
  }
}

if ('WorkerGlobalScope' in globalThis) await import('./stage/remote/worker.ts');
else window.puff = puff;

export { puff };
