import type { Page } from '@playwright/test';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { presetValues } from '../../../../src/parameters/presets.ts';
import { expect, scrollPage, stands, test } from '../../../support/embed.ts';
import { gpuKeepsUp } from '../../../support/gpuKeepsUp.ts';

const RATE = presetValues('air')['emission.rate'];
/** Smoke over a page of 600 x 450 pixels; 150 pixels are one metre. */
const AIR = `preset="air" simulation-max-particles="300" thread="main" transparent
  style="position: absolute; left: 20px; top: 10px; width: 600px; height: 450px"`;
const box = (id: string, left: number, top: number, width: number, height: number) =>
  `<button id="${id}" style="position: absolute; box-sizing: border-box; left: ${left}px; top: ${top}px; width: ${width}px; height: ${height}px"></button>`;

const NOTICES = `<script>
  window.notices = [];
  document.querySelector('cartoon-smoke').addEventListener('statechange', ({ detail }) => window.notices.push(...detail.notices));
</script>`;

function noticesOf(page: Page): Promise<string[]> {
  return page.evaluate(() => (Reflect.get(window, 'notices') as { message: string }[]).map(({ message }) => message));
}

type Numbers = Record<string, number | string | undefined>;

/** Whether smoke rises from each element of the page. */
async function risingOn(page: Page): Promise<boolean[]> {
  const values = (await page.locator('cartoon-smoke').evaluate((smoke: CartoonSmokeElement) => smoke.get())) as Numbers;
  return Object.keys(values)
    .filter((key) => /^emitters\.\d\.share$/.test(key))
    .map((key) => values[key] !== 0 && values['emission.rate'] !== 0);
}

