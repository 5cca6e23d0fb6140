import type { Page } from '@playwright/test';
import { packBytes } from '../../../../src/parameters/packing.ts';
import { expect, knowGestures, test } from '../../../support/fixtures.ts';
import { ask, ballPlace, closeSheet, crawl, expectValue, hold, LAMP, LIGHT, messagesOf, open } from '../page.ts';

test.use({ viewport: { width: 320, height: 240 } });

/** Drags the ball, blows and changes values while the smoke plays, then pauses. */
async function play(page: Page): Promise<void> {
  await open(page, LAMP);
  const ball = (await ballPlace(page))!;
  await page.mouse.move(ball.x, ball.y);
  await page.mouse.down();
  await page.mouse.move(ball.x - 40, ball.y - 30, { steps: 5 });
  await ask(page, (stage) => stage.set({ 'forces.wind.x': 1.25, 'emission.density': '0:.5,.5:1,1:0' }));
  await page.mouse.move(ball.x - 60, ball.y, { steps: 5 });
  await page.mouse.up();
  await ask(page, (stage) => stage.blow({ x: 150, y: 120, dx: 9, dy: -4 }));
  await ask(page, (stage) => stage.set({ 'style.smokeColor': '#ffcc88' }));
  await ask(page, (stage) => stage.pause());
  await ask(page, (stage) => stage.step(45));
}

/** The link to the current moment, from the share dialog. */
async function momentLink(page: Page): Promise<string> {
  const sheet = page.getByRole('dialog', { name: 'Share this smoke' });
  await page.keyboard.press('s');
  await expect(sheet.getByRole('button', { name: 'Copy link' })).toBeFocused();
  await sheet.getByRole('radio', { name: 'This moment' }).check();
  const link = await sheet.getByLabel('Link to this smoke').inputValue();
  await closeSheet(page);
  return link;
}

const shown = (page: Page) =>
  ask(page, (stage) => ({ hash: stage.hash(), steps: stage.stats.steps, playing: stage.playing, values: stage.get() }));

test('a take reaches the same hash in another browser, also at an earlier moment', async ({ page, browser }) => {
  await play(page);
  const there = await shown(page);
  const link = await momentLink(page);
  expect(link).toMatch(/[?&]paused=1#v=1&preset=lamp&.*&take=[\w-]+$/);
  expect(link.length).toBeLessThan(4000);
  await ask(page, (stage) => stage.seek(0.5));
  const [earlier, earlierLink] = [await shown(page), await momentLink(page)];
  const context = await browser.newContext({ viewport: { width: 240, height: 160 } });
  await context.addInitScript(knowGestures);
  const other = await context.newPage();
  for (const [address, moment] of [
    [link, there],
    [earlierLink, earlier],
  ] as const) {
    await open(other, address.slice(address.indexOf('/?') + 1));
    await expect.poll(() => shown(other)).toEqual(moment);
    await expect(other.locator('.notice')).toHaveCount(0);
  }
  await context.close();
});

test('a moment of another scene, opened by the address bar, stays there until the next edit @long', async ({
  page,
}) => {
  await open(page, '?paused=1#v=1&preset=wisp&puff.variations=1&simulation.maxParticles=300');
  await ask(page, (stage) => stage.blow({ x: 150, y: 120, dx: 9, dy: -4 }));
  await ask(page, (stage) => stage.step(45));
  const wisp = { moment: await shown(page), link: new URL(await momentLink(page)).hash };
  await open(page, '?paused=1#v=1&preset=train&puff.variations=1&simulation.maxParticles=300');
  await ask(page, (stage) => stage.blow({ x: 150, y: 120, dx: 9, dy: -4 }));
  await ask(page, (stage) => stage.step(30));
  const train = { moment: await shown(page), link: new URL(await momentLink(page)).hash };
  // To a scene without rigids, which has another simulator, and back.
  for (const { moment, link } of [wisp, train]) {
    await page.evaluate((hash) => (location.hash = hash), link);
    await expect.poll(() => shown(page)).toEqual(moment);
    expect(await page.evaluate(() => location.hash)).toBe(link);
  }
  await test.step('also if it is opened while another scene loads', async () => {
    const goTo = (hash: string) => page.evaluate((wanted) => (location.hash = wanted), hash);
    const arrive = await hold(page, '**/campfire*.js');
    await goTo('#v=1&preset=campfire&puff.variations=1&simulation.maxParticles=300');
    await expect(page.getByText('Gathering wood…')).toBeVisible();
    await goTo(train.link);
    await expect(page.locator('input[name=preset][value=train]')).toBeChecked();
    arrive();
    await expect(page.getByText('Gathering wood…')).toHaveCount(0);
    await expect.poll(() => shown(page)).toEqual(train.moment);
    expect(await page.evaluate(() => location.hash)).toBe(train.link);
  });
  await expect(page.locator('.notice')).toHaveCount(0);
  await ask(page, (stage) => stage.set({ 'puff.size': 2 }));
  await expect
    .poll(() => page.evaluate(() => location.hash))
    .toBe('#v=1&preset=train&puff.size=2&puff.variations=1&simulation.maxParticles=300');
});

test('without user input a moment is only its time; a long take replays with progress and can be stopped', async ({
  page,
}) => {
  await open(page, `?paused=1${LIGHT}`);
  await test.step('without user input a moment is only its time', async () => {
    await ask(page, (stage) => stage.step(7));
    const { search, hash } = new URL(await momentLink(page));
    expect([search, hash]).toEqual(['?paused=1&t=0.117', LIGHT]);
  });
  await test.step('a long take replays with progress and can be stopped', async () => {
    await ask(page, (stage) => stage.blow({ x: 100, y: 100, dx: 5 }));
    await ask(page, (stage) => stage.step(3_993));
    const link = await momentLink(page);
    await page.goto('about:blank');
    await crawl(page);
    await page.goto(link);
    await expect(page.getByRole('progressbar', { name: 'Replaying 66.7 s' })).toBeVisible();
    const notified = await messagesOf(page);
    await page.getByRole('button', { name: 'Stop here' }).click();
    await expect.poll(notified).toEqual([expect.stringContaining('Stopped at')]);
    expect(await ask(page, (stage) => stage.stats.steps)).toBeLessThan(4_000);
  });
});

test('an invalid moment keeps the look, with a notice', async ({ page }) => {
  const expectRejected = async (take: string, message: string) => {
    await open(page, `?paused=1${LIGHT}&puff.size=2&take=${take}`);
    await expect(page.locator('.notice')).toContainText(message);
    await expectValue(page, 'puff.size', 2);
    await ask(page, (stage) => stage.step(2));
    expect(await ask(page, (stage) => stage.stats.steps)).toBe(2);
  };
  await expectRejected('AAAA', 'The moment in the link is damaged');
  await expectRejected('AwA', 'The moment in the link cannot be shown');
  const bytes = await ask(page, (stage) => {
    stage.restart();
    stage.set({ 'simulation.maxParticles': 60_000 });
    return [...stage.take().toBytes()];
  });
  const tooMany = await packBytes(Uint8Array.from(bytes));
  await expectRejected(tooMany, 'it needs room for 60000 particles. The limit for links is 50000.');
});
