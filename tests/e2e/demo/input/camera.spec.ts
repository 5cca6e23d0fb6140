/** The link contains the camera and restores its view. */
import type { Page } from '@playwright/test';
import { table } from '../../../../src/parameters/table.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { QUIET_MS } from '../../../../src/demo/editor/editor.ts';
import { ask, expectHash, expectSteps, expectValue, LAMP, LIGHT, open } from '../page.ts';
import { fingerOf, mouseOf } from '../touch.ts';

test.use({ viewport: { width: 400, height: 300 } });

/** Two positions without ball or control. */
const NOWHERE = { x: 40, y: 110 };
const BESIDE = { x: 110, y: 90 };

/** View-dependent parts of the picture: projected points of the scene, and all pixels. */
const viewOf = (page: Page) =>
  ask(page, async (stage) => ({
    places: [stage.sight.project([0, 1, 0]), stage.sight.project([0.5, 1.5, 0.5])],
    picture: [...new Uint8Array(await (await stage.picture()).arrayBuffer())].join(),
  }));

const eyeOf = (page: Page) =>
  ask(page, (stage) => Object.fromEntries(Object.entries(stage.get()).filter(([key]) => key.startsWith('camera.'))));

/** Waits until the address bar contains the camera. @param before rest of the address @returns its hash */
async function expectLink(page: Page, before = LIGHT): Promise<string> {
  const eye = await eyeOf(page);
  const held = table.filter(({ key }) => key in eye);
  const pairs = held.map(({ key }) => `&${key}=${eye[key]}`);
  const hash = before.replace('&simulation', `${pairs.join('')}&simulation`);
  await expectHash(page, hash);
  return hash;
}

/**
 * Three wheel events or key presses without delay, as on a fast machine. Resolves when the page considers the gesture
 * complete: of two timers with the same delay, the later one fires later. The address bar does not show this, because
 * its timer is the earlier one.
 */
const burst = (page: Page, type: 'wheel' | 'keydown', detail: object) =>
  page.evaluate(
    async ([name, given, quiet]) => {
      const kinds = { wheel: WheelEvent, keydown: KeyboardEvent };
      for (let round = 0; round < 3; ++round) {
        const event = new kinds[name](name, { ...given, bubbles: true, cancelable: true });
        document.querySelector('canvas')!.dispatchEvent(event);
      }
      await new Promise((end) => setTimeout(end, quiet));
    },
    [type, detail, QUIET_MS] as const,
  );

test('orbit, pan and zoom are stored in the link, and a second page has the same view', async ({ page, context }) => {
  await open(page, `?paused=1&t=1${LIGHT}`);
  await expectSteps(page, 60);
  const first = await viewOf(page);
  await mouseOf(page)(NOWHERE, BESIDE);
  await page.keyboard.down('Shift');
  await mouseOf(page)(NOWHERE, { x: 60, y: 100 });
  await page.keyboard.up('Shift');
  await page.mouse.wheel(0, -200);
  await expect.poll(() => eyeOf(page).then(Object.keys)).toHaveLength(6);
  const view = await viewOf(page);
  expect(view.places).not.toEqual(first.places);
  const other = await context.newPage();
  await open(other, `?paused=1&t=1${await expectLink(page)}`);
  await expectSteps(other, 60);
  expect(await eyeOf(other)).toEqual(await eyeOf(page));
  expect(await viewOf(other)).toEqual(view);
  await expect(other.locator('.notice')).toHaveCount(0);
});

