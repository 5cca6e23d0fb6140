/** Two versions of the package on one page: the first one defines the element, and the console has no messages. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { watchConsole } from '../../../support/consoleErrors.ts';
import { expect, MODULES, stands, test } from '../../../support/embed.ts';

const OTHER = '9.8.7';
const PACKAGE = fileURLToPath(new URL('../../../../package/', import.meta.url));
// Of the repository: the package may not be built yet when this file is loaded.
const MANIFEST = new URL('../../../../package.json', import.meta.url);
const { version } = JSON.parse(readFileSync(MANIFEST, 'utf8')) as { version: string };
const SMOKE = 'preset="wisp" simulation-max-particles="300" paused style="width: 64px; height: 48px"';
const NOTICES = `<script>
  window.notified = [];
  document.addEventListener('statechange', ({ detail }) => window.notified.push(...detail.notices), true);
</script>`;

/** The files below `/other/` are the package with a later version number. */
async function serveOther(page: Page): Promise<void> {
  await page.context().route('**/other/**', (route) => {
    const file = readFileSync(`${PACKAGE}dist/${new URL(route.request().url()).pathname.replace('/other/', '')}`);
    if (!route.request().url().endsWith('.js')) return route.fulfill({ contentType: 'application/wasm', body: file });
    return route.fulfill({ contentType: 'text/javascript', body: file.toString().replaceAll(version, OTHER) });
  });
}

test('the second version leaves the element to the first, with a notice', async ({ page, openPage }) => {
  const lines = watchConsole(page);
  await serveOther(page);
  const script = `${NOTICES}${MODULES}<script type="module" src="/other/cartoon-smoke.min.js"></script>`;
  await openPage(`<cartoon-smoke ${SMOKE}></cartoon-smoke><script type="module">window.isLoaded = true</script>`, {
    script,
  });
  await stands(page);
  await page.waitForFunction(() => 'isLoaded' in window);
  const used = await page.evaluate(() => Reflect.get(customElements.get('cartoon-smoke')!, 'version') as string);
  expect(used).toBe(version);
  const notified = await page.evaluate(() => Reflect.get(window, 'notified') as unknown[]);
  const message = `cartoon-smoke ${version} is already in use; version ${OTHER} is ignored.`;
  expect(notified).toEqual([{ code: 'otherVersion', key: 'version', given: OTHER, message }]);
  expect(lines).toEqual([]);
});

test('the second version works under another tag beside the first @long', async ({ page, openPage }) => {
  const lines = watchConsole(page);
  await serveOther(page);
  await openPage(`<cartoon-smoke ${SMOKE}></cartoon-smoke><other-smoke ${SMOKE}></other-smoke>
    <script type="module">
      import { CartoonSmokeElement } from '/other/index.js';
      customElements.define('other-smoke', CartoonSmokeElement);
    </script>`);
  await stands(page, 'cartoon-smoke');
  await stands(page, 'other-smoke');
  const versions = await page.evaluate(() =>
    ['cartoon-smoke', 'other-smoke'].map((name) => Reflect.get(customElements.get(name)!, 'version') as string),
  );
  expect(versions).toEqual([version, OTHER]);
  const hashes = await page.evaluate(() =>
    Promise.all(
      [...document.querySelectorAll<HTMLElementTagNameMap['cartoon-smoke']>('cartoon-smoke, other-smoke')].map(
        async (smoke) => {
          await smoke.step(30);
          return smoke.hash();
        },
      ),
    ),
  );
  expect(hashes[0]).toBe(hashes[1]);
  expect(lines).toEqual([]);
});
