/** Malicious and malformed links: the page works, shows a notice, sends no requests and runs no code. */
import type { Page } from '@playwright/test';
import { pack, packBytes } from '../../../../src/parameters/packing.ts';
import { table } from '../../../../src/parameters/table.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, open } from '../page.ts';

test.use({ viewport: { width: 120, height: 90 } });

const SMALL = '#v=1&preset=air&emission.rate=20&puff.variations=1&simulation.maxParticles=100';
const SCRIPT = '"><img src=x onerror="window.ran=1"><script>window.ran=2</script>javascript:window.ran=3';
const script = encodeURIComponent(SCRIPT);
const texts = table.filter(({ kind, key }) => kind !== 'number' && kind !== 'integer' && !/^\w+\.[1-7]\./.test(key));

interface Hostile {
  name: string;
  link: string;
  /** A part of the notice. */
  notified: string;
}

async function hostileLinks(): Promise<Hostile[]> {
  const bomb = await pack('a'.repeat(20 * 1024 * 1024));
  const zeros = await packBytes(new Uint8Array(20 * 1024 * 1024));
  return [
    { name: '100 kB', link: `&${'x'.repeat(100_000)}`, notified: 'The link is too long' },
    { name: 'wrong base64', link: '&z=%%%!', notified: 'The link is damaged' },
    { name: 'a deflate bomb', link: `&z=${bomb}`, notified: 'The link is too long' },
    { name: 'a deflate bomb for a take', link: `&take=${zeros}`, notified: 'The moment in the link is damaged' },
    { name: 'prototype keys', link: '&__proto__=1&constructor=1&__proto__.ran=1&toString=1', notified: '“__proto__”' },
    { name: 'script in a key', link: `&${script}=1`, notified: 'There is no parameter' },
    { name: 'script in a preset', link: `&preset=${script}`, notified: 'There is no preset' },
    {
      name: 'script packed',
      link: `&z=${await pack(`preset=${SCRIPT}&scene=${SCRIPT}`)}`,
      notified: 'There is no preset',
    },
    { name: 'script as a take', link: `&take=${script}`, notified: 'The moment in the link is damaged' },
    { name: 'NaN', link: '&puff.size=NaN&seed=NaN&light.azimuth=-Infinity', notified: 'puff.size cannot be “NaN”' },
    { name: '1e308', link: '&puff.size=1e308&forces.wind.x=-1e308', notified: 'puff.size cannot be “1e308”' },
    { name: 'an unknown scene', link: '&scene=nowhere', notified: 'scene cannot be “nowhere”' },
  ];
}

/** Side effects of injected code. */
const traces = (page: Page) =>
  page.evaluate(() => ({
    ran: (window as { ran?: unknown }).ran ?? ({} as { ran?: unknown }).ran,
    title: document.title,
    untrusted: document.querySelectorAll('.notices img, .notices script, .panel script, .notices a').length,
  }));
const NOTHING = { ran: undefined, title: 'Cartoon Smoke', untrusted: 0 };

test('each leaves a running page and a notice, requests no other host and runs no script', async ({
  page,
  baseURL,
}) => {
  const links = await hostileLinks();
  const untrusted: string[] = [];
  page.on('request', (request) => request.url().startsWith(baseURL!) || untrusted.push(request.url()));
  page.on('dialog', (dialog) => untrusted.push(dialog.message()));
  await open(page, `?paused=1${SMALL}`);
  for (const { name, link, notified } of links) {
    await test.step(name, async () => {
      await page.evaluate((hash) => {
        document.querySelectorAll<HTMLElement>('.notice button').forEach((button) => button.click());
        location.hash = hash;
      }, `#v=1${link}&emission.rate=20&puff.variations=1&simulation.maxParticles=100`);
      await expect(page.locator('.notices')).toContainText(notified);
      const steps = await ask(page, (stage) => (stage.step(1), stage.stats.steps));
      expect(steps).toBeGreaterThan(0);
      expect(await traces(page)).toEqual(NOTHING);
    });
  }
  expect(untrusted).toEqual([]);
});

test('script in every text value does not change the values', async ({ page }) => {
  // One link for all cases: the page shows only the first few messages.
  await open(page, `?paused=1${SMALL}&${texts.map(({ key }) => `${key}=${script}`).join('&')}`);
  await expect(page.locator('.notices')).toContainText('more parts that could not be used');
  expect(await traces(page)).toEqual(NOTHING);
  const values = await ask(page, (stage) => stage.get());
  expect(Object.values(values).filter((value) => String(value).includes('ran'))).toEqual([]);
});

test('the worst links also work on a fresh page @long', async ({ page }) => {
  const [long, , bomb, zeros] = await hostileLinks();
  for (const { link, notified } of [long, bomb, zeros]) {
    await open(page, `?paused=1${SMALL}${link}`);
    await expect(page.locator('.notices')).toContainText(notified);
    expect(await ask(page, (stage) => (stage.step(1), stage.stats.steps))).toBe(1);
    expect(await traces(page)).toEqual(NOTHING);
  }
});
