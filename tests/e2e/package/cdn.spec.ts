/** The CDN script from another origin: loaded with its integrity hash, and its worker starts as well. */
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import type { puff as call } from '../../../src/script.ts';
import { watchConsole } from '../../support/consoleErrors.ts';
import { expect, stands, test as base, type Server } from '../../support/embed.ts';
import { longIf } from '../../support/fixtures.ts';
import { script } from '../../support/server.ts';

interface Hash {
  readonly file: string;
  readonly integrity: string;
}
type Headers = Record<string, string>;
type Serve = (folder: string, place: string, headers?: Headers) => Promise<Server>;
/** Shows a page with smoke that loads this script. */
type Visit = (script: string, policy?: string) => Promise<void>;

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const DIST = join(ROOT, 'package/dist');
const SMOKE =
  '<cartoon-smoke preset="wisp" simulation-max-particles="300" style="width: 200px; height: 150px"></cartoon-smoke>';

const test = base.extend<{ cdn: Server; visit: Visit }>({
  // oxlint-disable-next-line no-empty-pattern -- what it needs is no fixture, and the runner reads the pattern
  cdn: async ({}, use) => {
    const { serveSite } = await script<{ serveSite: Serve }>('site/serve.mjs');
    const cdn = await serveSite(ROOT, '/', { 'access-control-allow-origin': '*' });
    await use(cdn);
    await cdn.close();
  },
  // A separate server: intercepted pages count as a public network, which may not access this local one.
  visit: async ({ page }, use) => {
    const { serveSite } = await script<{ serveSite: Serve }>('site/serve.mjs');
    const folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-host-'));
    const servers: Server[] = [];
    await use(async (loaded, policy) => {
      const head = '<meta charset="utf-8"><title>A page</title><link rel="icon" href="data:,">';
      writeFileSync(join(folder, 'index.html'), `<!doctype html><html lang="en">${head}${loaded}${SMOKE}`);
      servers.push(await serveSite(folder, '/', policy ? { 'content-security-policy': policy } : {}));
      await page.goto(servers.at(-1)!.address);
    });
    for (const each of servers) await each.close();
    rmSync(folder, { recursive: true });
  },
});

/** The documented script tag, with the hash that the build prints. */
async function tag(cdn: Server): Promise<string> {
  const { hashes } = await script<{ hashes(folder: string): Hash[] }>('package/measure.mjs');
  const [{ file, integrity }] = hashes(DIST);
  return `<script type="module" src="${cdn.address}package/dist/${file}" crossorigin integrity="${integrity}"></script>`;
}

/** The thread of the smoke when it is ready. */
async function thread(page: Page): Promise<string> {
  await stands(page);
  return page.evaluate(async () => (await document.querySelector('cartoon-smoke')!.stage).thread);
}

test('a page with the printed hash runs smoke in a worker', async ({ page, cdn, visit }) => {
  await visit(await tag(cdn));
  expect(await thread(page)).toBe('worker');
  expect(page.workers()).toHaveLength(1);
  const scripts = new Set(cdn.sent.map(({ file }) => file).filter((file) => file.endsWith('.js')));
  expect([...scripts]).toEqual(['package/dist/cartoon-smoke.min.js']);
});

for (const [kind, warnings] of [
  ['min', []],
  ['development', [/no attribute .presett.. Did you mean .preset.\?$/, /^puff\(\): The target is null/]],
] as const) {
  const rest = longIf(kind === 'development');
  test(`the script ${kind}.js writes ${warnings.length} warnings, and runs smoke and puff()${rest}`, async ({
    page,
    cdn,
    visit,
  }) => {
    const lines = watchConsole(page);
    const url = `${cdn.address}package/dist/cartoon-smoke.${kind}.js`;
    await visit(`<script type="module" src="${url}"></script><cartoon-smoke presett="lamp"></cartoon-smoke>`);
    expect(await thread(page)).toBe('worker');
    await page.evaluate(async () => {
      await document.querySelectorAll('cartoon-smoke')[1].ready;
      const { puff } = window as unknown as { puff: typeof call };
      await Promise.all([puff(null, { count: 1, effect: 'pop' }), puff(null, { count: 1, effect: 'pop' })]);
    });
    expect(lines.toSorted()).toEqual(warnings.map((warning) => expect.stringMatching(warning) as unknown));
  });
}

test('modules of another host can start a worker @long', async ({ page, cdn, visit }) => {
  await visit(`<script type="module" src="${cdn.address}package/dist/element.js" crossorigin></script>`);
  expect(await thread(page)).toBe('worker');
  expect(cdn.sent.map(({ file }) => file)).toContain('package/dist/worker.js');
});

test.describe('with a Content Security Policy', () => {
  test.use({ allowed: /Content Security Policy/ });
  const rules = ({ origin }: URL) =>
    `default-src 'none'; script-src ${origin} 'wasm-unsafe-eval'; connect-src ${origin}; style-src 'unsafe-inline'; img-src data:`;

  test('a policy with the host and blob: runs smoke in a worker', async ({ page, cdn, visit }) => {
    await visit(await tag(cdn), `${rules(new URL(cdn.address))}; worker-src blob: ${new URL(cdn.address).origin}`);
    expect(await thread(page)).toBe('worker');
  });

  test('a policy with only the host runs smoke on the main thread @long', async ({ page, cdn, visit }) => {
    await visit(await tag(cdn), rules(new URL(cdn.address)));
    expect(await thread(page)).toBe('main');
  });
});
