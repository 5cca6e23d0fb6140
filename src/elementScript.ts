/**
 * The single file for CDNs. On a page it defines `<cartoon-smoke>`. The element's worker loads the same file, which is
 * in the browser's cache by then.
 */
export { CartoonSmokeElement } from './page/element/define.ts';

if ('WorkerGlobalScope' in globalThis) await import('./stage/remote/worker.ts');
