/**
 * The single file for CDNs. On a page it defines `<cartoon-smoke>` and sets `window.puff`, unless the page has a global
 * `puff` of its own. The worker loads the same file, which is in the browser's cache by then.
 */
import { puff, type Puff } from './page/puff/puff.ts';

export { CartoonSmokeElement } from './page/element/define.ts';

declare global {
  interface Window {
    puff: Puff;
  }
}

if ('WorkerGlobalScope' in globalThis) await import('./stage/remote/worker.ts');
// An element with the ID `puff` is a property of the prototype.
else if (!Object.hasOwn(window, 'puff')) window.puff = puff;

export { puff };