test('a gesture is undone in one step, and presets of a scene keep the view @long', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await test.step('a gesture is undone in one step, by mouse, wheel and keys', async () => {
    const gestures = [
      () => mouseOf(page)(NOWHERE, BESIDE),
      () => burst(page, 'wheel', { deltaY: 60 }),
      () => burst(page, 'keydown', { key: 'ArrowRight', shiftKey: true }),
      () => page.keyboard.press('0'),
    ];
    const eyes = [await eyeOf(page)];
    for (const gesture of gestures) {
      await gesture();
      await expect.poll(() => eyeOf(page)).not.toEqual(eyes.at(-1));
      await expectLink(page, LAMP);
      eyes.push(await eyeOf(page));
    }
    expect(eyes.at(-1)).toEqual({});
    for (const eye of eyes.slice(0, -1).toReversed()) {
      await page.keyboard.press('Control+z');
      await expect.poll(() => eyeOf(page)).toEqual(eye);
    }
    await expectHash(page, LAMP);
    await page.keyboard.press('Control+Shift+z');
    await expect.poll(() => eyeOf(page)).toEqual(eyes[1]);
  });
  await test.step('presets of a scene keep the camera; another scene has its own', async () => {
    await ask(page, (stage) => stage.set({ 'camera.azimuth': 90, 'camera.elevation': 0 }));
    const [x, ahead] = await ask(page, (stage) => [stage.sight.along([0, 0, 1])[0], stage.camera.azimuth()]);
    expect(x).toBeCloseTo(1, 6);
    expect(ahead).toBeCloseTo(Math.PI / 2, 6);
    await page.keyboard.press('g');
    await page.getByRole('radio', { name: 'Noir' }).check();
    await expectHash(page, '#v=1&preset=lamp-noir&camera.azimuth=90&camera.elevation=0');
    await page.getByRole('radio', { name: 'Cup of tea' }).check();
    await expectValue(page, 'scene', 'wisp');
    await expectHash(page, '#v=1&preset=wisp');
    expect(await eyeOf(page)).toEqual({});
  });
});

test('a camera moved while an edit is pending is stored in the same link @long', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const { edited, orbited } = await page.evaluate(() => {
    const stage = window.cartoonSmoke!;
    const size = document.querySelector<HTMLInputElement>('[data-key="puff.size"] input[type=number]')!;
    size.value = '2';
    size.dispatchEvent(new Event('input'));
    stage.camera.orbit(0.5, 0);
    return { edited: stage.get()['puff.size'], orbited: 'camera.azimuth' in stage.get() };
  });
  expect([edited, orbited]).toEqual([1, true]);
  await expectLink(page, LIGHT.replace('&puff', '&puff.size=2&puff'));
  await expectValue(page, 'puff.size', 2);
});

test('a link to this moment shows the same frame, with the same camera @long', async ({ page, browser }) => {
  await open(page, `?paused=1${LIGHT}`);
  await ask(page, (stage) => stage.set({ 'camera.distance': 9 }));
  await ask(page, (stage) => stage.blow({ x: 150, y: 120, dx: 9, dy: -4 }));
  await ask(page, (stage) => stage.step(40));
  await page.keyboard.press('0');
  await mouseOf(page)(NOWHERE, BESIDE);
  expect(Object.keys(await eyeOf(page))).toEqual(['camera.azimuth', 'camera.elevation']);
  const view = await viewOf(page);
  const sheet = page.getByRole('dialog', { name: 'Share this smoke' });
  await page.keyboard.press('s');
  await expect(sheet.getByRole('button', { name: 'Copy link' })).toBeFocused();
  await sheet.getByRole('radio', { name: 'This moment' }).check();
  const link = await sheet.getByLabel('Link to this smoke').inputValue();
  expect(link).toContain('take=');
  const context = await browser.newContext({ viewport: { width: 400, height: 300 } });
  const other = await context.newPage();
  await open(other, link.slice(link.indexOf('/?') + 1));
  await expectSteps(other, 40);
  expect(await eyeOf(other)).toEqual(await eyeOf(page));
  expect(await viewOf(other)).toEqual(view);
  await context.close();
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a finger orbits the camera, stored in the link as one step @long', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    const drag = await fingerOf(page);
    await drag({ x: 60, y: 500 }, { x: 140, y: 480 });
    await expect.poll(() => eyeOf(page).then(Object.keys)).toEqual(['camera.azimuth', 'camera.elevation']);
    await expectLink(page);
    await page.keyboard.press('Control+z');
    await expectHash(page, LIGHT);
  });
});
