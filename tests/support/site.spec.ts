/** The built site, served by a plain file server from a folder deep inside a host. */
import { spawnSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from './fixtures.ts';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const FOLDER = '/some/where/';
const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

let server: Server;

test.beforeAll(async () => {
  test.setTimeout(180_000);
  const build = spawnSync(process.execPath, [join(ROOT, 'scripts/build.mjs')], { encoding: 'utf8' });
  expect(build.status, build.stderr).toBe(0);
  server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname;
    const name = path.endsWith('/') ? `${path}index.html` : path;
    const type = TYPES[extname(name)];
    const body = name.startsWith(FOLDER) ? readFile(join(ROOT, 'dist', name.slice(FOLDER.length))) : Promise.reject();
    body.then(
      (bytes) => response.writeHead(200, type ? { 'content-type': type } : {}).end(bytes),
      () => response.writeHead(404).end(),
    );
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
});

test.afterAll(() => server.close());

test('runs from any folder, because its addresses are relative', async ({ page }) => {
  const missing: string[] = [];
  page.on('response', (response) => response.status() >= 400 && missing.push(response.url()));
  const { port } = server.address() as AddressInfo;
  await page.goto(`http://localhost:${port}${FOLDER}#v=1&preset=lamp&emission.rate=40&simulation.maxParticles=500`);
  await page.waitForFunction(() => window.cartoonSmoke !== undefined, null, { timeout: 60_000 });
  await expect
    .poll(() => page.evaluate(() => window.cartoonSmoke?.stats.alive), { timeout: 30_000 })
    .toBeGreaterThan(0);
  expect(missing).toEqual([]);
});
