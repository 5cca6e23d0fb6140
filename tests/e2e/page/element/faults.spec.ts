import type { Page } from '@playwright/test';
import { expect, stands, test, WISP } from '../../../support/embed.ts';
import { longIf } from '../../../support/fixtures.ts';

/** A page that handles failures of smoke from before the element's upgrade. */
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

// The browser logs error responses itself.
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
    const tag = longIf((thread === 'worker') !== (fault === 'missing'));
    test(`a simulator that is ${fault} leaves the poster and emits a LoadError: ${thread}${tag}`, async ({
      page,
      openPage,
    }) => {
      await provoke(page);
      await openPage(failing(thread));
      expect(await failure(page)).toMatch(/^LoadError: /);
      await expectPoster(page);
    });
  }
}

test('a simulator without data times out with a LoadError', async ({ page, openPage }) => {
  await page.clock.install();
  const asked = page.waitForRequest(WASM);
  // The request stays pending.
  await page.route(WASM, () => undefined);
  await openPage(failing('main'));
  await asked;
  await page.clock.runFor(61_000);
  expect(await failure(page)).toMatch(/^LoadError: .*no data for/);
  await expectPoster(page);
});

const THINGS = 'collide="p"';
/** Scripts that load before the first picture, and the attributes that make an element load them. */
const SCRIPTS = {
  'session.js': '',
  'stage.js': '',
  'wispPresets.js': '',
  'wisp.js': '',
  'core.js': '',
  'link.js': 'src="#preset=wisp"',
  'onPage.js': THINGS,
  'billboards.js': 'puff-form="billboards"',
};

for (const [file, rest] of Object.entries(SCRIPTS)) {
  const tag = longIf(!['stage.js', 'onPage.js'].includes(file));
  test(`without ${file} there is the poster and a LoadError: at once if it is rejected, else within a minute${tag}`, async ({
    page,
    openPage,
  }) => {
    await page.route(`**/dist/${file}`, (route) => route.abort());
    await openPage(failing('main', rest));
    expect(await failure(page)).toMatch(/^LoadError: /);
    await expectPoster(page);
    await page.unroute(`**/dist/${file}`);
    await page.clock.install();
    const asked = page.waitForRequest(`**/dist/${file}`);
    await page.route(`**/dist/${file}`, () => undefined);
    await openPage(failing('main', rest));
    await asked;
    // Some scripts are preloaded; their timeout starts later.
    const known = () =>
      page.evaluate(() => Promise.race([Reflect.get(window, 'failure') as Promise<string>, Promise.resolve('')]));
    const notified = expect.poll(() => page.clock.runFor(61_000).then(known));
    await notified.toMatch(/^LoadError: .*no data for 60 s/);
    await expectPoster(page);
  });
}

test('a file that arrives after its timeout is available to other smoke @long', async ({ page, openPage }) => {
  await page.clock.install();
  const asked = page.waitForRequest('**/dist/stage.js');
  let answer = () => Promise.resolve();
  await page.route('**/dist/stage.js', (route) => void (answer = () => route.continue()));
  await openPage(failing('main'));
  await asked;
  await page.clock.runFor(61_000);
  await failure(page);
  await answer();
  const link = '#preset=wisp&simulation.maxParticles=300&puff.variations=1';
  await page.evaluate((src) => document.querySelector('cartoon-smoke')!.setAttribute('src', src), link);
  await stands(page);
  await expect(page.locator('#poster')).toBeHidden();
});

test('a worker without a script times out after 30 s, and smoke falls back to the main thread', async ({
  page,
  openPage,
}) => {
  await page.clock.install();
  await page.context().route('**/dist/worker.js', () => undefined);
  const asked = page.waitForRequest('**/dist/worker.js');
  await openPage(`${failing('worker')}<cartoon-smoke id="auto" ${WISP.replace('main', 'auto')}></cartoon-smoke>`);
  await asked;
  await page.clock.runFor(31_000);
  expect(await failure(page)).toMatch(/^LoadError: .*did not answer/);
  await stands(page, '#auto');
});

