import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectSteps, expectValue, LAMP, LIGHT, open, row } from '../page.ts';

const hash = () => decodeURIComponent(location.hash);

test('forces and items of the scene are edited in the panel', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await page.keyboard.press('p');
  await test.step('a force is added, attached to the ball, undone and removed, and the link follows', async () => {
    await page.getByLabel('What to add').selectOption('winds');
    await page.getByRole('button', { name: 'Add', exact: true }).click();
    await expect.poll(() => page.evaluate(hash)).toContain('winds.0.velocity.x=0.5');
    await expect(page.locator('summary', { hasText: 'Wind 1' })).toBeInViewport();
    await expect(page.getByRole('heading', { name: 'Parameters' })).toBeInViewport();
    await page.getByLabel('Attached to', { exact: true }).selectOption({ label: 'Ball' });
    await expect.poll(() => page.evaluate(hash)).toContain('winds.0.rigid=0');
    await expectValue(page, 'winds.0.rigid', 0);

    await page.getByRole('button', { name: 'Undo' }).click();
    await expect.poll(() => page.evaluate(hash)).not.toContain('winds.0.rigid');
    await expect.poll(() => ask(page, (stage) => 'winds.0.rigid' in stage.get())).toBe(false);
    await expect(page.getByLabel('Attached to', { exact: true })).toHaveValue('-1');

    await page.getByRole('button', { name: 'Remove Wind 1' }).click();
    await expect.poll(() => page.evaluate(hash)).not.toContain('winds');
    await expect(page.locator('summary', { hasText: 'Wind 1' })).toBeHidden();
  });
  await test.step('items of the scene are shown and can be changed and reset, but not removed', async () => {
    await page.locator('summary', { hasText: 'Emitter 1' }).click();
    const speed = row(page, 'emitters.0.speed').getByLabel('Speed, exact value');
    await expect(speed).toHaveValue('0.6');
    await expect(page.getByRole('button', { name: 'Remove Emitter 1' })).toHaveCount(0);
    await speed.fill('3');
    await speed.press('Enter');
    await expect.poll(() => page.evaluate(hash)).toContain('emitters.0.speed=3');
    await row(page, 'emitters.0.speed').getByRole('button', { name: 'Reset Speed' }).click();
    await expect.poll(() => page.evaluate(hash)).not.toContain('emitters.0.speed');
    await expect(speed).toHaveValue('0.6');
  });
});

test('smoke blows where an added wind blows @long', async ({ page }) => {
  const hashWith = async (link: string) => {
    await open(page, `?paused=1&t=3${LIGHT}${link}`);
    await expectSteps(page, 180);
    return ask(page, (stage) => stage.hash());
  };
  expect(await hashWith('&winds.0.velocity.x=2')).not.toBe(await hashWith(''));
});
