/** Touch input for tests of the page. */
import type { Page } from '@playwright/test';
import type { Point } from './page.ts';

export type Drag = (from: Point, to: Point) => Promise<void>;

/** Seconds: touchstart, half-way, arrival, rest, touchend. */
const [DOWN, HALF_WAY, THERE, AT_REST, UP] = [0, 0.1, 0.2, 0.8, 1];

/**
 * A finger that moves between two positions; the page must be opened with touch. It rests before it lifts, and its
 * timestamps are one second in the past: browsers treat the first tap soon after a fling as a stop of that fling,
 * without a click.
 */
export async function fingerOf(page: Page): Promise<Drag> {
  const session = await page.context().newCDPSession(page);
  return async (from, to) => {
    const start = Date.now() / 1000 - 2;
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', seconds: number, ...touchPoints: Point[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints, timestamp: start + seconds });
    await touch('touchStart', DOWN, from);
    await touch('touchMove', HALF_WAY, { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 });
    await touch('touchMove', THERE, to);
    await touch('touchMove', AT_REST, to);
    await touch('touchEnd', UP);
  };
}

/** Two fingers next to each other, at a height of 100 pixels, that move between horizontal positions. */
export async function fingersOf(page: Page): Promise<(from: [number, number], to: [number, number]) => Promise<void>> {
  const session = await page.context().newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...widths: number[]) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: widths.map((x, id) => ({ x, y: 100, id })) });
  return async (from, to) => {
    await touch('touchStart', ...from);
    await touch('touchMove', ...from.map((x, id) => (x + to[id]) / 2));
    await touch('touchMove', ...to);
    await touch('touchEnd');
  };
}

/** Two taps 0.1 s apart, even if the page takes longer for the first. */
export async function doubleTap(page: Page, place: Point): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const start = Date.now() / 1000;
  const events = ['touchStart', 'touchEnd', 'touchStart', 'touchEnd'] as const;
  for (const [index, type] of events.entries()) {
    const touchPoints = type === 'touchStart' ? [place] : [];
    await session.send('Input.dispatchTouchEvent', { type, touchPoints, timestamp: start + 0.05 * index });
  }
}

/** The same with the mouse. */
export function mouseOf({ mouse }: Page): Drag {
  return async (from, to) => {
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(to.x, to.y, { steps: 3 });
    await mouse.up();
  };
}

/** The centre of the first match when it is visible: elements that a tap opens appear after the tap. */
export async function middleOf(page: Page, selector: string): Promise<Point> {
  const found = page.locator(selector);
  await found.waitFor();
  const box = (await found.boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}