test('boxes of the page have the same position in the smoke, and follow the page', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${AIR} paused collide="button"></cartoon-smoke>${box('a', 170, 85, 300, 75)}`);
  await stands(page);
  const values = () =>
    page.locator('cartoon-smoke').evaluate((smoke: CartoonSmokeElement) => smoke.get()) as Promise<Numbers>;
  const place = async () => {
    const now = await values();
    const names = ['position.x', 'position.y', 'halfExtents.x', 'halfExtents.y'];
    return names.map((name) => Number(now[`colliders.0.${name}`] ?? NaN).toFixed(2));
  };
  // The centre of the smoke is at (320, 235), that of the box at (320, 122.5).
  await expect.poll(place).toEqual(['0.00', '0.75', '1.00', '0.25']);
  await page.evaluate(() =>
    Object.assign(document.querySelector<HTMLElement>('#a')!.style, { left: '95px', top: '235px' }),
  );
  await expect.poll(place).toEqual(['-0.50', '-0.25', '1.00', '0.25']);
  await page.locator('cartoon-smoke').evaluate((smoke) => smoke.removeAttribute('collide'));
  await expect
    .poll(async () => Object.keys(await values()).filter((key) => /^(colliders|vortices)\./.test(key)))
    .toEqual([]);
});

test('fixed smoke follows boxes of a scrolling page: the nearest of many, with a notice', async ({
  page,
  openPage,
}) => {
  // One every 200 pixels, from 85 below the top; the centre of the smoke is at 235.
  const boxes = Array.from({ length: 12 }, (_, index) => box(`a${index}`, 170, 85 + 200 * index, 300, 75));
  await openPage(`<cartoon-smoke ${AIR.replace('absolute', 'fixed')} paused collide="button"></cartoon-smoke>
    ${boxes.join('')}<div style="height: 3000px"></div>${NOTICES}`);
  await stands(page);
  /** The indices of the boxes used as colliders, and of those with curl. */
  const followed = async (scrolled: number) => {
    const values = (await page
      .locator('cartoon-smoke')
      .evaluate((smoke: CartoonSmokeElement) => smoke.get())) as Numbers;
    const numbers = (list: string, below: number) =>
      [0, 1, 2, 3, 4, 5, 6, 7].map((item) => {
        const top = 235 - 150 * (Number(values[`${list}.${item}.position.y`]) + below) - 37.5;
        return Math.round(((top + scrolled - 85) / 200) * 100) / 100;
      });
    return { around: numbers('colliders', 0), curls: numbers('vortices', 0.125) };
  };
  const first = { around: [0, 1, 2, 3, 4, 5, 6, 7], curls: [0, 0, 1, 1, 2, 2, 3, 3] };
  await expect.poll(() => followed(0)).toEqual(first);
  await scrollPage(page, 1_000);
  const later = { around: [2, 3, 4, 5, 6, 7, 8, 9], curls: [4, 4, 5, 5, 6, 6, 7, 7] };
  await expect.poll(() => followed(1_000)).toEqual(later);
  expect(await noticesOf(page)).toEqual(['collide matches 12 elements; the nearest 8 are used.']);
});

test('a link to a moment has the boxes of the page from the first step, at the start or later', async ({
  page,
  openPage,
}) => {
  const [first, later] = ['?paused=1#preset=air', '?paused=1&t=3#preset=air'];
  const smoke = page.locator('cartoon-smoke');
  const show = async (link: string) => {
    await openPage(`${box('a', 170, 225, 300, 75)}${box('fire', 220, 420, 200, 10)}
      <cartoon-smoke ${AIR} src="${link}" collide="#a" emit-from="#fire"></cartoon-smoke>`);
    await stands(page);
  };
  const arrived = async () => {
    await expect
      .poll(() => smoke.evaluate(async (element: CartoonSmokeElement) => (await element.stats()).steps))
      .toBe(180);
    return smoke.evaluate((element: CartoonSmokeElement) => element.hash());
  };
  await show(first);
  await smoke.evaluate((element: CartoonSmokeElement, link) => (element.src = link), later);
  const hash = await arrived();
  await show(later);
  expect(await arrived()).toBe(hash);
});

test.describe('with all pixels', () => {
  test.use({ deviceScaleFactor: 1 });

  test('no smoke is drawn on a box of the page, and some is drawn around it', async ({ page, openPage }) => {
    await openPage(`<cartoon-smoke ${AIR} paused start="5" collide="button" emit-from="#fire"></cartoon-smoke>
      ${box('a', 260, 160, 120, 60)}<i id="fire" style="position: absolute; left: 300px; top: 420px; width: 40px; height: 10px"></i>`);
    await stands(page);
    const covered = await page.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement) => {
      const picture = await createImageBitmap(await smoke.picture());
      const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d')!;
      context.drawImage(picture, 0, 0);
      const share = (x: number, y: number, width: number, height: number) => {
        const { data } = context.getImageData(x, y, width, height);
        return data.filter((value, index) => index % 4 === 3 && value > 0).length / (width * height);
      };
      // Puffs may extend over its edge by their radius, but their centres may not.
      return { within: share(280, 175, 40, 10), below: share(200, 220, 200, 190) };
    });
    expect(covered.within).toBe(0);
    expect(covered.below).toBeGreaterThan(0.1);
  });

  test('transparent smoke shows the page by its alpha', async ({ page, openPage }) => {
    await openPage(
      `<cartoon-smoke preset="wisp" simulation-max-particles="300" thread="main" transparent paused start="4"
        style="position: absolute; inset: 0 auto auto 0; width: 200px; height: 150px"></cartoon-smoke>`,
      { style: 'body { background: rgb(40, 160, 90) } cartoon-smoke::part(button) { visibility: hidden }' },
    );
    await stands(page);
    const screenshot = await page.screenshot({ clip: { x: 0, y: 0, width: 200, height: 150 } });
    const report = await page.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement, shown) => {
      const read = async (blob: Blob) => {
        const picture = await createImageBitmap(blob, { premultiplyAlpha: 'none' });
        const context = new OffscreenCanvas(200, 150).getContext('2d')!;
        context.drawImage(picture, 0, 0);
        return context.getImageData(0, 0, 200, 150).data;
      };
      const bytes = Uint8Array.from(atob(shown), (letter) => letter.charCodeAt(0));
      const [own, seen] = [await read(await smoke.picture()), await read(new Blob([bytes]))];
      const behind = [40, 160, 90];
      const kinds = { clear: 0, solid: 0, between: 0, farthest: 0 };
      for (let pixel = 0; pixel < own.length; pixel += 4) {
        const alpha = own[pixel + 3] / 255;
        kinds[alpha === 0 ? 'clear' : alpha === 1 ? 'solid' : 'between'] += 1;
        for (let channel = 0; channel < 3; ++channel) {
          const expected = own[pixel + channel] * alpha + behind[channel] * (1 - alpha);
          kinds.farthest = Math.max(kinds.farthest, Math.abs(seen[pixel + channel] - expected));
        }
      }
      return kinds;
    }, screenshot.toString('base64'));
    for (const kind of ['clear', 'solid', 'between'] as const) expect(report[kind]).toBeGreaterThan(50);
    // Both pictures are rounded, and the separate one is unpremultiplied.
    expect(report.farthest).toBeLessThan(4);
  });
});

test('smoke rises from elements that are hovered or focused, and from no other', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${AIR} emit-from="button" emit-on="hover"></cartoon-smoke>
    ${box('a', 60, 380, 100, 40)}${box('b', 400, 380, 100, 40)}`);
  await stands(page);
  const smoke = page.locator('cartoon-smoke');
  const values = () => smoke.evaluate((element: CartoonSmokeElement) => element.get()) as Promise<Numbers>;
  const alive = async () => (await smoke.evaluate((element: CartoonSmokeElement) => element.stats())).alive;
  expect((await values())['emission.rate']).toBe(0);
  expect(await alive()).toBe(0);
  await page.hover('#b');
  await expect.poll(alive).toBeGreaterThan(2);
  expect(await values()).toMatchObject({ 'emitters.0.share': 0, 'emitters.1.share': 1, 'emission.rate': RATE });
  await page.mouse.move(320, 100);
  await expect.poll(async () => (await values())['emission.rate']).toBe(0);
  await page.focus('#a');
  await expect.poll(values).toMatchObject({ 'emitters.0.share': 1, 'emitters.1.share': 0, 'emission.rate': RATE });
});

