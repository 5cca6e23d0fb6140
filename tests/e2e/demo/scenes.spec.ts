import type { Page } from '@playwright/test';
import { expect, test } from '../../support/fixtures.ts';
import { sceneEntries } from '../../../src/scenes/scenes.ts';
import { ask, ballPlace, closeSheet, expectHash, expectValue, hold, open, type Point } from './page.ts';
import { doubleTap, fingerOf } from './touch.ts';

test.use({ viewport: { width: 480, height: 320 } });

/** Little smoke of one shape, which is cheap to draw with SwiftShader and to bake. */
const LIGHT = '&emission.rate=20&puff.variations=1&simulation.maxParticles=300';

/** URLs that the page requests from here on. */
function fetched(page: Page): string[] {
  const addresses: string[] = [];
  page.on('request', (request) => addresses.push(new URL(request.url()).pathname));
  return addresses;
}

test('a scene loads only what it needs: no physics and no other scene for the cup of tea', async ({ page }) => {
  const addresses = fetched(page);
  await open(page, `?paused=1#v=1&preset=wisp${LIGHT}`);
  const without = await wasmBytes(page, addresses);
  const others = Object.keys(sceneEntries).filter((name) => name !== 'wisp');
  const named = (name: string) => addresses.some((address) => new RegExp(`/${name}\\b[^/]*\\.[jt]s$`).test(address));
  expect(named('wisp')).toBe(true);
  expect(others.filter(named)).toEqual([]);
  addresses.length = 0;
  await ask(page, (stage) => stage.enter({ scene: 'train', 'simulation.maxParticles': 300 }));
  expect(await wasmBytes(page, addresses)).toBeGreaterThan(2 * without);
});

/** Size of the only WASM module among these URLs, bytes. */
async function wasmBytes(page: Page, addresses: readonly string[]): Promise<number> {
  const wasm = [...new Set(addresses.filter((address) => address.endsWith('.wasm')))];
  expect(wasm).toHaveLength(1);
  return page.evaluate(async (address) => (await (await fetch(address)).arrayBuffer()).byteLength, wasm[0]);
}

/** Selects a preset in the gallery, which is collapsed in low windows. */
async function choose(page: Page, preset: string): Promise<void> {
  await page.locator('label', { has: page.locator(`input[name=preset][value=${preset}]`) }).click();
}

// Console errors fail every test.
test('the gallery opens scenes with and without physics, and each of them smokes', async ({ page }) => {
  await open(page, `?paused=1#v=1&preset=wisp${LIGHT}`);
  await page.keyboard.press('g');
  for (const scene of ['rocket', 'cloudscape', 'dust']) {
    await choose(page, scene);
    const shown = () => ask(page, (stage) => [stage.get().scene, stage.stats.steps]);
    await expect.poll(shown).toEqual([scene, 0]);
    await ask(page, (stage) => stage.seek(1.5));
    expect(await ask(page, (stage) => stage.stats.bodiesDrawn), scene).toBeGreaterThan(0);
    await expect(page.getByRole('button', { name: 'Drop a ball' })).toBeVisible({
      visible: sceneEntries[scene].hasRigids,
    });
  }
});

test('keys steer the airplane, and its take repeats the flight', async ({ page }) => {
  await open(page, `?paused=1#v=1&preset=airplane${LIGHT}`);
  await ask(page, (stage) => stage.step(10));
  const unsteered = await ask(page, async (stage) => {
    await stage.seek(1);
    return stage.hash();
  });
  await ask(page, (stage) => stage.seek(0.2));
  await page.keyboard.press('ArrowUp');
  const hashes = await ask(page, async (stage) => {
    await stage.seek(1);
    const steered = stage.hash();
    stage.playTake(stage.take());
    await stage.seek(1);
    return [steered, stage.hash()];
  });
  expect(hashes[0]).not.toBe(unsteered);
  expect(hashes[1]).toBe(hashes[0]);
});

test.describe('with fingers', () => {
  test.use({ hasTouch: true });

  test('the airplane follows a finger @long', async ({ page }) => {
    await open(page, `?paused=1#v=1&preset=airplane${LIGHT}`);
    // Fix the camera, so that only the airplane moves in the picture.
    await ask(page, (stage) => stage.camera.orbit(0.001, 0));
    await ask(page, (stage) => stage.step(30));
    const start = (await ballPlace(page))!;
    const drag = await fingerOf(page);
    await drag(start, { x: start.x, y: start.y - 60 });
    await ask(page, (stage) => stage.step(120));
    const arrived = await ballPlace(page);
    expect(arrived!.y).toBeLessThan(start.y - 25);
    expect(Math.abs(arrived!.x - start.x)).toBeLessThan(40);
  });

  test('a double tap drops an object there, and the button another one @long', async ({ page }) => {
    await open(page, `?paused=1#v=1&preset=train${LIGHT}`);
    const inputs = () => ask(page, (stage) => stage.stats.inputs);
    await doubleTap(page, { x: 240, y: 70 });
    await expect.poll(inputs).toBe(1);
    await page.getByRole('button', { name: 'Drop a ball' }).tap();
    await expect.poll(inputs).toBe(2);
  });
});

