/**
 * The one file for CDNs. On a page it makes `<cartoon-smoke>` an element; the worker that the element starts is the same
 * file, which is in the browser's cache by then.
 */
export { CartoonSmokeElement } from './define.ts';

if ('WorkerGlobalScope' in globalThis) await import('../remote/worker.ts');
