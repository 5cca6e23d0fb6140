import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { expectValue, LIGHT, open, valueOf } from '../page.ts';

type Place = readonly [x: number, y: number];

const point = (index: number) => `[data-gizmo="flows.0.points.${index}"]`;
const handles = (page: Page) => page.locator('[data-gizmo^="flows"]').filter({ visible: true });
const pointsOf = async (page: Page) =>
  (((await valueOf(page, 'flows.0.points')) as string | undefined) ?? '').split(',');

/** Waits for the points of the stroke: its first handle may be focused before they can be read. */
async function drawnPoints(page: Page): Promise<string[]> {
  await expect.poll(async () => (await pointsOf(page)).length).toBeGreaterThan(3);
  const points = await pointsOf(page);
  await expect(handles(page)).toHaveCount(points.length);
  return points;
}

/** Opens the page with the handles and the brush. */
async function begin(page: Page): Promise<void> {
  await page.setViewportSize({ width: 690, height: 480 });
  await open(page, `?paused=1&t=1${LIGHT}`);
  await page.keyboard.press('h');
  await page.getByRole('button', { name: 'Draw a flow' }).click();
}

async function draw(page: Page, places: readonly Place[]): Promise<void> {
  const [[x, y], ...rest] = places;
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const [toX, toY] of rest) await page.mouse.move(toX, toY, { steps: 4 });
  await page.mouse.up();
}

const S: readonly Place[] = [
  [250, 380],
  [420, 340],
  [300, 240],
  [430, 160],
];

test('a stroke over the picture is a flow with a handle for each point, with undo', async ({ page }) => {
  await begin(page);
  await draw(page, S);
  const points = await drawnPoints(page);
  await expectValue(page, 'flows.0.closed', 'open');
  const ends = [S[0], S.at(-1)!];
  for (const [at, index] of [0, points.length - 1].entries()) {
    const box = (await page.locator(point(index)).boundingBox())!;
    const off = Math.hypot(box.x + box.width / 2 - ends[at][0], box.y + box.height / 2 - ends[at][1]);
    expect(off, 'the handle is where the stroke was').toBeLessThan(4);
  }
  await page.keyboard.press('Control+z');
  await expectValue(page, 'flows.0.points', undefined);
  await expect(handles(page)).toHaveCount(0);
});

test('a stroke that returns to its start is a ring', async ({ page }) => {
  await begin(page);
  await draw(page, [...S, [250, 200], [252, 372]]);
  await expectValue(page, 'flows.0.closed', 'ring');
});

test('points are moved, added and removed by pointer and keys', async ({ page }) => {
  await begin(page);
  await draw(page, S);
  await expect(page.locator(point(0))).toBeFocused();
  const points = await drawnPoints(page);
  await page.keyboard.press('ArrowUp');
  await expect.poll(() => pointsOf(page)).not.toEqual(points);
  const moved = await pointsOf(page);
  expect(moved.slice(1)).toEqual(points.slice(1));
  await page.keyboard.press('Enter');
  await expect(handles(page)).toHaveCount(points.length + 1);
  await expect(page.locator(point(1))).toBeFocused();
  await page.keyboard.press('Delete');
  await expect.poll(() => pointsOf(page)).toEqual(moved);
  const box = (await page.locator(point(2)).boundingBox())!;
  await draw(page, [
    [box.x + 16, box.y + 16],
    [box.x + 56, box.y + 16],
  ]);
  await expect.poll(async () => (await pointsOf(page))[2]).not.toBe(moved[2]);
  expect((await pointsOf(page)).toSpliced(2, 1)).toEqual(moved.toSpliced(2, 1));
});

test('Escape cancels, Enter draws a straight flow, and a click draws nothing', async ({ page }) => {
  await begin(page);
  await page.mouse.click(300, 300);
  const brush = page.getByRole('group', { name: 'Draw a flow' });
  await expect(brush).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(brush).toBeHidden();
  await expect(page.getByRole('button', { name: 'Draw a flow' })).toBeFocused();
  await expectValue(page, 'flows.0.points', undefined);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await expect(handles(page)).toHaveCount(3);
  await expect(page.locator(point(0))).toBeFocused();
});