test('smoke rises from an element that was hovered or focused before the smoke loaded @long', async ({
  page,
  openPage,
}) => {
  await openPage(`<cartoon-smoke ${AIR} paused emit-on="hover"></cartoon-smoke>
    ${['a', 'b', 'c'].map((id, index) => box(id, 60 + 170 * index, 380, 100, 40)).join('')}`);
  await stands(page);
  await page.focus('#a');
  await page.hover('#c');
  const smoke = page.locator('cartoon-smoke');
  await smoke.evaluate((element) => element.setAttribute('emit-from', 'button'));
  await expect.poll(() => risingOn(page)).toEqual([true, false, true]);
});

test('an element emits while it is hovered or focused; focus by a click does not count @long', async ({
  page,
  openPage,
}) => {
  await openPage(`${['a', 'b', 'c'].map((id, index) => box(id, 60 + 170 * index, 380, 100, 40)).join('')}
    <cartoon-smoke ${AIR} paused emit-from="button" emit-on="hover"></cartoon-smoke>`);
  await stands(page);
  const rises = expect.poll(() => risingOn(page));
  await page.hover('#b');
  await page.keyboard.press('Tab');
  await rises.toEqual([true, true, false]);
  await page.keyboard.press('Tab');
  await rises.toEqual([false, true, false]);
  await page.hover('#c');
  await rises.toEqual([false, true, true]);
  await page.hover('#b');
  await rises.toEqual([false, true, false]);
  await page.keyboard.press('Tab');
  await rises.toEqual([false, true, true]);
  await page.click('#a');
  await rises.toEqual([true, false, false]);
  await page.mouse.move(320, 100);
  await rises.toEqual([false, false, false]);
});

