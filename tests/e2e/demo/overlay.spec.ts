/** `overlay.html` over a stream, in Chromium with the flags of OBS: triggers, transparency, and no other host. */
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { expect, test } from '../../support/fixtures.ts';
import { requireTestServer } from '../../support/server.ts';
import { serveText, type TextSocket } from '../../support/textSocket.ts';

const OBS = [
  '--autoplay-policy=no-user-gesture-required',
  '--off-screen-rendering-enabled',
  '--disable-gpu-compositing',
];
const LINK = '#v=1&preset=air&emission.lifetime=0.3&simulation.maxParticles=300&puff.variations=1';
const { browser, flags } = await requireTestServer();

// A web socket that does not answer is an error on the console.
test.use({
  launchOptions: { executablePath: browser, args: [...flags, ...OBS] },
  allowed: /^error: WebSocket connection to 'ws:|Content Security Policy/,
});

/** Hosts of the requests and web sockets of a page, which grow while it is open. */
let hosts: Set<string>;
test.beforeEach(async ({ page }) => {
  hosts = new Set();
  page.on('request', (request) => hosts.add(new URL(request.url()).host));
  page.on('websocket', (socket) => hosts.add(new URL(socket.url()).host));
  await page.addInitScript(() => {
    const phases: string[] = [];
    Object.assign(window, { phases });
    // Records each change, so that no test depends on the moment at which it looks.
    const note = (records: MutationRecord[]) => {
      for (const { target } of records) phases.push(String((target as HTMLElement).dataset.phase));
    };
    new MutationObserver(note).observe(document, { subtree: true, attributeFilter: ['data-phase'] });
  });
});

const open = (page: Page, query: string) => page.goto(`/overlay.html?ui=1&${query}${LINK}`);
const phases = (page: Page) => page.evaluate(() => (window as unknown as { phases: string[] }).phases);
const ready = (page: Page) => expect(page.getByText(/^Ready\./)).toBeVisible();

/** Alpha of all pixels of a screenshot. */
async function alphas(page: Page): Promise<{ width: number; height: number; alpha: number[] }> {
  await page.evaluate(() => document.querySelector('#messages')!.remove());
  const { width, height, data } = PNG.sync.read(await page.screenshot({ omitBackground: true }));
  return { width, height, alpha: [...data].filter((_, at) => at % 4 === 3) };
}

/** Makes a page hear a message, also one from itself. */
const post = (page: Page, data: unknown) =>
  page.evaluate(async (given) => {
    const heard = new Promise((resolve) => addEventListener('message', resolve, { once: true }));
    postMessage(given, '*');
    await heard;
  }, data);

const TRIGGERS: Record<string, { query: string; wrong(page: Page): Promise<void>; right(page: Page): Promise<void> }> =
  {
    key: {
      query: 'trigger=key:F9',
      wrong: (page) => page.keyboard.press('F8'),
      right: (page) => page.keyboard.press('F9'),
    },
    'key of a letter': {
      query: 'trigger=key:S',
      wrong: (page) => page.keyboard.press('a'),
      right: (page) => page.keyboard.press('s'),
    },
    message: {
      query: 'trigger=message',
      wrong: (page) => post(page, { cartoonSmoke: 'connect' }),
      right: (page) => post(page, { cartoonSmoke: 'trigger' }),
    },
  };

for (const [name, { query, wrong, right }] of Object.entries(TRIGGERS)) {
  test(`a ${name} plays the smoke once, and nothing else does`, async ({ page, baseURL }) => {
    await open(page, `${query}&seconds=0.2`);
    await ready(page);
    await wrong(page);
    await right(page);
    await expect.poll(() => phases(page)).toEqual(['playing', 'waiting']);
    await right(page);
    await expect.poll(() => phases(page)).toEqual(['playing', 'waiting', 'playing', 'waiting']);
    const { alpha } = await alphas(page);
    expect(Math.max(...alpha)).toBe(0);
    expect([...hosts]).toEqual([new URL(baseURL!).host]);
  });
}

test('a local web socket plays the smoke once, also after its program has started again', async ({ page, baseURL }) => {
  let socket: TextSocket = await serveText();
  const { port } = socket;
  await open(page, `trigger=ws://127.0.0.1:${port}&seconds=0.2`);
  const connected = page.getByText(`Connected to ws://127.0.0.1:${port}/`);
  await expect(connected).toHaveCount(1);
  for (const text of ['other', '{"cartoonSmoke":"connect"}', 'trigger']) socket.send(text);
  await expect.poll(() => phases(page)).toEqual(['playing', 'waiting']);
  await socket.close();
  await expect(page.getByText('The next attempt is in 1 s.')).toHaveCount(1);
  socket = await serveText(port);
  await expect(connected).toHaveCount(2);
  socket.send('{"cartoonSmoke":"trigger"}');
  await expect.poll(() => phases(page)).toEqual(['playing', 'waiting', 'playing', 'waiting']);
  expect([...hosts].sort()).toEqual([new URL(baseURL!).host, `127.0.0.1:${port}`].sort());
  await socket.close();
});

test('refuses web sockets of other hosts, waits, and a key still plays', async ({ page, baseURL }) => {
  const addresses = ['ws://example.org:4455', 'ws://127.0.0.1@example.org', 'wss://127.0.0.1:4455', 'ws://192.168.0.2'];
  const triggers = addresses.map((address) => `trigger=${encodeURIComponent(address)}`).join('&');
  await open(page, `${triggers}&trigger=key:F9&seconds=600`);
  for (const address of addresses) await expect(page.getByText(`trigger cannot be “${address}”`)).toBeVisible();
  await ready(page);
  expect(await phases(page)).toEqual([]);
  await page.keyboard.press('F9');
  await expect.poll(() => phases(page)).toEqual(['playing']);
  expect([...hosts]).toEqual([new URL(baseURL!).host]);
});

test('its policy blocks other hosts', async ({ page }) => {
  await open(page, 'trigger=key:F9');
  await ready(page);
  await page.evaluate(() => {
    const blocked: string[] = [];
    Object.assign(window, { blocked });
    addEventListener('securitypolicyviolation', ({ blockedURI }) => blocked.push(blockedURI));
    for (const address of ['ws://example.org', 'ws://192.168.0.2']) new WebSocket(address);
    fetch('https://example.org').catch(() => undefined);
  });
  const blocked = () => page.evaluate(() => (window as unknown as { blocked: string[] }).blocked.toSorted());
  await expect.poll(blocked).toEqual(['https://example.org/', 'ws://192.168.0.2/', 'ws://example.org/']);
});

test.describe('without a trigger', () => {
  test.use({ deviceScaleFactor: 1 });

  test('it plays at once, transparent around the smoke, and says nothing', async ({ page }) => {
    await page.goto(`/overlay.html?t=2&bogus=1#v=1&preset=air&emission.rate=60&puff.variations=1&bogus=1`);
    await expect.poll(() => phases(page)).toEqual(['playing']);
    // It fades in.
    const canvas = page.locator('canvas');
    await canvas.evaluate((each) => Promise.all(each.getAnimations().map(({ finished }) => finished)));
    expect(await page.locator('body').innerText()).toBe('');
    const { width, height, alpha } = await alphas(page);
    const opaque = alpha.filter((each) => each === 255).length;
    expect(opaque).toBeGreaterThan(500);
    expect(opaque).toBeLessThan(0.2 * width * height);
    const border = alpha.filter((_, at) => at % width === 0 || at < width || at % width === width - 1);
    expect(Math.max(...border)).toBe(0);
  });
});
