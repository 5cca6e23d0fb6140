import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, ballPlace, closeSheet, LAMP, LIGHT, open, type Point } from '../page.ts';

// Long enough for the ball to follow the pointer: after 20 steps its spring leaves 1/400 of the distance.
const arrive = (page: Page) => ask(page, (stage) => stage.step(20));

async function expectBallAt(page: Page, { x, y }: Point): Promise<void> {
  const ball = (await ballPlace(page))!;
  expect(Math.hypot(ball.x - x, ball.y - y), `ball at ${ball.x}, ${ball.y} instead of ${x}, ${y}`).toBeLessThan(12);
}

test('the mouse drags the ball and orbits the camera, and arrow keys move the ball', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await test.step('beside the ball the mouse orbits the camera, and 0 resets it', async () => {
    await arrive(page);
    const hash = await ask(page, (stage) => stage.hash());
    const start = (await ballPlace(page))!;
    await page.mouse.move(60, 200);
    await page.mouse.down();
    await page.mouse.move(240, 150, { steps: 4 });
    await page.mouse.up();
    const orbited = (await ballPlace(page))!;
    expect(Math.hypot(orbited.x - start.x, orbited.y - start.y)).toBeGreaterThan(20);
    await page.keyboard.press('0');
    await expectBallAt(page, start);
    expect(await ask(page, (stage) => stage.hash())).toBe(hash);
  });
  await test.step('the mouse drags the ball in the simulation', async () => {
    await arrive(page);
    const start = (await ballPlace(page))!;
    await page.mouse.move(start.x, start.y);
    await page.mouse.down();
    await page.mouse.move(start.x - 90, start.y - 40, { steps: 4 });
    await page.mouse.up();
    await arrive(page);
    await expectBallAt(page, { x: start.x - 90, y: start.y - 40 });
  });
  await test.step('arrow keys move the ball along the picture', async () => {
    await arrive(page);
    const start = (await ballPlace(page))!;
    await page.keyboard.down('ArrowLeft');
    // A held key moves the ball by at most 9 cm per frame, and a busy machine draws few frames.
    await expect
      .poll(async () => {
        await arrive(page);
        return (await ballPlace(page))!.x;
      })
      .toBeLessThan(start.x - 30);
    await page.keyboard.up('ArrowLeft');
    await arrive(page);
    const left = (await ballPlace(page))!;
    expect(Math.abs(left.y - start.y)).toBeLessThan(12);
    await arrive(page);
    await expectBallAt(page, left);
  });
});

test('keys and the mouse blow into the smoke @long', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await test.step('B blows into the middle without a pointer and changes the smoke', async () => {
    await ask(page, (stage) => stage.step(60));
    await page.keyboard.press('b');
    const inputs = () => ask(page, (stage) => stage.take().inputs);
    await expect.poll(inputs).toBe(1);
    await ask(page, (stage) => stage.step(20));
    const blown = await ask(page, (stage) => stage.hash());
    await ask(page, (stage) => {
      stage.restart();
      stage.step(80);
    });
    expect(await ask(page, (stage) => stage.hash())).not.toBe(blown);
  });
  await test.step('Alt + drag beside the ball blows, and the take repeats it', async () => {
    const hashAt90 = () =>
      ask(page, async (stage) => {
        await stage.seek(1.5);
        return stage.hash();
      });
    const still = await hashAt90();
    await ask(page, (stage) => stage.seek(1));
    await page.mouse.move(340, 215);
    await page.keyboard.down('Alt');
    await page.mouse.down();
    await page.mouse.move(390, 205, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.up('Alt');
    expect(await ask(page, (stage) => stage.stats.inputs)).toBe(1);
    const blown = await hashAt90();
    expect(blown).not.toBe(still);
    await ask(page, (stage) => {
      const take = stage.take();
      stage.restart();
      stage.playTake(take);
    });
    expect(await hashAt90()).toBe(blown);
  });
});

