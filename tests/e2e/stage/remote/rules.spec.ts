/** Pages and browsers with restrictions: smoke uses a fallback, or reports an error of a documented class. */
import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { loadModule } from '../../../support/modules.ts';
import { setTimeouts } from './context.ts';

type Cases = typeof import('./stage.cases.ts');
type Shared = typeof import('../../../../src/stage/remote/openHere.ts');

// Source modules on separate pages. The browser logs what it blocks itself.
test.use({ allowed: /Content Security|TrustedScriptURL|Trusted Type|404|WebAssembly|context lost/i });

/** Opens two stages on a page: their threads, the number of canvases and workers, and the pictures. */
async function openTwo(page: Page) {
  const cases = await loadModule<Cases>(page, '/tests/e2e/stage/remote/stage.cases.ts');
  return cases.evaluate(async (module) => {
    const seen = module.watch();
    const opened = [await module.open(), await module.open()];
    await opened[1].stage.step(60);
    const colors = await module.colorsShown(opened[1].canvas, 10);
    return { threads: opened.map(({ stage }) => stage.thread), workers: seen.workers, colors };
  });
}

/** @param policy Content-Security-Policy of the page */
async function openUnder(page: Page, policy = ''): Promise<void> {
  await page.goto(`/tests/support/blank.html?${new URLSearchParams({ policy })}`);
}

async function expectMain(page: Page, workers: number): Promise<void> {
  const report = await openTwo(page);
  expect(report.threads).toEqual(['main', 'main']);
  expect(report.workers, 'workers tried').toBe(workers);
  expect(report.colors).toBeGreaterThan(10);
}

test('a page that forbids workers has smoke on the main thread, without a retry', async ({ page }) => {
  await openUnder(page, "worker-src 'none'");
  await expectMain(page, 1);
});

test('required Trusted Types allow the worker by the policy cartoon-smoke', async ({ page }) => {
  await openUnder(page, "require-trusted-types-for 'script'; trusted-types cartoon-smoke");
  const report = await openTwo(page);
  expect(report.threads).toEqual(['worker', 'worker']);
  expect(report.colors).toBeGreaterThan(10);
});

test('required Trusted Types without our policy run smoke on the main thread @long', async ({ page }) => {
  await openUnder(page, "require-trusted-types-for 'script'; trusted-types 'none'");
  await expectMain(page, 0);
});

test('without the worker file smoke runs on the main thread @long', async ({ page }) => {
  await page.route('**/remote/worker.ts*', (route) => route.fulfill({ status: 404 }));
  await openUnder(page);
  await expectMain(page, 1);
});

test('without WebGL2 in workers smoke runs on the main thread, with a new canvas', async ({ page }) => {
  await page.route('**/remote/worker.ts*', async (route) => {
    const response = await route.fetch();
    const body = `OffscreenCanvas.prototype.getContext = () => null;\n${await response.text()}`;
    await route.fulfill({ response, body });
  });
  await openUnder(page);
  await expectMain(page, 1);
});

test('a browser without OffscreenCanvas has smoke on the main thread @long', async ({ page }) => {
  await page.addInitScript(() => {
    delete (globalThis as { OffscreenCanvas?: unknown }).OffscreenCanvas;
    delete (HTMLCanvasElement.prototype as { transferControlToOffscreen?: unknown }).transferControlToOffscreen;
  });
  await openUnder(page);
  await expectMain(page, 0);
});

test('WASM forbidden by the page is a LoadError on the main thread', async ({ page }) => {
  await openUnder(page, "script-src 'self'; worker-src 'none'");
  const cases = await loadModule<Cases>(page, '/tests/e2e/stage/remote/stage.cases.ts');
  expect((await cases.evaluate((module) => module.thrownBy(() => module.open())))?.name).toBe('LoadError');
});

