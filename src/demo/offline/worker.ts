/**
 * The service worker: everything that was fetched once works offline. Files with a hash in their name are served
 * cache-first, because they never change. Pages are served network-first, so that updates appear at once. Only the
 * start page is prefetched, so visitors download only what they use. Readers of the documentation get all of its text, so
 * that its search works offline.
 */

/** Types that TypeScript's DOM library lacks. */
interface LastingEvent extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface Fetching extends LastingEvent {
  readonly request: Request;
  respondWith(answer: Promise<Response>): void;
}
interface WorkerScope {
  readonly registration: { readonly scope: string };
  readonly clients: { claim(): Promise<void> };
  skipWaiting(): Promise<void>;
  addEventListener(type: 'install' | 'activate', listener: (event: LastingEvent) => void): void;
  addEventListener(type: 'fetch', listener: (event: Fetching) => void): void;
  addEventListener(type: 'message', listener: (event: LastingEvent & { readonly data: unknown }) => void): void;
}

/** Defined by the build: the files of this version with a hash in their name, relative to the scope. */
declare const HASHED_FILES: readonly string[];

/** Timeout in milliseconds for the first response; then the cached page is used. */
const TIMEOUT_MS = 4000;

const worker = self as unknown as WorkerScope;
const { scope } = worker.registration;
// Other pages of the origin share the cache storage, so the name includes the scope.
const CACHE = `cartoon-smoke ${scope}`;
const hashed = new Set(HASHED_FILES.map((file) => new URL(file, scope).href));
const DOCS = new URL('docs/', scope).href;
const DOCS_ASSETS = new URL('assets/', DOCS).href;

worker.addEventListener('install', (event) => event.waitUntil(keep([scope])));
worker.addEventListener('activate', (event) => event.waitUntil(forget().then(() => worker.clients.claim())));
worker.addEventListener('message', (event) => {
  if (event.data === 'take over') event.waitUntil(worker.skipWaiting());
  else if (Array.isArray(event.data)) event.waitUntil(keepKnown(event.data.map(String)));
});
worker.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET') return;
  if (hashed.has(request.url) || request.url.startsWith(DOCS_ASSETS)) event.respondWith(cacheFirst(request));
  else if (request.mode === 'navigate' && request.url.startsWith(scope)) event.respondWith(networkFirst(request));
});

/** Adds files of this version. A list of the documentation is all of it, and replaces that of an earlier version. */
async function keepKnown(files: readonly string[]): Promise<void> {
  const docs = new Set(files.filter((file) => file.startsWith(DOCS)));
  await keep([...files.filter((file) => hashed.has(file)), ...docs]);
  if (docs.size > 0) await remove((url) => url.startsWith(DOCS) && !docs.has(url));
}

/** Adds missing files to the cache, and refreshes the start page. */
async function keep(files: readonly string[]): Promise<void> {
  const cache = await caches.open(CACHE);
  const cached = new Set((await cache.keys()).map(({ url }) => url));
  await cache.addAll(files.filter((file) => file === scope || !cached.has(file)));
}

/** Deletes the files of other versions; pages stay. */
async function forget(): Promise<void> {
  const assets = new URL('assets/', scope).href;
  await remove((url) => url.startsWith(assets) && !hashed.has(url));
}

async function remove(isOld: (url: string) => boolean): Promise<void> {
  const cache = await caches.open(CACHE);
  const old = (await cache.keys()).filter(({ url }) => isOld(url));
  await Promise.all(old.map((request) => cache.delete(request)));
}

async function cacheFirst(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  const cached = await cache.match(request.url);
  if (cached) return cached;
  const answer = await fetch(request);
  if (answer.ok) await cache.put(request.url, answer.clone());
  return answer;
}

async function networkFirst(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  const page = request.url.replace(/[?#].*$/, '');
  const controller = new AbortController();
  const timer = setTimeout(() => controller.abort(), TIMEOUT_MS);
  try {
    const answer = await fetch(request, { signal: controller.signal });
    if (answer.ok) await cache.put(page, answer.clone());
    return answer;
  } catch (error) {
    const cached = await cache.match(page);
    if (cached) return cached;
    throw error;
  } finally {
    clearTimeout(timer);
  }
}
