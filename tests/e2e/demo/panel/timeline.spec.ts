import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectValue, LIGHT, messagesOf, open, row, valueOf } from '../page.ts';
import { fingerOf } from '../touch.ts';

test.use({ viewport: { width: 1100, height: 800 } });

/** Two keyframes of the rate, two of the colour and a burst. */
const LANES = '600;emission.rate/60*40/240*100*e;style.smokeColor/0*ff0000/300*0000ff;burst/120*0*24';

const panel = (page: Page) => page.getByRole('region', { name: 'Timeline' });
const tool = (page: Page, name: string) => panel(page).getByRole('button', { name, exact: true });
const marks = (page: Page, lane: string) => panel(page).getByRole('slider', { name: lane, exact: true });
const diamond = (page: Page, key: string) => row(page, key).locator('.keyframe');
const said = (page: Page) => panel(page).getByRole('status');
const timeline = async (page: Page) => String(await valueOf(page, 'timeline'));

async function expectTimeline(page: Page, text: string): Promise<void> {
  await expectValue(page, 'timeline', text);
}

/** Waits until the stage is at a step of a second and has no seek to do. */
async function expectStep(page: Page, step: number): Promise<void> {
  await expect.poll(() => ask(page, ({ stats }) => Math.round(60 * stats.time))).toBe(step);
}

async function openTimeline(page: Page, address: string): Promise<void> {
  await open(page, address);
  await page.getByRole('button', { name: 'Timeline', exact: true }).click();
  await expect(panel(page)).toBeVisible();
}

/** Where a step of a lane is in the window; the ruler by default. */
async function placeOf(page: Page, step: number, lane = '.timeline-ruler'): Promise<{ x: number; y: number }> {
  const place = await page.evaluate(
    ([at, selector]) => {
      const scale = Number(document.querySelector<HTMLElement>('.timeline-sheet')!.style.getPropertyValue('--scale'));
      const { left } = document.querySelector('.timeline-ruler')!.getBoundingClientRect();
      const { top, height } = document.querySelector(selector)!.getBoundingClientRect();
      return { x: left + 22 + at * scale, y: top + height / 2 };
    },
    [step, lane] as const,
  );
  return place;
}

const laneOf = (key: string) => `[data-lane="${key}"] .timeline-track`;

async function drag(page: Page, key: string, from: number, to: number, modifier?: 'Alt'): Promise<void> {
  const [start, end] = [await placeOf(page, from, laneOf(key)), await placeOf(page, to, laneOf(key))];
  if (modifier) await page.keyboard.down(modifier);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move((start.x + end.x) / 2, start.y, { steps: 2 });
  await page.mouse.move(end.x, end.y);
  await page.mouse.up();
  if (modifier) await page.keyboard.up(modifier);
}