/** Whether the picture around a position, in CSS pixels, changes. */
async function changedAround(page: Page, { x, y }: Point, act: () => Promise<void>): Promise<boolean> {
  const clip = { x: x - 30, y: y - 30, width: 60, height: 60 };
  const before = await page.screenshot({ clip });
  await act();
  return !before.equals(await page.screenshot({ clip }));
}

test('D drops an object at the pointer, a link to the moment repeats it, and the help lists the key', async ({
  page,
}) => {
  await open(page, `?paused=1#v=1&preset=lamp${LIGHT}`);
  await ask(page, (stage) => stage.step(10));
  const place = { x: 150, y: 90 };
  await page.mouse.move(place.x, place.y);
  expect(await changedAround(page, place, () => page.keyboard.press('d'))).toBe(true);
  await ask(page, (stage) => stage.step(40));
  const hashes = await ask(page, (stage) => {
    const dropped = stage.hash();
    stage.playTake(stage.take());
    stage.step(50);
    return [dropped, stage.hash()];
  });
  expect(hashes[1]).toBe(hashes[0]);
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Play with smoke' });
  await expect(help).toContainText('drop a ball or a crate');
  await expect(help).toContainText('Drag the ball');
});

test('camera, gallery, address bar and help follow the scene @long', async ({ page }) => {
  await open(page, `?paused=1#v=1&preset=wisp${LIGHT}`);
  await test.step('the camera is animated until the user moves it, and 0 resumes the animation', async () => {
    const azimuth = () => ask(page, (stage) => stage.camera.azimuth());
    const start = await azimuth();
    await ask(page, (stage) => stage.seek(3));
    const moved = await azimuth();
    expect(Math.abs(moved - start)).toBeGreaterThan(0.05);
    await page.keyboard.press('Shift+ArrowLeft');
    const taken = await azimuth();
    await ask(page, (stage) => stage.seek(1));
    expect(await azimuth()).toBe(taken);
    await ask(page, (stage) => stage.seek(3));
    await page.keyboard.press('0');
    expect(await azimuth()).toBeCloseTo(moved, 9);
  });
  await test.step('another preset opens its scene, the link follows, and undo returns', async () => {
    await page.keyboard.press('g');
    const arrive = await hold(page, '**/campfire*.js');
    await choose(page, 'campfire');
    await expect(page.getByText('Gathering wood…')).toBeVisible();
    await ask(page, (stage) => stage.step());
    expect(await ask(page, (stage) => [stage.get().scene, stage.stats.steps > 0])).toEqual(['wisp', true]);
    arrive();
    await expectValue(page, 'scene', 'campfire');
    await expect(page.getByText('Gathering wood…')).toHaveCount(0);
    await expectHash(page, '#v=1&preset=campfire');
    await ask(page, (stage) => stage.step(30));
    expect(await ask(page, (stage) => stage.stats.bodiesDrawn)).toBeGreaterThan(10);
    await page.keyboard.press('Control+z');
    await expectValue(page, 'scene', 'wisp');
    expect(await ask(page, (stage) => stage.stats.steps)).toBe(0);
  });
  await test.step('the help sheet and the label of the picture match the scene', async () => {
    const help = page.getByRole('dialog', { name: 'Play with smoke' });
    await page.keyboard.press('?');
    await expect(help).not.toContainText('ball');
    await closeSheet(page);
    await expect(page.getByRole('img', { name: 'A steaming cup of tea.' })).toBeVisible();
    await ask(page, (stage) => stage.enter({ scene: 'genie', 'simulation.maxParticles': 300 }));
    await page.keyboard.press('?');
    await expect(help).toContainText('Drag the genie');
    await expect(help).toContainText('move the genie');
  });
  await test.step('a link in the address bar opens its scene', async () => {
    await page.evaluate(() => (location.hash = '#v=1&preset=campfire&emission.rate=20'));
    await expectValue(page, 'scene', 'campfire');
    await expectValue(page, 'emission.rate', 20);
  });
});