test('a context that is not restored emits one ContextError, and can still be restored', async ({ page }) => {
  await openUnder(page);
  const cases = await loadModule<Cases>(page, '/tests/e2e/stage/remote/stage.cases.ts');
  const shared = await loadModule<Shared>(page, '/src/stage/remote/openHere.ts');
  const notified = await cases.evaluateHandle(async (module) => {
    const errors: string[] = [];
    const { stage } = await module.open({ thread: 'main' });
    stage.on('error', ({ name }) => errors.push(name));
    return { errors, stage };
  });
  await page.clock.install({ time: 0 });
  // From here on the test controls the clock.
  await page.clock.pauseAt(60_000);
  const device = await shared.evaluateHandle(({ threadDevice }) => threadDevice.acquire()!);
  const losing = await device.evaluateHandle(async ({ canvas, renderer }) => {
    const extension = renderer.getContext().getExtension('WEBGL_lose_context')!;
    // The context is lost at once; the timeout starts with its event.
    const lost = new Promise((resolve) => canvas.addEventListener('webglcontextlost', resolve, { once: true }));
    extension.loseContext();
    await lost;
    return extension;
  });
  expect(await device.evaluate(({ isUsable }) => isUsable)).toBe(false);
  await page.clock.fastForward(9_000);
  expect(await notified.evaluate(({ errors }) => errors)).toEqual([]);
  await page.clock.fastForward(60_000);
  expect(await notified.evaluate(({ errors }) => errors)).toEqual(['ContextError']);
  const late = await notified.evaluate(
    ({ stage }) => new Promise((resolve) => stage.on('error', ({ name }) => resolve(name))),
  );
  expect(late, 'what somebody hears who comes later').toBe('ContextError');
  await losing.evaluate((extension) => extension.restoreContext());
  await expect.poll(() => device.evaluate(({ isUsable }) => isUsable)).toBe(true);
});

test('a device disposed while its context was lost releases the restored context @long', async ({ page }) => {
  await openUnder(page);
  const devices = await loadModule<typeof import('../../../../src/renderer/gpu/device.ts')>(
    page,
    '/src/renderer/gpu/device.ts',
  );
  const isLost = await devices.evaluate(async ({ createDevice }) => {
    const device = createDevice(new OffscreenCanvas(1, 1));
    const context = device.renderer.getContext();
    const losing = context.getExtension('WEBGL_lose_context')!;
    const happens = (event: string) =>
      new Promise((resolve) => device.canvas.addEventListener(event, resolve, { once: true }));
    const lost = happens('webglcontextlost');
    losing.loseContext();
    await lost;
    // The browser decides about restoring only after the event's last listener.
    await new Promise((resolve) => setTimeout(resolve));
    device.dispose();
    const restored = happens('webglcontextrestored');
    losing.restoreContext();
    await restored;
    return context.isContextLost();
  });
  expect(isLost).toBe(true);
});

test('a context lost during the start shows smoke when it is restored', async ({ page }) => {
  await openUnder(page);
  await setTimeouts(page, 'endless');
  const cases = await loadModule<Cases>(page, '/tests/e2e/stage/remote/stage.cases.ts');
  const shared = await loadModule<Shared>(page, '/src/stage/remote/openHere.ts');
  const differing = await cases.evaluate(async (module, { threadDevice }) => {
    const device = threadDevice.acquire()!;
    const losing = device.renderer.getContext().getExtension('WEBGL_lose_context')!;
    const happens = (event: string) =>
      new Promise((resolve) => device.canvas.addEventListener(event, resolve, { once: true }));
    const opening = module.open({ thread: 'main' });
    const lost = happens('webglcontextlost');
    losing.loseContext();
    await lost;
    const { stage, canvas } = await opening;
    await stage.step(60);
    losing.restoreContext();
    await happens('webglcontextrestored');
    const other = await module.open({ thread: 'main' });
    await other.stage.step(60);
    return module.differingShown(canvas, await module.pixelsOf(await other.stage.picture()));
  }, shared);
  expect(differing).toBe(0);
});