test('by mouse: diamonds beside controls set keyframes, which are dragged, snapped, copied and undone @long', async ({
  page,
}) => {
  await openTimeline(page, `?paused=1&t=1${LIGHT}`);
  await expect(panel(page).getByText('Nothing is animated yet.')).toBeVisible();
  await test.step('two keyframes', async () => {
    await diamond(page, 'emission.rate').click();
    await expectTimeline(page, '600;emission.rate/60*40*e');
    await expect(panel(page).getByText('Nothing is animated yet.')).toBeHidden();
    await expect(diamond(page, 'emission.rate')).toHaveAccessibleName('Remove the keyframe of Rate');
    const { x, y } = await placeOf(page, 120);
    await page.mouse.click(x, y);
    await expectStep(page, 120);
    await expect(diamond(page, 'emission.rate')).toHaveAccessibleName('Set a keyframe of Rate');
    await row(page, 'emission.rate').getByRole('spinbutton').fill('100');
    await diamond(page, 'emission.rate').click();
    await expectTimeline(page, '600;emission.rate/60*40*e/120*100*e');
  });
  await test.step('the controls follow the playhead', async () => {
    const { x, y } = await placeOf(page, 90);
    await page.mouse.click(x, y);
    await expectStep(page, 90);
    await expect(row(page, 'emission.rate').getByRole('spinbutton')).toHaveValue('70');
    expect(await ask(page, ({ shown }) => shown['emission.rate'])).toBe(70);
  });
  await test.step('what a hand changed before a keyframe was set does not hold', async () => {
    for (const [step, rate] of [
      [180, '20'],
      [150, '60'],
    ] as const) {
      const { x, y } = await placeOf(page, step);
      await page.mouse.click(x, y);
      await expectStep(page, step);
      const field = row(page, 'emission.rate').getByRole('spinbutton');
      if (step === 150) await expect(field).toHaveValue(rate);
      else await field.fill(rate);
      if (step !== 150) await diamond(page, 'emission.rate').click();
    }
    await page.keyboard.press('Control+z');
    await expectTimeline(page, '600;emission.rate/60*40*e/120*100*e');
  });
  await test.step('a drag is one undo step', async () => {
    await drag(page, 'emission.rate', 120, 240);
    await expectTimeline(page, '600;emission.rate/60*40*e/240*100*e');
    await page.keyboard.press('Control+z');
    await expectTimeline(page, '600;emission.rate/60*40*e/120*100*e');
    await page.keyboard.press('Control+Shift+z');
    await expectTimeline(page, '600;emission.rate/60*40*e/240*100*e');
  });
  await test.step('beats', async () => {
    await panel(page).getByLabel('Snap').selectOption('Beats');
    await panel(page).getByRole('spinbutton', { name: 'Beats per minute' }).fill('90');
    // A beat has 40 steps.
    await drag(page, 'emission.rate', 240, 299);
    await expectTimeline(page, '600;emission.rate/60*40*e/280*100*e');
    await panel(page).getByLabel('Snap').selectOption('60 fps');
  });
  await test.step('copies', async () => {
    await drag(page, 'emission.rate', 60, 120, 'Alt');
    await expectTimeline(page, '600;emission.rate/60*40*e/120*40*e/280*100*e');
    const { x, y } = await placeOf(page, 400, laneOf('emission.rate'));
    await page.mouse.dblclick(x, y);
    await expect.poll(() => timeline(page)).toMatch(/\/280\*100\*e\/(399|400|401)\*100\*e$/);
  });
  await test.step('what cannot be animated says why', async () => {
    await page.locator('summary', { hasText: 'Simulation' }).click();
    const capacity = diamond(page, 'simulation.maxParticles');
    await expect(capacity).toHaveAttribute(
      'title',
      /^Maximum particles has no keyframes\. .+ cannot change over time\.$/,
    );
    const before = await timeline(page);
    await capacity.press('Enter');
    await expect(said(page)).toHaveText(/^Maximum particles cannot be animated\./);
    await expectTimeline(page, before);
    await expect(diamond(page, 'timeline')).toHaveCount(0);
  });
});

test('by mouse: a box selects, easings and bursts are edited, and the end is dragged @long', async ({ page }) => {
  await openTimeline(page, `?paused=1${LIGHT}&timeline=${encodeURIComponent(LANES)}`);
  await test.step('a box over two lanes', async () => {
    const from = await placeOf(page, 200, laneOf('emission.rate'));
    const to = await placeOf(page, 330, laneOf('style.smokeColor'));
    await page.mouse.move(from.x, from.y - 10);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 3 });
    await page.mouse.up();
    await expect(said(page)).toHaveText('2 selected.');
    await expect(panel(page).getByRole('heading', { name: '2 keyframes' })).toBeVisible();
    await tool(page, 'Hold').click();
    await expect.poll(() => timeline(page)).toContain('240*100*h');
    await expect.poll(() => timeline(page)).toContain('300*0000ff*h');
    await page.keyboard.press('Control+z');
    await expectTimeline(page, LANES);
  });
  await test.step('the curve of an easing', async () => {
    await marks(page, 'Rate').first().click();
    await expect(tool(page, 'Linear')).toHaveAttribute('aria-pressed', 'true');
    await tool(page, 'Ease in').click();
    await expect.poll(() => timeline(page)).toContain('60*40*i/');
    const handle = panel(page).getByRole('button', { name: /^Handle 1/ });
    const { x, y, width, height } = (await handle.boundingBox())!;
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 20, y + height / 2 - 20, { steps: 3 });
    await page.mouse.up();
    await expect.poll(() => timeline(page)).toMatch(/60\*40\*0\.\d+,0\.\d+,1,1\//);
    const before = await timeline(page);
    await handle.press('ArrowUp');
    await expect.poll(() => timeline(page)).not.toBe(before);
    for (let undo = 0; undo < 3; undo++) await page.keyboard.press('Control+z');
    await expectTimeline(page, LANES);
  });
  await test.step('bursts', async () => {
    await drag(page, 'burst.0', 120, 180);
    await expect.poll(() => timeline(page)).toContain('burst/180*0*24');
    await panel(page).getByRole('spinbutton', { name: 'Puffs' }).fill('300');
    await expect.poll(() => timeline(page)).toContain('burst/180*0*300');
    await panel(page).getByRole('combobox', { name: 'Emitter' }).selectOption('Emitter 2');
    await expect.poll(() => timeline(page)).toContain('burst/180*1*300');
    await tool(page, 'Add a burst').click();
    await expect.poll(() => timeline(page)).toContain('burst/0*0*24/180*1*300');
  });
  await test.step('the end and the loop', async () => {
    const [start, end] = [await placeOf(page, 600), await placeOf(page, 480)];
    await page.mouse.move(start.x - 3, start.y);
    await page.mouse.down();
    await page.mouse.move(end.x - 3, end.y, { steps: 3 });
    await page.mouse.up();
    await expect.poll(() => timeline(page)).toMatch(/^4(79|80|81);/);
    await tool(page, 'Loop').click();
    await expect.poll(() => timeline(page)).toMatch(/^4(79|80|81)\*loop;/);
    await panel(page).getByRole('spinbutton', { name: 'Length' }).fill('5');
    await page.keyboard.press('Tab');
    await expect.poll(() => timeline(page)).toMatch(/^300\*loop;/);
  });
  await test.step('lanes go with their last keyframe, and with their button', async () => {
    await row(page, 'emission.rate').hover();
    await panel(page).getByRole('button', { name: 'Remove all of Rate' }).click();
    await expect.poll(() => timeline(page)).not.toContain('emission.rate');
    await panel(page).getByRole('button', { name: 'Smoke', exact: true }).click();
    await page.keyboard.press('Delete');
    await expect.poll(() => timeline(page)).toMatch(/^300\*loop;burst/);
  });
});

