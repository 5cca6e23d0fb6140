/** Touch input on a phone that replaces keys and the second mouse button. */
import type { CDPSession, Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectValue, LIGHT, open, row, valueOf, type Point as Place } from '../page.ts';
import { fingerOf, fingersOf } from '../touch.ts';

test.use({ viewport: { width: 390, height: 600 }, hasTouch: true, isMobile: true });

const link = (page: Page) => page.evaluate(() => location.hash);
const openPanel = (page: Page) => page.getByRole('button', { name: 'Parameters', exact: true }).tap();

test('taps play, and a finger blows', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await test.step('taps step, play, pause, restart, slow down and open full screen', async () => {
    const bar = page.getByRole('group', { name: 'Playback' });
    const steps = () => ask(page, (stage) => stage.stats.steps);
    await bar.getByRole('button', { name: 'One step' }).tap();
    await expect.poll(steps).toBe(1);
    await bar.getByRole('button', { name: 'Play' }).tap();
    await expect.poll(steps).toBeGreaterThan(1);
    const isFull = () => page.evaluate(() => document.fullscreenElement !== null);
    await bar.getByRole('button', { name: 'Full screen' }).tap();
    await expect.poll(isFull).toBe(true);
    await bar.getByRole('button', { name: 'Pause' }).tap();
    await expect.poll(() => ask(page, (stage) => stage.playing)).toBe(false);
    await bar.getByRole('button', { name: 'Start over' }).tap();
    await expect.poll(steps).toBe(0);
    await bar.getByLabel('Speed').selectOption({ label: '½×' });
    expect(await ask(page, (stage) => stage.speed)).toBe(0.5);
    await bar.getByRole('button', { name: 'Full screen' }).tap();
    await expect.poll(isFull).toBe(false);
  });
  await test.step('a finger blows while the wind button is pressed, and orbits the camera otherwise', async () => {
    await ask(page, (stage) => stage.seek(1));
    const drag = await fingerOf(page);
    const [from, to] = [
      { x: 60, y: 120 },
      { x: 120, y: 100 },
    ];
    const wind = page.getByRole('button', { name: 'Blow into the smoke by dragging' });
    await wind.tap();
    await expect(wind).toHaveAttribute('aria-pressed', 'true');
    await drag(from, to);
    await expect.poll(() => ask(page, (stage) => stage.stats.inputs)).toBeGreaterThan(0);
    expect(await valueOf(page, 'camera.azimuth')).toBeUndefined();
    await wind.tap();
    await expect(wind).toHaveAttribute('aria-pressed', 'false');
    await drag(from, to);
    await expect.poll(() => valueOf(page, 'camera.azimuth')).not.toBeUndefined();
  });
});

test('a finger moves, chooses and resets in the panel @long', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await openPanel(page);
  await test.step('a finger moves a slider and a curve, undoes, redoes and resets', async () => {
    const drag = await fingerOf(page);
    const size = row(page, 'puff.size');
    await size.scrollIntoViewIfNeeded();
    const track = (await size.getByRole('slider').boundingBox())!;
    const middle = track.y + track.height / 2;
    await drag({ x: track.x + 0.64 * track.width, y: middle }, { x: track.x + track.width - 3, y: middle });
    await expectValue(page, 'puff.size', 4);
    await expect.poll(() => link(page)).toContain('puff.size=4');
    await page.getByRole('button', { name: 'Undo' }).tap();
    await expectValue(page, 'puff.size', 1);
    await page.getByRole('button', { name: 'Redo' }).tap();
    await expectValue(page, 'puff.size', 4);
    await size.getByRole('button', { name: 'Reset Puff size' }).tap();
    await expectValue(page, 'puff.size', 1);

    const density = row(page, 'emission.density');
    await density.locator('.curve-stop').last().scrollIntoViewIfNeeded();
    const before = await valueOf(page, 'emission.density');
    const stop = (await density.locator('.curve-stop').last().boundingBox())!;
    // Next to the stop, as an imprecise touch.
    const from = { x: stop.x - 4, y: stop.y + stop.height / 2 };
    await drag(from, { x: from.x, y: from.y - 40 });
    await expect.poll(() => valueOf(page, 'emission.density')).toMatch(/,1:\.\d+$/);
    expect(String(await valueOf(page, 'emission.density')).split(',')).toHaveLength(String(before).split(',').length);
    await page.getByRole('button', { name: 'Undo' }).tap();
    await expectValue(page, 'emission.density', before);
  });
  await test.step('the backdrop is chosen in the panel', async () => {
    await page.getByText('Debug views').tap();
    await page.getByLabel('View', { exact: true }).selectOption({ label: 'Depth' });
    expect(await ask(page, (stage) => stage.view)).toBe('depth');
    await expect(page.getByText('white is near, black is far')).toBeVisible();
    await page.keyboard.press('v');
    await expect(page.getByLabel('View', { exact: true })).toHaveValue('counts');
    const figures = page.getByRole('switch', { name: 'Statistics' });
    await figures.tap();
    await expect(page.getByRole('region', { name: 'Statistics' })).toContainText('alive');
    await page.keyboard.press('i');
    await expect(figures).not.toBeChecked();
  });
});

