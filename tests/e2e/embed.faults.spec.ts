import type { Page } from '@playwright/test';
import { expect, test } from '../support/embed.ts';

/** What a page does with smoke that fails, from before the element is upgraded. */
const failing = (thread: string, rest = '') => `
  <cartoon-smoke preset="wisp" thread="${thread}" ${rest} style="width: 200px; height: 150px">
    <svg slot="poster" id="poster" viewBox="0 0 4 3"><rect width="4" height="3" fill="teal" /></svg>
    <p id="fallback">No smoke today</p>
  </cartoon-smoke>
  <script>
    window.failure = new Promise((resolve) => {
      document.querySelector('cartoon-smoke').addEventListener('error', ({ detail }) => resolve(detail.error.name + ': ' + detail.error.message));
    });
  </script>`;

function failure(page: Page): Promise<string> {
  return page.evaluate(() => Reflect.get(window, 'failure') as Promise<string>);
}

async function expectPoster(page: Page): Promise<void> {
  await expect(page.locator('#poster')).toBeVisible();
  await expect(page.locator('#fallback')).toBeVisible();
  await expect(page.getByRole('button')).toHaveCount(0);
}

// The browser itself tells of answers that are errors.
test.use({ allowed: /Failed to load resource|Refused to compile|violates the following Content Security Policy/ });

const WASM = '**/bindings_bg.wasm';
const FAULTS: Record<string, (page: Page) => Promise<unknown>> = {
  missing: (page) => page.context().route(WASM, (route) => route.fulfill({ status: 404 })),
  'cut off': (page) =>
    page.context().route(WASM, async (route) => {
      const body = await (await route.fetch()).body();
      await route.fulfill({ contentType: 'application/wasm', body: body.subarray(0, body.length / 2) });
    }),
  'a page instead': (page) =>
    page.context().route(WASM, (route) => route.fulfill({ contentType: 'text/html', body: '<h1>Hello</h1>' })),
  'out of reach': (page) => page.context().route(WASM, (route) => route.abort()),
};

for (const [fault, provoke] of Object.entries(FAULTS)) {
  for (const thread of ['main', 'worker']) {
    test(`a simulator that is ${fault} leaves the poster and tells a LoadError: ${thread}`, async ({ page, host }) => {
      await provoke(page);
      await host(failing(thread));
      expect(await failure(page)).toMatch(/^LoadError: /);
      await expectPoster(page);
    });
  }
}

test('a simulator of which nothing comes is waited for, then told as a LoadError', async ({ page, host }) => {
  await page.clock.install();
  const asked = page.waitForRequest(WASM);
  // Never answered.
  await page.route(WASM, () => undefined);
  await host(failing('main'));
  await asked;
  await page.clock.fastForward(59_000);
  expect(await page.evaluate(() => document.querySelector('cartoon-smoke')!.playing)).toBe(false);
  await page.clock.fastForward(2_000);
  expect(await failure(page)).toMatch(/^LoadError: .*nothing has come/);
  await expectPoster(page);
});

test('smoke that cannot be fetched leaves the poster and tells a LoadError', async ({ page, host }) => {
  await page.route('**/session.js', (route) => route.abort());
  await host(failing('main'));
  expect(await failure(page)).toMatch(/^LoadError: /);
  await expectPoster(page);
});

test('a page whose rules forbid WebAssembly has the poster', async ({ page, host }) => {
  const rules = "script-src 'self' 'unsafe-inline'; worker-src 'self'";
  await host(failing('main'), { headers: { 'content-security-policy': rules } });
  expect(await failure(page)).toMatch(/^(LoadError|UnsupportedError): /);
  await expectPoster(page);
});

test('a browser without WebGL 2 has the poster', async ({ page, host }) => {
  await page.addInitScript(() => {
    for (const Canvas of [HTMLCanvasElement, OffscreenCanvas]) Canvas.prototype.getContext = () => null;
  });
  await host(failing('main'));
  expect(await failure(page)).toMatch(/^UnsupportedError: /);
  await expectPoster(page);
});

test('before it is an element, poster and fallback stand', async ({ page, host }) => {
  await host(failing('main'), { script: '' });
  await expect(page.locator('#poster')).toBeVisible();
  await expect(page.locator('#fallback')).toBeVisible();
});

test.describe('without JavaScript', () => {
  test.use({ javaScriptEnabled: false });

  test('poster and fallback stand, and nothing is fetched', async ({ page, host, server }) => {
    await host(failing('main'));
    await expect(page.locator('#poster')).toBeVisible();
    await expect(page.locator('#fallback')).toBeVisible();
    expect(server.sent).toEqual([]);
  });
});