test('by keyboard: everything, with announcements, without faults and without shortcuts of the page', async ({
  page,
}) => {
  await open(page, `?paused=1${LIGHT}`);
  await page.keyboard.press('t');
  await expect(panel(page)).toBeVisible();
  const playhead = panel(page).getByRole('slider', { name: 'Playhead' });
  await expect(playhead).toBeFocused();
  await test.step('the playhead', async () => {
    await page.keyboard.press('Shift+ArrowRight');
    await expectStep(page, 60);
    await page.keyboard.press('ArrowRight');
    await expectStep(page, 61);
    await page.keyboard.press('Home');
    await expectStep(page, 0);
    await expect(playhead).toHaveAttribute('aria-valuetext', '0.00 s');
  });
  await test.step('keyframes', async () => {
    await diamond(page, 'emission.rate').press('Enter');
    await expectTimeline(page, '600;emission.rate/0*40*e');
    await expect(said(page)).toHaveText('Keyframe of Rate at 0.00 s.');
    await marks(page, 'Rate').focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('ArrowLeft');
    await expectTimeline(page, '600;emission.rate/61*40*e');
    await expect(marks(page, 'Rate')).toBeFocused();
    await expect(marks(page, 'Rate')).toHaveAttribute('aria-valuetext', '1.02 s, 40 particles/s, selected');
    await page.keyboard.press('k');
    await expectTimeline(page, '600;emission.rate/0*40*e/61*40*e');
    await expect(marks(page, 'Rate').first()).toBeFocused();
  });
  await test.step('values', async () => {
    await page.keyboard.press('Enter');
    const value = panel(page).getByRole('spinbutton', { name: 'Rate, exact value' });
    await expect(value).toBeFocused();
    await page.keyboard.type('80');
    await page.keyboard.press('Enter');
    await expectTimeline(page, '600;emission.rate/0*80*e/61*40*e');
  });
  await test.step('the focus goes from keyframe to keyframe', async () => {
    await marks(page, 'Rate').first().focus();
    await page.keyboard.press('PageDown');
    await expect(marks(page, 'Rate').nth(1)).toBeFocused();
    await page.keyboard.press('Home');
    await expect(marks(page, 'Rate').first()).toBeFocused();
    await page.keyboard.press('Shift+End');
    await expect(panel(page).getByRole('heading', { name: '2 keyframes' })).toBeVisible();
  });
  await test.step('the clipboard', async () => {
    await page.keyboard.press('Control+d');
    await expectTimeline(page, '600;emission.rate/0*80*e/61*40*e/91*80*e/152*40*e');
    await page.keyboard.press('Control+c');
    await expect(said(page)).toHaveText('2 copied.');
    await page.keyboard.press('Delete');
    await expectTimeline(page, '600;emission.rate/0*80*e/61*40*e');
    await playhead.focus();
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('Shift+ArrowRight');
    await expectStep(page, 120);
    await page.keyboard.press('Control+v');
    await expectTimeline(page, '600;emission.rate/0*80*e/61*40*e/120*80*e/181*40*e');
    await page.keyboard.press('Control+z');
    await expectTimeline(page, '600;emission.rate/0*80*e/61*40*e');
    await page.keyboard.press('Control+a');
    await expect(said(page)).toHaveText('2 selected.');
  });
  await test.step('axe finds nothing', async () => {
    const { violations } = await new AxeBuilder({ page })
      .options({ resultTypes: ['violations'] })
      .setLegacyMode()
      .analyze();
    expect(violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${String(target)}`))).toEqual([]);
  });
  await test.step('it closes, and keeps the timeline', async () => {
    await tool(page, 'Close the timeline').press('Enter');
    await expect(panel(page)).toBeHidden();
    await expect(page.getByRole('button', { name: 'Timeline', exact: true })).toBeFocused();
    await expectTimeline(page, '600;emission.rate/0*80*e/61*40*e');
    // The keys did nothing else.
    expect(await valueOf(page, 'camera.azimuth')).toBeUndefined();
  });
});

test('recording makes keyframes of changes, one undo step for a gesture', async ({ page }) => {
  const messages = await openWithMessages(page);
  await tool(page, 'Record').first().click();
  await expect(said(page)).toHaveText('Recording. Changes of parameters become keyframes.');
  await test.step('while paused', async () => {
    await row(page, 'style.smokeColor').locator('input').fill('#ff0000');
    const before = String(await valueOf(page, 'style.smokeColor'));
    await expectTimeline(page, `600;style.smokeColor/0*${before.slice(1)}*e/60*ff0000*e`);
    await expectValue(page, 'style.smokeColor', before);
  });
  await test.step('while playing', async () => {
    const before = await timeline(page);
    const slider = row(page, 'emission.rate').getByRole('slider');
    await slider.scrollIntoViewIfNeeded();
    const { x, y, width, height } = (await slider.boundingBox())!;
    await page.mouse.move(x + width / 4, y + height / 2);
    await page.evaluate(() => window.cartoonSmoke!.play());
    await page.mouse.down();
    for (let at = 0; at < 6; at++) {
      const { steps } = await ask(page, ({ stats }) => stats);
      await page.mouse.move(x + width / 4 + 10 * at, y + height / 2);
      await expect.poll(() => ask(page, ({ stats }) => stats.steps)).toBeGreaterThan(steps + 2);
    }
    await page.mouse.up();
    await page.evaluate(() => window.cartoonSmoke!.pause());
    await expect.poll(() => timeline(page)).toMatch(/emission\.rate(\/\d+\*[\d.]+(\*e)?){3,}/);
    await expectValue(page, 'emission.rate', 40);
    await page.keyboard.press('Control+z');
    await expectTimeline(page, before);
  });
  await test.step('the camera', async () => {
    await page.locator('#smoke').focus();
    await page.keyboard.press('Shift+ArrowRight');
    await expect.poll(() => timeline(page)).toMatch(/camera\.azimuth\/0\*[\d.-]+\*e\/\d+\*[\d.-]+\*e/);
    await expectValue(page, 'camera.azimuth', undefined);
    const [, first, last] = /azimuth\/0\*([\d.-]+)\*e\/\d+\*([\d.-]+)/.exec(await timeline(page))!;
    const azimuth = () => ask(page, ({ shown }) => shown['camera.azimuth']);
    await expect.poll(azimuth).toBe(Number(last));
    const { x, y } = await placeOf(page, 0);
    await page.mouse.click(x, y);
    await expect.poll(azimuth).toBe(Number(first));
  });
  await tool(page, 'Record').first().click();
  const before = await timeline(page);
  await row(page, 'emission.lifetime').getByRole('spinbutton').fill('3');
  await expectValue(page, 'emission.lifetime', 3);
  await expectTimeline(page, before);
  // A slow machine is reported.
  expect((await messages()).filter((message) => !message.includes('machine is slow'))).toEqual([]);
});

async function openWithMessages(page: Page): Promise<() => Promise<string[]>> {
  await openTimeline(page, `?paused=1&t=1${LIGHT}`);
  return messagesOf(page);
}

test('a smoke with a timeline shows what it animates, and the search finds the timeline @long', async ({ page }) => {
  const fetched: string[] = [];
  page.on('request', (request) => fetched.push(request.url()));
  const own = () => fetched.filter((url) => /assets\/panel-[^/]+\.js$/.test(url));
  await test.step('without one, its code is not fetched', async () => {
    await open(page, `?paused=1${LIGHT}`);
    expect(own()).toEqual([]);
    await expect(page.locator('.keyframe')).toHaveCount(0);
  });
  await open(page, `?paused=1&t=2${LIGHT}&timeline=${encodeURIComponent(LANES)}`);
  await expect(diamond(page, 'emission.rate')).toBeVisible();
  await expect(row(page, 'emission.rate').getByRole('spinbutton')).toHaveValue('60');
  await expect(diamond(page, 'emission.lifetime')).toBeHidden();
  expect(own()).toHaveLength(1);
  for (const word of ['keyframe', 'animate', 'timeline', 'driver', 'midi']) {
    await page.getByRole('searchbox', { name: 'Find a parameter' }).fill(word);
    await expect(page.getByRole('button', { name: 'Open the timeline' })).toBeVisible();
  }
  await page.getByRole('button', { name: 'Open the timeline' }).click();
  await expect(panel(page)).toBeVisible();
  await expect(marks(page, 'Rate')).toHaveCount(2);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('by touch: keyframes are dragged, lanes scroll, and targets are large', async ({ page }) => {
    await open(page, `?paused=1&t=1${LIGHT}&timeline=${encodeURIComponent(LANES)}`);
    await page.getByRole('button', { name: 'Timeline', exact: true }).tap();
    await expect(panel(page)).toBeVisible();
    const finger = await fingerOf(page);
    await test.step('a keyframe', async () => {
      await finger(
        await placeOf(page, 240, laneOf('emission.rate')),
        await placeOf(page, 360, laneOf('emission.rate')),
      );
      await expect.poll(() => timeline(page)).toMatch(/emission\.rate\/60\*40\/3(58|59|60|61|62)\*100\*e/);
      await expect(panel(page).getByRole('heading', { name: /^Rate/ })).toBeVisible();
    });
    await test.step('an empty lane scrolls and keeps the keyframes', async () => {
      const before = await timeline(page);
      await tool(page, 'Zoom in').tap();
      await tool(page, 'Zoom in').tap();
      const scrolled = () => page.evaluate(() => document.querySelector('.timeline-scroll')!.scrollLeft);
      const from = await scrolled();
      const { y } = await placeOf(page, 0, laneOf('emission.rate'));
      await finger({ x: 330, y }, { x: 200, y });
      await expect.poll(scrolled).toBeGreaterThan(from + 60);
      await expectTimeline(page, before);
      await tool(page, 'Show all').tap();
    });
    await test.step('two fingers zoom', async () => {
      const scale = () =>
        page.evaluate(() =>
          Number(document.querySelector<HTMLElement>('.timeline-sheet')!.style.getPropertyValue('--scale')),
        );
      const before = await scale();
      const { y } = await placeOf(page, 0, laneOf('emission.rate'));
      const session = await page.context().newCDPSession(page);
      const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...places: number[]) =>
        session.send('Input.dispatchTouchEvent', { type, touchPoints: places.map((x, id) => ({ x, y, id })) });
      await touch('touchStart', 200, 260);
      await touch('touchMove', 180, 280);
      await touch('touchMove', 150, 310);
      await touch('touchEnd');
      await expect.poll(scale).toBeGreaterThan(2 * before);
      await tool(page, 'Show all').tap();
      expect(await scale()).toBeCloseTo(before, 5);
    });
    await test.step('a box, when asked for', async () => {
      await tool(page, 'Select with a box').tap();
      const [from, to] = [
        await placeOf(page, 150, laneOf('emission.rate')),
        await placeOf(page, 420, laneOf('emission.rate')),
      ];
      await finger(from, { x: to.x, y: to.y + 40 });
      await expect(said(page)).toHaveText('2 selected.');
      await tool(page, 'Delete').tap();
      await expect.poll(() => timeline(page)).not.toContain('100*e');
      await tool(page, 'Select with a box').tap();
    });
    await test.step('targets', async () => {
      await marks(page, 'Rate').first().tap();
      const small = await panel(page).evaluate((section) =>
        [...section.querySelectorAll('button, select, input, [role=slider]')]
          .filter((element) => element.checkVisibility())
          .map((element) => ({
            name: element.getAttribute('aria-label') ?? element.textContent,
            box: element.getBoundingClientRect(),
          }))
          .filter(({ box }) => Math.min(box.width, box.height) < 44)
          .map(({ name, box }) => `${name} ${box.width} x ${box.height}`),
      );
      expect(small).toEqual([]);
    });
    await test.step('the diamonds of the panel', async () => {
      await page.getByRole('button', { name: 'Parameters', exact: true }).tap();
      await expect(panel(page)).toBeHidden();
      await diamond(page, 'emission.lifetime').tap();
      await expect.poll(() => timeline(page)).toContain('emission.lifetime/60*');
      await page.getByRole('button', { name: 'Close the parameters' }).tap();
      await expect(panel(page)).toBeVisible();
      await expect(marks(page, 'Lifetime')).toHaveCount(1);
    });
  });
});
