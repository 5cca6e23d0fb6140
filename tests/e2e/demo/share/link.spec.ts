import { pack } from '../../../../src/parameters/packing.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectHash, expectValue, LAMP, LIGHT, open, row, valueOf } from '../page.ts';

// Just wide enough for the panel to be open next to the smoke.
test.use({ viewport: { width: 760, height: 540 } });

test('the bare address opens the first look; a link without a preset and a version opens the lamp', async ({
  page,
}) => {
  await open(page, '?paused=1');
  await expectValue(page, 'scene', 'cloudscape');
  await expectValue(page, 'style.outlines', 0);
  await page.keyboard.press('g');
  await expect(page.getByRole('radio', { name: 'Cumulus' })).toBeChecked();
  const smoke = 'puff.variations=1&simulation.maxParticles=100';
  await open(page, `?paused=1#${smoke}`);
  await expectValue(page, 'scene', 'lamp');
  await expectValue(page, 'style.simplify', 3);
});

test('an edit changes the stage and the link, and the link restores it', async ({ page, context }) => {
  await open(page, `?paused=1${LIGHT}`);
  await page.getByLabel('Rate, exact value', { exact: true }).fill('55.5');
  await expectValue(page, 'emission.rate', 55.5);
  await row(page, 'style.tones').getByRole('combobox').selectOption('3');
  await row(page, 'style.shadows').getByRole('switch').click();
  await row(page, 'style.inkColor').locator('input').fill('#aa0011');
  const hash =
    '#v=1&preset=air&emission.rate=55.5&puff.variations=1&style.shadows=0&style.tones=3&style.inkColor=aa0011&simulation.maxParticles=500';
  await expectHash(page, hash);
  // The stage applies edits with its next frame, on a busy machine possibly after the address bar.
  await expectValue(page, 'style.inkColor', '#aa0011');
  const values = await ask(page, (stage) => stage.get());
  const other = await context.newPage();
  await open(other, `?paused=1${hash}`);
  expect(await ask(other, (stage) => stage.get())).toEqual(values);
  await expect(other.getByLabel('Rate, exact value', { exact: true })).toHaveValue('55.5');
  await expect(other.locator('.notice')).toHaveCount(0);
});

test('sliders, fields and curves set parameters, which are undone and reset', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await test.step('a slider moves its parameter by keys and by mouse', async () => {
    const slider = page.getByRole('slider', { name: 'Puff size' });
    await slider.press('ArrowRight');
    await expectValue(page, 'puff.size', 1.05);
    const box = (await slider.boundingBox())!;
    await page.mouse.click(box.x + box.width - 2, box.y + box.height / 2);
    await expectValue(page, 'puff.size', 4);
    await expect(slider).toHaveAttribute('aria-valuetext', '4 ×');
  });
  await test.step('a typed value out of range is clamped', async () => {
    const field = page.getByLabel('Rate, exact value', { exact: true });
    await field.fill('99999');
    await expect(field).toHaveAttribute('aria-invalid', 'true');
    await field.press('Enter');
    await expectValue(page, 'emission.rate', 20_000);
    await expect(field).toHaveValue('20000');
    await field.fill('');
    await field.press('Enter');
    await expect(field).toHaveValue('20000');
  });
  await test.step('undo, redo, reset one and reset all', async () => {
    const field = page.getByLabel('Puff size, exact value');
    for (const text of ['2', '3']) {
      await field.fill(text);
      await field.press('Enter');
    }
    await page.keyboard.press('Control+z');
    await expectValue(page, 'puff.size', 2);
    await page.keyboard.press('Control+Shift+z');
    await expectValue(page, 'puff.size', 3);
    await page.getByRole('button', { name: 'Undo' }).click();
    await expectValue(page, 'puff.size', 2);
    await page.getByRole('button', { name: 'Reset Puff size' }).click();
    await expectValue(page, 'puff.size', 1);
    await page.getByRole('button', { name: 'Reset all' }).click();
    await expectHash(page, '#v=1&preset=air');
    await expectValue(page, 'simulation.maxParticles', 600);
    await page.keyboard.press('Control+z');
    await expectValue(page, 'simulation.maxParticles', 500);
  });
  await test.step('stops of a curve are dragged, added, moved by keys and undone', async () => {
    const control = row(page, 'emission.density');
    const stops = control.locator('.curve-stop');
    await control.scrollIntoViewIfNeeded();
    const before = String(await valueOf(page, 'emission.density'));
    const count = before.split(',').length;
    const plane = (await control.locator('.curve-plane').boundingBox())!;
    const onPlane = (at: number, value: number) =>
      [plane.x + at * plane.width, plane.y + (1 - value) * plane.height] as const;
    /** Height of the middle stop after one is added. */
    const middle = async () => {
      const all = String(await valueOf(page, 'emission.density')).split(',');
      const added = all.map((stop) => stop.split(':').map(Number)).find(([at]) => Math.abs(at - 0.5) < 0.03);
      return added && all.length === count + 1 ? Math.round(20 * added[1]) / 20 : undefined;
    };
    await page.mouse.click(...onPlane(0.5, 0.2));
    await expect.poll(middle).toBe(0.2);
    await expect(stops).toHaveCount(count + 1);
    await page.mouse.move(...onPlane(0.5, 0.2));
    await page.mouse.down();
    await page.mouse.move(...onPlane(0.5, 0.7), { steps: 3 });
    await page.mouse.up();
    await expect.poll(middle).toBe(0.7);
    const dragged = String(await valueOf(page, 'emission.density'));
    await expect.poll(() => page.evaluate(() => location.hash)).toContain(`emission.density=${dragged}`);
    await page.keyboard.press('Control+z');
    await expect.poll(middle).toBe(0.2);
    await page.keyboard.press('Control+Shift+z');
    await expect.poll(middle).toBe(0.7);

    const added = stops.nth(before.split(',').filter((stop) => Number(stop.split(':')[0]) < 0.5).length);
    await added.focus();
    for (let press = 0; press < 5; ++press) await page.keyboard.press('ArrowUp');
    await expect.poll(middle).toBe(0.8);
    await page.keyboard.press('Delete');
    await expectValue(page, 'emission.density', before);
  });
});

