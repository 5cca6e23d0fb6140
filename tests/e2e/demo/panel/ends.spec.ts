/** Every row of the table at both ends of the range that links accept: each has an effect, and nothing breaks. */
import type { Page } from '@playwright/test';
import { table } from '../../../../src/parameters/table.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { itemTrials, singleTrials, valuesAt, withoutEffectOnPicture, withoutEffectOnState } from './ends.ts';
import { ask, open } from '../page.ts';

test.use({ viewport: { width: 96, height: 72 } });

const SMALL = '#v=1&preset=lamp&emission.rate=40&puff.variations=1&simulation.maxParticles=120';

test('parameters of the simulator and items of all lists change its state, and all of them at once do not stop it @long', async ({
  page,
}) => {
  await open(page, `?paused=1&ui=0${SMALL.replace('lamp', 'wisp')}`);
  await ask(page, (stage) => stage.step(60));
  const trials = [...singleTrials('simulator', 'stage'), ...itemTrials()];
  // Saving and restoring a state without rigids is ten times as fast, and most rows need no rigids.
  const left = new Set(await withoutEffectOnState(page, trials));
  expect(left.size).toBeLessThan(trials.length / 4);
  await open(page, `?paused=1&ui=0${SMALL}`);
  await ask(page, (stage) => stage.step(60));
  const needing = trials.filter(({ name }) => left.has(name));
  expect(await withoutEffectOnState(page, needing)).toEqual([]);
  await expectAlive(page);
});

/** With all rows at their ends the simulator still has finite values. */
async function expectAlive(page: Page): Promise<void> {
  const rows = table.filter(({ reader }) => reader === 'simulator');
  const states = await page.evaluate(
    (all) => {
      const stage = window.cartoonSmoke!;
      stage.resize(0, 0);
      return all.map((values) => {
        stage.restart();
        stage.step(30);
        stage.set(values);
        stage.step(30);
        const { alive, waiting, steps } = stage.stats;
        // restore() throws for a state with non-finite numbers.
        stage.restore(stage.save());
        return { figures: [alive, waiting, steps].every(Number.isFinite), hash: stage.hash() };
      });
    },
    [valuesAt(rows, 0), valuesAt(rows, 1)],
  );
  for (const { figures, hash } of states) {
    expect(figures).toBe(true);
    expect(hash).toMatch(/^[0-9a-f]{16}$/);
  }
  expect(states[0].hash).not.toBe(states[1].hash);
}

test.describe('with all pixels', () => {
  test.use({ deviceScaleFactor: 1 });

  test('parameters of style, light and camera change the picture @long', async ({ page }) => {
    await open(page, `?paused=1&ui=0${SMALL}`);
    await ask(page, (stage) => {
      stage.set({ 'camera.distance': 4.5 });
      for (const tint of [1, 2, 3]) {
        stage.set({ 'emitters.0.tint': tint });
        stage.step(15);
      }
      stage.set({ 'emitters.0.tint': 0, 'emitters.0.look.inkWeight': 2 });
      stage.step(15);
      // Puffs with a look stay, so colours of looks change the picture.
      stage.unset(['emitters.0.look.inkWeight']);
      stage.step(95);
    });
    await ask(page, async (stage) => {
      // Optional passes load when they are first requested, all renderers together; after that each change is immediate.
      stage.set({ 'style.simplify': 1, 'style.strokes': 1, 'style.volumes': 'counted', 'style.pattern': 'dots' });
      await stage.complete();
      stage.set({ 'style.renderer': 'selle' });
      await stage.complete();
      stage.set({
        'style.renderer': 'nailboards',
        'style.volumes': 'receiver',
        'style.simplify': 0,
        'style.strokes': 0,
        'style.pattern': 'none',
      });
    });
    expect(await withoutEffectOnPicture(page, singleTrials('style', 'light', 'camera'))).toEqual([]);
  });
});