test.describe('by touch', () => {
  test.use({ hasTouch: true });

  test('a tap on a hover emitter emits for a moment @long', async ({ page, openPage }) => {
    await page.clock.install();
    await page.addInitScript(gpuKeepsUp);
    await openPage(`<cartoon-smoke ${AIR} emit-from="button" emit-on="hover"></cartoon-smoke>${box('a', 60, 380, 100, 40)}
      <script>document.querySelector('button').onclick = () => (window.clicked = true);</script>`);
    await stands(page);
    // From here on the test controls the clock and the smoke.
    await page.clock.pauseAt(await page.evaluate(() => Date.now() + 60_000));
    await page.tap('#a');
    // The last event of a tap.
    await page.waitForFunction(() => Reflect.get(window, 'clicked') === true);
    await page.clock.runFor(250);
    const alive = () =>
      page.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement) => (await smoke.stats()).alive);
    await expect.poll(alive).toBeGreaterThan(0);
    await page.clock.fastForward(1_000);
    await expect.poll(() => risingOn(page)).toEqual([false]);
  });
});

test('boxes of the page override attributes that change later, until they are removed', async ({ page, openPage }) => {
  await openPage(
    `<cartoon-smoke ${AIR} paused emit-from="#a" emit-on="hover"></cartoon-smoke>${box('a', 60, 380, 100, 40)}`,
  );
  await stands(page);
  const smoke = page.locator('cartoon-smoke');
  const values = () => smoke.evaluate((element: CartoonSmokeElement) => element.get()) as Promise<Numbers>;
  const before = await values();
  expect(before['emission.rate']).toBe(0);
  const changed = { emissionRate: 50, emitters0PositionX: 3, lightAzimuth: 12 };
  await smoke.evaluate((element, given) => Object.assign(element, given), changed);
  await expect.poll(values).toEqual({ ...before, 'light.azimuth': 12 });
  await smoke.evaluate((element) => element.removeAttribute('emit-from'));
  await expect.poll(values).toMatchObject({ 'emission.rate': 50, 'emitters.0.position.x': 3, 'light.azimuth': 12 });
});

test('collapsed elements are no obstacles @long', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${AIR} paused collide="h2"></cartoon-smoke>
    <details style="position: absolute; left: 170px; top: 85px"><summary>More</summary><h2>A headline</h2></details>`);
  await stands(page);
  const smoke = page.locator('cartoon-smoke');
  const obstacles = async () =>
    Object.keys(await smoke.evaluate((element: CartoonSmokeElement) => element.get())).filter((key) =>
      /^colliders\.\d\.shape/.test(key),
    );
  expect(await obstacles()).toEqual([]);
  await page.getByText('More').evaluate((summary) => summary.parentElement!.toggleAttribute('open', true));
  await expect.poll(obstacles).toEqual(['colliders.0.shape']);
});

test('a click emits smoke for a moment and reaches the element', async ({ page, openPage }) => {
  await page.clock.install();
  await page.addInitScript(gpuKeepsUp);
  await openPage(`<cartoon-smoke ${AIR} emit-from="button" emit-on="click"></cartoon-smoke>${box('a', 60, 380, 100, 40)}
    <script>document.querySelector('button').onclick = () => (window.clicked = true);</script>`);
  await stands(page);
  // From here on the test controls the clock and the smoke.
  await page.clock.pauseAt(await page.evaluate(() => Date.now() + 60_000));
  await page.click('#a');
  await page.clock.runFor(250);
  const alive = () =>
    page.locator('cartoon-smoke').evaluate(async (element: CartoonSmokeElement) => (await element.stats()).alive);
  const rate = () =>
    page
      .locator('cartoon-smoke')
      .evaluate(async (element: CartoonSmokeElement) => (await element.get())['emission.rate']);
  await expect.poll(alive).toBeGreaterThan(0);
  await page.clock.fastForward(1_000);
  await expect.poll(rate).toBe(0);
  expect(await page.evaluate(() => Reflect.get(window, 'clicked'))).toBe(true);
});

test('an invalid selector is reported and changes nothing', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${AIR} paused collide="!!"></cartoon-smoke>${NOTICES}`);
  await stands(page);
  expect((await noticesOf(page)).join()).toContain('takes a CSS selector');
});
