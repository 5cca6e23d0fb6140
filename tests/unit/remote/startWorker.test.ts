import { afterEach, expect, it, vi } from 'vitest';

afterEach(() => {
  vi.unstubAllGlobals();
  vi.resetModules();
});

async function startedFrom(url?: string): Promise<string> {
  const started = vi.fn();
  vi.stubGlobal('Worker', started);
  vi.stubGlobal('location', new URL('https://page.example/app/'));
  if (url) (await import('../../../src/preset/assetUrls.ts')).setAssetUrls({ worker: url });
  (await import('../../../src/remote/startWorker.ts')).startWorker();
  expect(started).toHaveBeenCalledTimes(1);
  return String(started.mock.calls[0][0]);
}

it('starts the script of the library', async () => {
  expect(await startedFrom()).toMatch(/\/remote\/worker\.ts$/);
});

it('starts the script that the page has set', async () => {
  expect(await startedFrom('https://page.example/files/worker.js')).toBe('https://page.example/files/worker.js');
});
