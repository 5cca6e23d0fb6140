import { resolveObjectURL } from 'node:buffer';
import { afterEach, expect, it, vi } from 'vitest';

afterEach(() => {
  vi.unstubAllGlobals();
  vi.resetModules();
  Reflect.deleteProperty(globalThis, Symbol.for('cartoon-smoke.assetUrls'));
});

async function startedFrom(url?: string): Promise<string> {
  const started = vi.fn();
  vi.stubGlobal('Worker', started);
  vi.stubGlobal('location', new URL('https://page.example/app/'));
  if (url) (await import('../../../../src/base/setAssetUrls.ts')).setAssetUrls({ worker: url });
  (await import('../../../../src/stage/remote/pageWorker.ts')).startWorker();
  expect(started).toHaveBeenCalledTimes(1);
  return String(started.mock.calls[0][0]);
}

it('starts the script of the library', async () => {
  expect(await startedFrom()).toMatch(/\/remote\/worker\.ts$/);
});

it('starts the script that the page has set', async () => {
  expect(await startedFrom('https://page.example/files/worker.js')).toBe('https://page.example/files/worker.js');
});

it('starts the script that was set by another build or copy of the package', async () => {
  (await import('../../../../src/base/setAssetUrls.ts')).setAssetUrls({
    worker: 'https://page.example/files/worker.js',
  });
  vi.resetModules();
  expect(await startedFrom()).toBe('https://page.example/files/worker.js');
});

it('starts a script of another host from a blob, and leaves the global Worker alone', async () => {
  const set = vi.fn();
  const Worker = vi.fn(function (address: string | URL) {
    if (!String(address).startsWith('blob:')) throw new DOMException('another origin', 'SecurityError');
  });
  vi.stubGlobal('location', new URL('https://page.example/app/'));
  vi.stubGlobal('Worker', undefined);
  Object.defineProperty(globalThis, 'Worker', { get: () => Worker, set, configurable: true });
  const { startWorker } = await import('../../../../src/stage/remote/pageWorker.ts');
  expect(startWorker()).toBeInstanceOf(Worker);
  const addresses = Worker.mock.calls.map(([address]) => String(address));
  expect(addresses).toEqual([expect.stringMatching(/\/remote\/worker\.ts$/), expect.stringMatching(/^blob:/)]);
  const script = await resolveObjectURL(addresses[1])!.text();
  expect(script).toBe(`import ${JSON.stringify(addresses[0])};`);
  expect(set).not.toHaveBeenCalled();
});

it.each([
  [
    'http://localhost:5173/node_modules/.vite/deps/worker.js',
    'http://localhost:5173/node_modules/cartoon-smoke/dist/worker.js',
  ],
  [
    'http://localhost/app/node_modules/.vite/deps/wasm/core/a.wasm',
    'http://localhost/app/node_modules/cartoon-smoke/dist/wasm/core/a.wasm',
  ],
  ['http://localhost/node_modules/cartoon-smoke/dist/worker.js', undefined],
  ['https://page.example/assets/wasm/core/a.wasm', undefined],
])('finds %s on the development server of Vite', async (url, served = url) => {
  const { servedUrl } = await import('../../../../src/base/assetUrls.ts');
  expect(servedUrl(url)).toBe(served);
});
