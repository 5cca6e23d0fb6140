import type { Page, Route } from '@playwright/test';
import { expect, longIf, test } from '../../support/fixtures.ts';
import { keepContexts, loseForGood, restoreLate } from '../stage/remote/context.ts';
import { ask, hold, isComplete, LIGHT, open } from './page.ts';

test('without WebGL2 the page shows an error and advice', async ({ page }) => {
  await page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: never[]) {
      return kind === 'webgl2' ? null : Reflect.apply(original, this, [kind, ...rest]);
    } as typeof original;
  });
  await page.goto('/');
  const alert = page.getByRole('alert');
  await expect(alert.getByRole('heading')).toHaveText('This browser cannot show the smoke');
  await expect(alert).toContainText('WebGL2');
  await expect(alert).toContainText('hardware acceleration');
  await expect(alert.getByRole('button', { name: 'Reload' })).toBeVisible();
});

test.describe('a download that fails', () => {
  test.use({ allowed: /Failed to load resource|net::ERR_FAILED/ });

  test('shows an error, and reloading recovers', async ({ page }) => {
    await page.route('**/*.wasm*', (route) => route.abort());
    await page.goto('/?paused=1#v=1&simulation.maxParticles=100');
    const alert = page.getByRole('alert');
    await expect(alert.getByRole('heading')).toHaveText('The smoke could not be loaded');
    await page.unroute('**/*.wasm*');
    await alert.getByRole('button', { name: 'Reload' }).click();
    await page.waitForFunction(() => window.cartoonSmoke !== undefined);
    await expect(alert).toHaveCount(0);
  });

  const FLOW = { 'flows.0.points': '0:0:0,0:1:0', 'flows.0.speed': 1 };
  const steps = (page: Page) => ask(page, ({ stats }) => stats.steps);
  const lacksFlows = (page: Page) => ask(page, ({ running }) => running.simulation.lacksForces);

  for (const [why, fail] of [
    ['offline', (route: Route) => route.abort()],
    ['404', (route: Route) => route.fulfill({ status: 404 })],
  ] as const)
    test(`leaves the smoke running without flows, and can be tried again: ${why}`, async ({ page }) => {
      await open(page, LIGHT);
      await page.route('**/*.wasm', fail);
      await page.evaluate((flow) => window.cartoonSmoke!.set(flow), FLOW);
      const notice = page.getByText(/^The simulator could not be loaded/);
      const retry = page.getByRole('button', { name: 'Try again' });
      await expect(notice).toBeVisible();
      const before = await steps(page);
      await expect.poll(() => steps(page)).toBeGreaterThan(before);
      await retry.click();
      await expect(notice).toBeVisible();
      expect(await lacksFlows(page)).toBe(true);
      await page.unroute('**/*.wasm');
      await retry.click();
      await expect.poll(() => lacksFlows(page)).toBe(false);
      await expect(notice).toHaveCount(0);
    });

  test('shows its progress while the smoke waits for flows', async ({ page }) => {
    await open(page, LIGHT);
    const arrive = await hold(page, '**/*.wasm');
    await page.evaluate((flow) => window.cartoonSmoke!.set(flow), FLOW);
    const progress = page.getByRole('progressbar', { name: 'Loading the simulator for flows and shapes…' });
    await expect(progress).toBeVisible();
    const before = await steps(page);
    arrive();
    await expect(progress).toHaveCount(0);
    await expect.poll(() => steps(page)).toBeGreaterThan(before);
    expect(await lacksFlows(page)).toBe(false);
  });
});

test.describe('a context that is lost for good', () => {
  test.use({ allowed: /context lost|context restored|CONTEXT_LOST/i });

  for (const query of ['', 'paused=1&']) {
    const tag = longIf(query !== '');
    test(`shows an error until the browser restores it or the page is loaded again: ?${query}${tag}`, async ({
      page,
    }) => {
      await keepContexts(page);
      await open(page, `?${query}t=1${LIGHT}`);
      const alert = page.getByRole('alert');
      const usable = page.locator('#interface > :not([inert], [role=alert])');
      const time = () => ask(page, (stage) => stage.stats.time);
      const before = await time();
      await loseForGood(page);
      await expect(alert.getByRole('heading')).toHaveText('The graphics context was lost');
      expect(await usable.count()).toBe(0);
      await restoreLate(page);
      await expect(alert).toHaveCount(0);
      expect(await usable.count()).toBeGreaterThan(0);
      if (query) expect(await time()).toBe(before);
      else await expect.poll(time).toBeGreaterThan(before);
      await loseForGood(page);
      await alert.getByRole('button', { name: 'Reload' }).click();
      await isComplete(page);
      await expect(alert).toHaveCount(0);
    });
  }
});

test('a GPU that ignores written depth draws flat smoke, with a message', async ({ page }) => {
  await page.addInitScript(() => {
    const { shaderSource } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
      shaderSource.call(this, shader, source.replaceAll(/gl_FragDepth = .*;/g, ''));
    };
  });
  await open(page, `?paused=1&t=1${LIGHT}`);
  await expect(page.getByText('so they are flat and meet in straight lines')).toBeVisible();
  await expect.poll(() => ask(page, (stage) => stage.stats.bodiesDrawn)).toBeGreaterThan(0);
  expect(await ask(page, (stage) => stage.stats.writesDepth)).toBe(false);
});
