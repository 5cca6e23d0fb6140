import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, closeSheet, drop, expectValue, LAMP, LIGHT, open } from '../page.ts';

test.use({ viewport: { width: 760, height: 540 } });

const sheet = (page: Page) => page.getByRole('dialog', { name: 'Share this smoke' });

/** The file that the page saves when a control is pressed. */
async function saved(page: Page, press: () => Promise<void>): Promise<{ name: string; text: string }> {
  const [file] = await Promise.all([page.waitForEvent('download'), press()]);
  const chunks: Buffer[] = [];
  for await (const chunk of await file.createReadStream()) chunks.push(chunk as Buffer);
  return { name: file.suggestedFilename(), text: Buffer.concat(chunks).toString() };
}

test('the sheet copies link and code, shows a QR code, and works by keyboard', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const fetched: string[] = [];
  page.on('request', (request) => fetched.push(request.url()));
  await open(page, `?paused=1&t=0.5${LIGHT}`);
  const before = new Set(fetched);
  await expect.poll(() => ask(page, (stage) => stage.stats.steps)).toBe(30);
  await page.keyboard.press('s');
  await expect(sheet(page).getByRole('button', { name: 'Copy link' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(sheet(page).getByRole('status')).toHaveText('Copied.');
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  expect(await copied()).toBe(page.url().replace('?paused=1&t=0.5', ''));
  await expect(sheet(page).getByRole('img', { name: 'QR code of the link' })).toBeVisible();
  expect(
    fetched.filter((url) => url.endsWith('.js') && !before.has(url)),
    'comes when it is wanted',
  ).toHaveLength(1);
  await sheet(page).getByRole('radio', { name: 'This look' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(sheet(page).getByLabel('Link to this smoke')).toHaveValue(page.url());
  await sheet(page).getByText('Embed in your page').click();
  const code = sheet(page).getByLabel('Code', { exact: true });
  await expect(code).toHaveValue(
    /^<script type="module" [^<>]+><\/script>\n<cartoon-smoke src="[^"<>]+" alt="" style="[^"<>]+"><\/cartoon-smoke>$/,
  );
  // By keyboard alone, with an announcement.
  await page.keyboard.press('Tab');
  await page.keyboard.press('ArrowRight');
  await expect(sheet(page).getByRole('radio', { name: 'Iframe' })).toBeChecked();
  const copy = sheet(page).getByRole('button', { name: 'Copy code' });
  while (!(await copy.evaluate((button) => button === document.activeElement))) await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(sheet(page).getByRole('status').last()).toHaveText('Code copied.');
  expect(await copied()).toMatch(
    /^<iframe src="[^"]+\/embed\.html\?paused=1&amp;t=0.5&amp;interactive=0#v=1&amp;preset=air&amp;[^"]+" title="Cartoon Smoke"/,
  );
  await sheet(page).getByRole('radio', { name: 'A puff by one call' }).check();
  // The look of the preset, without its motion.
  await expect(code).toHaveValue(
    "import { puff } from 'cartoon-smoke/puff';\npuff(button, { preset: '#v=1&preset=air&puff.variations=1' });",
  );
  await closeSheet(page);
});

test('the share dialog of the platform is offered if it exists, and manual copying as a fallback @long', async ({
  page,
}) => {
  await page.addInitScript(() => {
    Object.assign(window, { handed: [] });
    const share = ({ url }: ShareData) =>
      Promise.resolve((window as unknown as { handed: unknown[] }).handed.push(url));
    Object.defineProperty(navigator, 'share', { value: share });
    if (isSecureContext) navigator.clipboard.writeText = () => Promise.reject(new Error('refused'));
  });
  await open(page, `?paused=1${LIGHT}`);
  // A click before the links are written shares no link.
  await page.evaluate(() => {
    for (const name of ['Share', 'Send…']) {
      [...document.querySelectorAll('button')].find(({ textContent }) => textContent === name)!.click();
    }
  });
  await sheet(page).getByRole('button', { name: 'Send…' }).click();
  const link = page.url().replace('?paused=1', '');
  expect(await page.evaluate(() => (window as unknown as { handed: unknown[] }).handed)).toEqual([link]);
  await sheet(page).getByRole('button', { name: 'Copy link' }).click();
  await expect(sheet(page).getByRole('status')).toContainText('The browser blocked copying.');
  await expect(sheet(page).getByLabel('Link to this smoke')).toBeFocused();
  const selected = () => (document.activeElement as HTMLInputElement).selectionEnd;
  expect(await page.evaluate(selected)).toBe(link.length);
});

test('a take too long for a link becomes a file, which restores the moment @long', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await ask(page, (stage) => {
    // A visible stage draws a picture after each step.
    stage.resize(0, 0);
    for (let step = 0; step < 420; step++) {
      for (let channel = 0; channel < 8; channel++) stage.steer(channel, Math.sin(step * step + channel * 7));
      stage.step(1);
    }
    stage.resize(16, 16, 1);
    stage.blow({ x: 8, y: 8, dx: 3 });
    stage.step(1);
  });
  const hash = await ask(page, (stage) => stage.hash());
  await page.getByRole('button', { name: 'Share' }).click();
  await sheet(page).getByRole('radio', { name: 'This moment' }).check();
  await expect(sheet(page).getByRole('status')).toContainText('chat programs cut links over 8000');
  await expect(sheet(page).getByRole('button', { name: 'Copy link' })).toBeDisabled();
  const file = await saved(page, () => sheet(page).getByRole('button', { name: 'Save as file' }).click());
  expect(file.name).toBe('lamp.take.json');
  await open(page, '?paused=1#v=1&preset=lamp-noir&emission.rate=7');
  await drop(page, file.name, file.text);
  await expect.poll(() => ask(page, (stage) => [stage.stats.steps, stage.hash()])).toEqual([421, hash]);
  await expectValue(page, 'style.tones', 2);
  await expect(page.locator('.notice')).toHaveCount(0);
});

test('invalid files show an error and change nothing', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await drop(page, 'a.json', '{"format": "cartoon-smoke",\n  "version": 1,,}');
  await expect(
    page.getByText('a.json could not be opened. The file is not valid JSON at line 2, column 16.'),
  ).toBeVisible();
  await drop(page, 'b.json', '{"format": "cartoon-smoke", "version": 1, "values": {"puff.size": 9}}');
  await expect(page.getByText('puff.size cannot be “9”')).toBeVisible();
  await expectValue(page, 'puff.size', 4);
  await page.keyboard.press('Control+z');
  await expectValue(page, 'puff.size', 1);
  await expectValue(page, 'simulation.maxParticles', 500);
});

test('looks are saved, shown again, renamed, exported, and removed with undo', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}&puff.size=2`);
  const mine = page.getByRole('group', { name: 'My looks' });
  await mine.getByRole('button', { name: 'Save this look' }).click();
  await expect(mine.getByRole('button', { name: 'Open air 1', exact: true })).toBeVisible();
  await ask(page, (stage) => stage.set({ 'puff.size': 3 }));
  await expect.poll(() => page.url()).toContain('puff.size=3');
  await page.reload();
  await mine.getByRole('button', { name: 'Rename Open air 1' }).click();
  const clicks = await page.evaluateHandle(() => {
    const all: Event[] = [];
    addEventListener('click', (event) => all.push(event));
    return all;
  });
  await page.keyboard.type('<b>Big</b>');
  await page.keyboard.press('Enter');
  const card = mine.getByRole('button', { name: '<b>Big</b>', exact: true });
  await expect(card).toBeFocused();
  expect(await clicks.evaluate(({ length }) => length), 'to rename is not to show').toBe(0);
  await page.keyboard.press('Enter');
  await expectValue(page, 'puff.size', 2);
  await expectValue(page, 'simulation.maxParticles', 500);
  const file = await saved(page, () => mine.getByRole('button', { name: 'Save <b>Big</b> as file' }).click());
  expect(file.name).toBe('b-big-b.preset.json');
  expect(JSON.parse(file.text)).toMatchObject({ name: '<b>Big</b>', values: { 'puff.size': 2 } });
  await mine.getByRole('button', { name: 'Remove <b>Big</b>' }).click();
  await expect(card).toHaveCount(0);
  await page.getByRole('status', { name: 'Messages' }).getByRole('button', { name: 'Undo' }).click();
  await expect(card).toBeVisible();
  const colors = () =>
    card.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
  // The picture is decoded asynchronously and painted after the card appears.
  await expect.poll(colors).toBeGreaterThan(20);
});

test('saved looks that cannot be read are set aside, not lost @long', async ({ page }) => {
  await page.addInitScript(() => {
    // An opaque origin has no storage.
    if (origin !== 'null') localStorage.setItem('cartoon-smoke.presets', '[{"id": "x", "name": 7}, 3');
  });
  await open(page, `?paused=1${LIGHT}`);
  await expect(page.getByText('Their data is in localStorage under cartoon-smoke.presets.damaged.')).toBeVisible();
  expect(await page.evaluate(() => localStorage.getItem('cartoon-smoke.presets.damaged'))).toContain('"name": 7');
});
