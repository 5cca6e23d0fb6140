/** A development server that finds a dependency late answers 504 for those that pages have loaded. */
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterEach, expect, test } from 'vitest';
import { createServer, type ViteDevServer } from 'vite';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

let server: ViteDevServer | undefined;
let cacheDir: string | undefined;
afterEach(async () => {
  await server?.close();
  if (cacheDir) rmSync(cacheDir, { recursive: true });
});

test.each([
  // The other examples need packages of their own.
  ['vite.config.ts', /^(src|examples\/(?!vue|svelte|next)\w+)\/.+\.tsx?$/],
  ['tests/support/vite.config.ts', /^(src\/.+|tests\/(.+\.cases|engines\/page\/.+))\.ts$/],
  ['tests/bench/vite.config.ts', /^(src|tests\/bench\/(host|load|render|sim))\/.+\.ts$/],
])('the server of %s optimises once, on an empty cache', async (config, pattern) => {
  cacheDir = mkdtempSync(join(tmpdir(), 'cartoon-smoke-vite-'));
  const configFile = join(ROOT, config);
  const inline = {
    root: ROOT,
    configFile,
    cacheDir,
    logLevel: 'error',
    server: { port: 0, hmr: false, watch: null },
  } as const;
  server = await createServer(inline);
  await server.listen();
  const address = server.resolvedUrls!.local[0];
  const { moduleGraph } = server.environments.client;
  const files = ['src', 'examples', 'tests'].flatMap((folder) =>
    readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' }).map((path) => `${folder}/${path}`),
  );
  const paths = files.filter((path) => pattern.test(path) && !/config\.ts$|\.d\.ts$|node_modules/.test(path));
  expect(paths.length).toBeGreaterThan(100);
  const answers = new Map<string, number>();
  // One entry after another, as tests request them.
  for (const path of paths) {
    const urls = [`/${path}`];
    for (let url = urls.pop(); url; url = urls.pop()) {
      if (answers.has(url)) continue;
      const response = await fetch(new URL(url, address));
      await response.text();
      answers.set(url, response.status);
      const imported = await moduleGraph.getModuleByUrl(url);
      // The page of examples imports these as text.
      const found = [...(imported?.importedModules ?? [])].filter((module) => !module.url.startsWith('/examples/'));
      urls.push(...found.map((module) => module.url));
    }
  }
  expect([...answers].filter(([, status]) => status !== 200)).toEqual([]);
  // The decoders of Draco are files that its loader names.
  const others = [...answers.keys()].filter((url) => /^\/node_modules\/(?!three\/examples\/jsm\/libs\/)/.test(url));
  expect(others, 'packages to name in optimizeDeps.include').toEqual([]);
});
