/** Helpers for tests of the demo page. */
import type { Page } from '@playwright/test';
import type { Stage } from '../../../src/stage/stage.ts';
import { expect } from '../../support/fixtures.ts';
import type { AnyValues } from '../../../src/parameters/parameter.ts';

const LITTLE = '&emission.rate=40&puff.variations=1&simulation.maxParticles=500';
/** Little smoke of one shape, which is cheap to draw with SwiftShader and to bake, in a scene without anything else. */
export const LIGHT = `#v=1&preset=air${LITTLE}`;
/** The same with surfaces and a ball to drag: the page costs twice the CPU time. */
export const LAMP = `#v=1&preset=lamp${LITTLE}`;

/** Opens the page and waits for its stage and its controls. @param address part after the slash: query and hash */
export async function open(page: Page, address: string): Promise<void> {
  await page.goto('about:blank');
  await page.goto(`/${address}`);
  await isComplete(page);
}

/** Waits until the page has its controls and listens to keys. */
export async function isComplete(page: Page): Promise<void> {
  await page.locator('#interface:not(.is-incomplete)').waitFor({ state: 'attached' });
}

/** Evaluates a function of the stage in the page. */
export function ask<Answer>(page: Page, question: (stage: Stage) => Answer): Promise<Awaited<Answer>> {
  return page.evaluate(`(${String(question)})(window.cartoonSmoke)`) as Promise<Awaited<Answer>>;
}

/** The value of a parameter on the stage. */
export function valueOf(page: Page, key: string): Promise<unknown> {
  return page.evaluate((name) => (window.cartoonSmoke!.get() as AnyValues)[name], key);
}

export async function expectValue(page: Page, key: string, value: unknown): Promise<void> {
  await expect.poll(() => valueOf(page, key), { message: key }).toBe(value);
}

export async function expectHash(page: Page, hash: string): Promise<void> {
  await expect.poll(() => page.evaluate(() => location.hash), { message: 'address bar' }).toBe(hash);
}

/**
 * Makes the page use one frame for each slice of its chunked work, and makes each slice small: a long seek then takes
 * minutes on any machine, and can be observed and stopped. Affects the current page and pages opened later.
 */
export async function crawl(page: Page): Promise<void> {
  const slowDown = () => {
    const { performance, MessagePort: Port } = globalThis;
    const now = performance.now.bind(performance);
    let ahead = 0;
    performance.now = () => now() + (ahead += 10);
    const post = Reflect.get(Port.prototype, 'postMessage') as (...given: unknown[]) => void;
    Port.prototype.postMessage = function (this: MessagePort, ...given: unknown[]) {
      requestAnimationFrame(() => post.apply(this, given));
    };
  };
  await page.addInitScript(slowDown);
  await page.evaluate(slowDown);
}

/**
 * Waits until `?t=` or a moment has advanced the stage and its overlay is gone: the page loads earlier.
 * @param count number of steps, 60 per second
 */
export async function expectSteps(page: Page, count: number): Promise<void> {
  const arrived = () => ask(page, ({ stats }) => (document.querySelector('progress') ? 'on the way' : stats.steps));
  await expect.poll(arrived, { message: 'steps' }).toBe(count);
}

/** Records the messages of the page from now on. Some of them disappear on their own, so polling could miss them. */
export async function messagesOf(page: Page): Promise<() => Promise<string[]>> {
  const notified = await page.evaluateHandle(() => {
    const texts: string[] = [];
    const note = (node: Node) => {
      if (node instanceof Element && node.checkVisibility()) texts.push(node.textContent ?? '');
    };
    const region = document.querySelector('[aria-label="Messages"][role=status]')!;
    new MutationObserver((records) => records.forEach(({ addedNodes }) => addedNodes.forEach(note))).observe(region, {
      childList: true,
    });
    return texts;
  });
  return () => notified.jsonValue();
}

/**
 * Closes the open dialog and waits until it is gone, because until then it receives all keys. A busy machine takes a
 * while.
 */
export async function closeSheet(page: Page): Promise<void> {
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);
}

/** Holds all responses from a URL until the returned function is called. */
export async function hold(page: Page, address: string): Promise<() => void> {
  let arrive!: () => void;
  const arrival = new Promise<void>((resolve) => (arrive = resolve));
  await page.route(address, async (route) => {
    await arrival;
    await route.continue();
  });
  return arrive;
}

/** Drops a file on the page, as from the desktop. */
export async function drop(page: Page, name: string, content: Uint8Array | string): Promise<void> {
  const data = await page.evaluateHandle(
    ([fileName, base64]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(atob(base64), (each) => each.charCodeAt(0))], fileName));
      return transfer;
    },
    [name, Buffer.from(content).toString('base64')],
  );
  await page.dispatchEvent('body', 'drop', { dataTransfer: data });
}

/** The row of a parameter in the panel. */
export function row(page: Page, key: string) {
  return page.locator(`[data-key="${key}"]`);
}

export interface Point {
  x: number;
  y: number;
}

/**
 * The centre of the object that can be dragged, in CSS pixels. Found by hit-testing, as a user would, with a picture of
 * the size of its canvas, which it gets with the next frame.
 */
export function ballPlace(page: Page): Promise<Point | null> {
  return page.evaluate(async () => {
    const stage = window.cartoonSmoke!;
    const canvas = document.querySelector('canvas')!;
    const box = canvas.getBoundingClientRect();
    const isFitted = () =>
      canvas.width === Math.round(canvas.clientWidth * devicePixelRatio) &&
      canvas.height === Math.round(canvas.clientHeight * devicePixelRatio);
    while (!isFitted()) await new Promise(requestAnimationFrame);
    const hits: { x: number; y: number }[] = [];
    for (let x = 4; x < box.width; x += 8) {
      for (let y = 4; y < box.height; y += 8) {
        if (stage.pointer({ type: 'down', id: -1, x, y }) === 'rigid') hits.push({ x, y });
        stage.pointer({ type: 'cancel', id: -1, x, y });
      }
    }
    if (hits.length === 0) return null;
    const mean = (axis: 'x' | 'y') => hits.reduce((sum, hit) => sum + hit[axis], 0) / hits.length;
    return { x: box.left + mean('x'), y: box.top + mean('y') };
  });
}