test('a preset is selected, and a link typed into the address bar is applied', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await page.keyboard.press('g');
  await page.getByRole('radio', { name: 'Noir' }).check();
  await expectHash(page, '#v=1&preset=lamp-noir');
  await expectValue(page, 'style.outlineWidth', 4);
  await page.evaluate(() => (location.hash = '#v=1&preset=lamp-ghost&emission.rate=30&bogus=1'));
  await expectValue(page, 'emission.rate', 30);
  await expect(page.getByRole('radio', { name: 'Ghost', exact: true })).toBeChecked();
  await expect(page.getByText('There is no parameter “bogus”')).toBeVisible();
});

test('a link typed while an edit is written into the address bar is applied', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await page.evaluate(() => {
    const edited = location.href;
    location.hash = '#v=1&preset=lamp-ghost&emission.rate=30&bogus=1';
    // Simulates a pending write of the page: after the new address, before its event.
    history.replaceState(history.state, '', edited);
  });
  await expectValue(page, 'emission.rate', 30);
  await expect(page.getByText('There is no parameter “bogus”')).toBeVisible();
  await expectHash(page, '#v=1&preset=lamp-ghost&emission.rate=30');
});

test('the last of two typed links applies, even if the first takes longer to unpack @long', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  const packed = `#v=1&z=${await pack('preset=lamp&emission.rate=25')}`;
  await page.evaluate(
    async ([first, second]) => {
      const { prototype } = ReadableStreamDefaultReader;
      const { read } = prototype;
      const arrived = new Promise<void>((resolve) => {
        prototype.read = async function (this: ReadableStreamDefaultReader) {
          const piece = await read.call(this);
          await new Promise((proceed) => setTimeout(proceed, 200));
          if (piece.done) setTimeout(resolve);
          return piece;
        } as typeof read;
      });
      location.hash = first;
      location.hash = second;
      await arrived;
    },
    [packed, '#v=1&preset=lamp-ghost&emission.rate=30'],
  );
  await expectValue(page, 'emission.rate', 30);
  await expectHash(page, '#v=1&preset=lamp-ghost&emission.rate=30');
});

test('a link cannot set more than 50,000 particles', async ({ page }) => {
  await open(page, '?paused=1#v=1&simulation.maxParticles=1000000');
  expect(await valueOf(page, 'simulation.maxParticles')).toBe(50_000);
  const notice = page.locator('.notice');
  await expect(notice).toContainText('50000');
  await notice.getByRole('button', { name: 'Dismiss this message' }).click();
  await expect(notice).toHaveCount(0);
});

test('a newer link is shown, with a message in an existing live region', async ({ page }) => {
  await page.addInitScript(() => {
    const lengths: number[] = [];
    Object.assign(window, { lengths });
    // Screen readers do not announce content that a live region has when it is inserted.
    new MutationObserver(() => {
      const region = document.querySelector('[role=status][aria-label="Messages"]');
      if (region) lengths.push(region.childElementCount);
    }).observe(document, { childList: true, subtree: true });
  });
  await open(page, '?paused=1#v=9&preset=lamp&simulation.maxParticles=500');
  const messages = page.getByRole('status', { name: 'Messages' });
  await expect(messages).toContainText('This page reads version 1, not \u201c9\u201d; unknown parts are ignored.');
  expect((await page.evaluate(() => (window as unknown as { lengths: number[] }).lengths))[0]).toBe(0);
  await page.getByLabel('Puff size, exact value').fill('2');
  const hash = () => page.evaluate(() => location.hash);
  await expect.poll(hash).toMatch(/^#v=1&preset=lamp&puff\.size=2&.*maxParticles=500/);
});