test('keys play, step and open the help sheet, but leave typing alone', async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 540 });
  await open(page, `?paused=1${LIGHT}`);
  const steps = () => ask(page, (stage) => stage.stats.steps);
  await page.keyboard.press('.');
  expect(await steps()).toBe(1);
  await page.keyboard.press(' ');
  expect(await ask(page, (stage) => stage.playing)).toBe(true);
  await page.keyboard.press(' ');
  expect(await ask(page, (stage) => stage.playing)).toBe(false);
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog', { name: 'Play with smoke' })).toBeVisible();
  await expect(page.getByRole('heading', { name: 'Play with smoke' })).toBeInViewport();
  await closeSheet(page);
  await page.keyboard.press('r');
  expect(await steps()).toBe(0);
  await page.getByLabel('Puff size, exact value').focus();
  await page.keyboard.press('.');
  expect(await steps()).toBe(0);
  await page.getByLabel('Puff size, exact value').blur();
  await page.keyboard.press('p');
  await expect(page.getByRole('region', { name: 'Parameters' })).toBeHidden();
  await test.step('keys reach the page as soon as a sheet is closed, while its field keeps the focus until the next frame', async () => {
    await page.keyboard.press('c');
    const sheet = page.getByRole('dialog', { name: 'Capture the smoke' });
    await expect(sheet.getByLabel('Format')).toBeFocused();
    const focused = await sheet.evaluate((dialog: HTMLDialogElement) => {
      dialog.close();
      const { activeElement } = document;
      activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key: '?', bubbles: true }));
      return activeElement!.tagName;
    });
    expect(focused).toBe('SELECT');
    await expect(page.getByRole('heading', { name: 'Play with smoke' })).toBeVisible();
  });
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('fingers open the parameters, drag the ball and zoom', async ({ page }) => {
    await open(page, `?paused=1${LAMP}`);
    await test.step('the parameters open as a sheet and leave the smoke visible', async () => {
      const panel = page.getByRole('region', { name: 'Parameters' });
      await expect(panel).toBeHidden();
      await page.getByRole('button', { name: 'Parameters', exact: true }).tap();
      await expect(panel).toBeVisible();
      const sheet = (await panel.boundingBox())!;
      const canvas = (await page.locator('canvas').boundingBox())!;
      expect(canvas.y + canvas.height).toBeLessThanOrEqual(sheet.y + 1);
      expect(sheet.width).toBe(390);
      await page.getByRole('button', { name: 'Close the parameters' }).tap();
      await expect(panel).toBeHidden();
    });
    await test.step('a finger drags the ball', async () => {
      await arrive(page);
      const start = (await ballPlace(page))!;
      const session = await page.context().newCDPSession(page);
      const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: Point[]) =>
        session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
      await touch('touchStart', [start]);
      await touch('touchMove', [{ x: start.x - 30, y: start.y - 30 }]);
      await touch('touchMove', [{ x: start.x - 60, y: start.y - 60 }]);
      await touch('touchEnd', []);
      await arrive(page);
      await expectBallAt(page, { x: start.x - 60, y: start.y - 60 });
    });
    await test.step('two fingers zoom', async () => {
      await page.evaluate(() => {
        const { camera } = window.cartoonSmoke!;
        const zoom = camera.zoom;
        camera.zoom = (factor: number) => {
          document.body.dataset.zoom = String(Number(document.body.dataset.zoom ?? 1) * factor);
          zoom(factor);
        };
      });
      const session = await page.context().newCDPSession(page);
      const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: (Point & { id: number })[]) =>
        session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
      const pair = (gap: number) => [
        { x: 195, y: 120 - gap, id: 0 },
        { x: 195, y: 120 + gap, id: 1 },
      ];
      await touch('touchStart', pair(20));
      await touch('touchMove', pair(30));
      await touch('touchMove', pair(40));
      await touch('touchEnd', []);
      await expect.poll(() => page.evaluate(() => Number(document.body.dataset.zoom))).toBeCloseTo(2, 1);
    });
  });
});

test('V cycles through the debug views and names them @long', async ({ page }) => {
  await open(page, `?paused=1&t=1&view=unlit${LIGHT}`);
  await expect(page.getByText('Unlit: the colours in shadow.')).toBeVisible();
  await page.keyboard.press('v');
  await expect(page.getByText('Ink: black.')).toBeVisible();
  for (let press = 0; press < 6; ++press) await page.keyboard.press('v');
  expect(await ask(page, (stage) => stage.view)).toBeUndefined();
  await expect(page.locator('.legend')).toBeHidden();
});

test('smoke resumes after a sheet that is reopened at once, and its capture completes @long', async ({ page }) => {
  await open(page, LIGHT);
  await page.keyboard.press('c');
  const sheet = page.getByRole('dialog', { name: 'Capture the smoke' });
  await expect(sheet).toBeVisible();
  // After this frame the page has received the close event.
  await page.route(/\/png-/, async (route) => {
    await page.evaluate(() => new Promise(requestAnimationFrame));
    await route.continue();
  });
  await sheet.evaluate(async (dialog: HTMLDialogElement) => {
    dialog.close();
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'c', bubbles: true }));
    // Before the page receives the close event, which arrives with the next frame.
    while (!dialog.open) await Promise.resolve();
    dialog.querySelector('form')!.requestSubmit();
  });
  await expect(sheet.getByText('Saved air-')).toBeVisible();
  expect(await ask(page, (stage) => stage.playing)).toBe(false);
  await closeSheet(page);
  await expect.poll(() => ask(page, (stage) => stage.playing)).toBe(true);
});