test('smoke works without the code of gestures and reports it', async ({ page, openPage }) => {
  await page.route('**/pointers.js', (route) => route.abort());
  await openPage(`${failing('main', 'interactive paused simulation-max-particles="300"')}<script>
    window.notices = [];
    document.querySelector('cartoon-smoke').addEventListener('statechange', ({ detail }) => window.notices.push(...detail.notices));
  </script>`);
  await stands(page);
  const notices = await page.evaluate(() => Reflect.get(window, 'notices') as { message: string }[]);
  expect(notices.map(({ message }) => message)).toEqual([expect.stringContaining('pointers.js')]);
});

test('a page whose policy forbids WebAssembly has the poster', async ({ page, openPage }) => {
  const rules = "script-src 'self' 'unsafe-inline'; worker-src 'self'";
  await openPage(failing('main'), { headers: { 'content-security-policy': rules } });
  expect(await failure(page)).toMatch(/^(LoadError|UnsupportedError): /);
  await expectPoster(page);
});

test('a browser without WebGL 2 has the poster', async ({ page, openPage }) => {
  await page.addInitScript(() => {
    for (const Canvas of [HTMLCanvasElement, OffscreenCanvas]) Canvas.prototype.getContext = () => null;
  });
  await openPage(failing('main'));
  expect(await failure(page)).toMatch(/^UnsupportedError: /);
  await expectPoster(page);
});

test('before the element is defined, poster and fallback are visible', async ({ page, openPage }) => {
  await openPage(failing('main'), { script: '' });
  await expect(page.locator('#poster')).toBeVisible();
  await expect(page.locator('#fallback')).toBeVisible();
});

test.describe('without JavaScript', () => {
  test.use({ javaScriptEnabled: false });

  test('poster and fallback are visible, and nothing is downloaded', async ({ page, openPage, server }) => {
    await openPage(failing('main'));
    await expect(page.locator('#poster')).toBeVisible();
    await expect(page.locator('#fallback')).toBeVisible();
    expect(server.sent).toEqual([]);
  });
});

/** What older browsers lack, of what the package or its dependencies use, and the versions from which they have it. */
const LACKING: Record<string, string> = {
  'Array.prototype.at': 'Chrome 92, Safari 15.4',
  'Object.hasOwn': 'Chrome 93, Safari 15.4',
  'Array.prototype.findLastIndex': 'Chrome 97, Firefox 104',
  'AbortSignal.prototype.throwIfAborted': 'Chrome 100, Firefox 97',
  'Document.prototype.adoptedStyleSheets': 'and new CSSStyleSheet(), Firefox 101, Safari 16.4',
  'URL.canParse': 'Chrome 120, Firefox 115',
  'Array.prototype.toSorted': 'Chrome 110, Firefox 115',
  DecompressionStream: 'Firefox 113, Safari 16.4',
  structuredClone: 'Chrome 98, Firefox 94',
  WebGL2RenderingContext: 'Safari 15',
  WebAssembly: 'Safari 11',
  OffscreenCanvas: 'Firefox 105, Safari 16.4',
  IntersectionObserver: 'Safari 12.1',
  ResizeObserver: 'Safari 13.1',
};

/** One of the language, one that the self-test needs and one that has a fallback. */
const TRIED = ['Array.prototype.at', 'WebAssembly', 'OffscreenCanvas'];

for (const [feature, since] of Object.entries(LACKING)) {
  const tag = longIf(!TRIED.includes(feature));
  test(`in a browser without ${feature} (${since}), the page has its content or the smoke, and no error${tag}`, async ({
    page,
    openPage,
  }) => {
    await page.addInitScript((path) => {
      const names = path.split('.');
      const last = names.pop()!;
      const owner: object = names.reduce((each, name) => Reflect.get(each, name) as object, window as object);
      Reflect.deleteProperty(owner, last);
      if (last !== 'adoptedStyleSheets') return;
      Reflect.deleteProperty(ShadowRoot.prototype, last);
      window.CSSStyleSheet = function () {
        throw new TypeError('Illegal constructor');
      } as never;
    }, feature);
    await openPage(failing('auto', 'simulation-max-particles="300" loading="eager"'));
    await page.waitForFunction(() => document.readyState === 'complete');
    const showsSmoke = await page.evaluate(async () => {
      const element = document.querySelector('cartoon-smoke') as HTMLElement & { ready?: Promise<void> };
      await element.ready?.catch(() => undefined);
      return Boolean(element.shadowRoot?.querySelector('.shown'));
    });
    if (!showsSmoke) await expectPoster(page);
  });
}