test.describe('a flow', () => {
  test.use({ viewport: { width: 390, height: 844 } });

  const brush = (page: Page) => page.getByRole('group', { name: 'Draw a flow' });
  const line = (page: Page) => brush(page).locator('svg path');
  const points = async (page: Page) =>
    ((await valueOf(page, 'flows.0.points')) as string | undefined)?.split(',').length ?? 0;
  const [FROM, TO] = [
    { x: 120, y: 420 },
    { x: 260, y: 330 },
  ];

  /** Opens the page with the brush. */
  async function begin(page: Page): Promise<CDPSession> {
    await open(page, `?paused=1&t=1${LIGHT}`);
    await page.keyboard.press('h');
    await page.getByRole('button', { name: 'Draw a flow' }).tap();
    await expect(brush(page)).toBeVisible();
    return page.context().newCDPSession(page);
  }

  /** Fingers on the screen, by their order. */
  const touch = (
    session: CDPSession,
    type: 'touchStart' | 'touchMove' | 'touchEnd' | 'touchCancel',
    ...places: Place[]
  ) => session.send('Input.dispatchTouchEvent', { type, touchPoints: places.map((place, id) => ({ ...place, id })) });
  const pen = (session: CDPSession, type: 'mousePressed' | 'mouseMoved' | 'mouseReleased', place: Place) =>
    session.send('Input.dispatchMouseEvent', {
      ...place,
      type,
      pointerType: 'pen',
      button: 'left',
      clickCount: 1,
      buttons: type === 'mouseReleased' ? 0 : 1,
    });

  test('is drawn by a finger', async ({ page }) => {
    await begin(page);
    await (
      await fingerOf(page)
    )(FROM, TO);
    await expect.poll(() => points(page)).toBeGreaterThan(1);
    await expect(brush(page)).toBeHidden();
    expect(await valueOf(page, 'camera.azimuth')).toBeUndefined();
  });

  test('is drawn by a pen while a hand rests on the screen', async ({ page }) => {
    const session = await begin(page);
    await touch(session, 'touchStart', { x: 300, y: 600 });
    await touch(session, 'touchMove', { x: 305, y: 590 });
    await expect(line(page)).toHaveAttribute('d', /^M300/);
    await pen(session, 'mousePressed', FROM);
    await touch(session, 'touchMove', { x: 310, y: 560 });
    await touch(session, 'touchStart', { x: 310, y: 560 }, { x: 350, y: 600 });
    await pen(session, 'mouseMoved', { x: 190, y: 400 });
    await pen(session, 'mouseMoved', TO);
    await expect(line(page)).toHaveAttribute('d', /^M120\.0 \d+\.\dL.*L260\.0 \d+\.\d$/);
    await pen(session, 'mouseReleased', TO);
    await expect.poll(() => points(page)).toBeGreaterThan(1);
    await touch(session, 'touchEnd');
    await expectValue(page, 'flows.1.points', undefined);
    expect(await valueOf(page, 'camera.distance')).toBeUndefined();
  });

  test('is not drawn by two fingers, which zoom, nor by the one that stays', async ({ page }) => {
    const session = await begin(page);
    const [one, two] = [FROM, { x: 200, y: 420 }];
    await touch(session, 'touchStart', one);
    await touch(session, 'touchMove', { x: 130, y: 400 });
    await expect(line(page)).not.toHaveAttribute('d', '');
    await touch(session, 'touchStart', { x: 130, y: 400 }, two);
    await expect(line(page)).toHaveAttribute('d', '');
    await touch(session, 'touchMove', { x: 130, y: 400 }, { x: 230, y: 420 });
    await touch(session, 'touchMove', { x: 130, y: 400 }, { x: 270, y: 420 });
    await expect.poll(() => valueOf(page, 'camera.distance')).not.toBeUndefined();
    await touch(session, 'touchEnd', { x: 130, y: 400 });
    await touch(session, 'touchMove', { x: 180, y: 300 });
    await touch(session, 'touchEnd');
    await expect(brush(page)).toBeVisible();
    await expect(line(page)).toHaveAttribute('d', '');
    await expectValue(page, 'flows.0.points', undefined);
    await (
      await fingersOf(page)
    )([100, 200], [80, 240]);
    await expectValue(page, 'flows.0.points', undefined);
    await (
      await fingerOf(page)
    )(FROM, TO);
    await expect.poll(() => points(page)).toBeGreaterThan(1);
  });

  for (const [how, lose] of [
    ['is cancelled', (session: CDPSession) => touch(session, 'touchCancel')],
    [
      'is lost',
      (_: CDPSession, page: Page) => page.evaluate(() => (window as unknown as { release(): void }).release()),
    ],
  ] as const) {
    test(`is discarded when its finger ${how}, and the next finger draws`, async ({ page }) => {
      const session = await begin(page);
      await brush(page).evaluate((element) => {
        (element as HTMLElement).addEventListener('pointerdown', ({ pointerId }) =>
          Object.assign(window, { release: () => element.releasePointerCapture(pointerId) }),
        );
      });
      await touch(session, 'touchStart', FROM);
      await touch(session, 'touchMove', TO);
      await expect(line(page)).not.toHaveAttribute('d', '');
      await lose(session, page);
      // Browsers report the loss with the next event of the finger.
      if (how === 'is lost') await touch(session, 'touchMove', FROM);
      await expect(line(page)).toHaveAttribute('d', '');
      if (how === 'is lost') await touch(session, 'touchEnd');
      await expect(brush(page)).toBeVisible();
      await expectValue(page, 'flows.0.points', undefined);
      await (
        await fingerOf(page)
      )(FROM, TO);
      await expect.poll(() => points(page)).toBeGreaterThan(1);
    });
  }
});
