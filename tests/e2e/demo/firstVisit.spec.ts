/** What helps at the first visit: the hint at the gestures, random looks, and shortcuts that can be turned off. */
import { presets, presetValues } from '../../../src/preset.ts';
import { expect, longIf, test } from '../../support/fixtures.ts';
import { ask, expectValue, LAMP, LIGHT, open } from './page.ts';

test.use({ viewport: { width: 900, height: 620 } });

test.describe('at the first visit', () => {
  test.use({ isFirstVisit: true });

  for (const way of ['a drag', 'the button']) {
    const tag = longIf(way === 'the button');
    test(`a hint names the gestures until ${way}, and does not come back${tag}`, async ({ page }) => {
      await open(page, `?paused=1${LAMP}`);
      const hint = page
        .getByRole('status', { name: 'Messages' })
        .getByText('Drag the ball to push it through the smoke.');
      await expect(hint).toBeVisible();
      if (way === 'a drag') await page.mouse.click(400, 330);
      else await page.getByRole('button', { name: 'Dismiss this message' }).click();
      await expect(hint).toHaveCount(0);
      await open(page, `?paused=1${LAMP}`);
      await expect(page.getByRole('button', { name: 'Help' })).toBeVisible();
      await expect(hint).toHaveCount(0);
    });
  }

  test('the hint and the tools hide while a flow is drawn, and show again when it is cancelled', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    const hint = page.getByText(/^Drag to turn the view\./);
    const draw = page.getByRole('button', { name: 'Draw a flow' });
    await page.getByRole('button', { name: 'Handles' }).click();
    await expect(hint).toBeVisible();
    await draw.click();
    await expect(page.getByText(/^Draw a stroke/)).toBeVisible();
    await expect(hint).toBeHidden();
    await expect(draw).toBeHidden();
    await page.keyboard.press('Escape');
    await expect(hint).toBeVisible();
    await expect(draw).toBeFocused();
  });

  test('a scene without an object to move has a hint without one', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    await expect(page.getByText(/^Drag to turn the view\./)).toBeVisible();
  });
});

test('shortcuts of a single character can be turned off, which lasts', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const gallery = page.locator('.gallery');
  const toggle = async () => {
    await page.getByRole('button', { name: 'Help' }).click();
    await page.getByLabel('Shortcuts of a single character').click();
    await page.keyboard.press('Escape');
  };
  await page.keyboard.press('g');
  await expect(gallery).toBeHidden();
  await toggle();
  await page.keyboard.press('g');
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toHaveCount(0);
  await expect(gallery).toBeHidden();
  await open(page, `?paused=1${LIGHT}`);
  await page.keyboard.press('g');
  await expect(gallery).toBeVisible();
  // The space bar is no character key, and Ctrl is held with Z.
  await page.locator('#smoke').focus();
  await page.keyboard.press(' ');
  await expect.poll(() => ask(page, (stage) => stage.playing)).toBe(true);
  await toggle();
  await page.keyboard.press('g');
  await expect(gallery).toBeHidden();
});

test('a random look is another scene in the style of a third preset, and can be undone @long', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const [base, ...others] = presets.filter(({ name }) => name !== 'air');
  const models = presets.filter(({ name }) => name !== base.name);
  const model = others.find((each) => presetValues(each)['style.ramp'])!;
  // The first preset, and one with colours of its own.
  await page.evaluate(
    (numbers) => {
      Math.random = () => numbers.shift() ?? 0.5;
    },
    [0, (models.indexOf(model) + 0.5) / models.length],
  );
  await page.getByRole('button', { name: 'Surprise me' }).click();
  await expectValue(page, 'scene', presetValues(base).scene);
  await expectValue(page, 'style.ramp', presetValues(model)['style.ramp']);
  await expectValue(page, 'emission.rate', presetValues(base)['emission.rate']);
  await page.keyboard.press('Control+z');
  await expectValue(page, 'scene', 'air');
  await expectValue(page, 'style.ramp', '');
});
