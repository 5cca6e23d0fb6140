/** The element plays on both threads, and in a frame with an opaque origin. */
import { expect, inject } from 'vitest';
import { start } from './engines.ts';
import { startWebKit } from './drivers/webkit.ts';
import { blankPage, engine, inPage, test } from './fixtures.ts';
import { colorsIn, pictureIn } from './pictures.ts';

type Page = typeof import('./page/element.ts');

const ELEMENT = '/tests/engines/page/element.ts';
const lacksWorkers = engine.title === 'WebKit' && !engine.isPlaywrights;

if (!engine.isPlaywrights || engine.title === 'Chromium') {
  test('it draws in software', async ({ task }) => {
    const browser = await start(engine);
    const renderer = await browser.renderer();
    await browser.close();
    task.meta.note = `renderer  ${engine.title}  ${renderer}`;
    expect(renderer).toMatch(engine.title === 'Chromium' ? /SwiftShader/ : /llvmpipe/);
  });
}

test('it plays on the main thread', async ({ load }) => {
  const page = await load<Page>(ELEMENT);
  expectPlayed(await page.playElement('main'), 'main');
});

if (lacksWorkers) {
  test('WebKitGTK has no WebGL in workers, and it plays on the main thread', async ({ load }) => {
    const page = await load<Page>(ELEMENT);
    expectPlayed(await page.playElement('auto'), 'main');
  });

  test('it plays in a worker if WebGL in workers is enabled in WebKitGTK, as in Safari', async () => {
    const browser = await startWebKit(engine.path!, ['AllowWebGLInWorkers']);
    await browser.open(blankPage());
    const played = await inPage<Page>(browser, ELEMENT).playElement('auto');
    await browser.close();
    expectPlayed(played, 'worker');
  });
} else {
  test('it plays in a worker', async ({ load }) => {
    const page = await load<Page>(ELEMENT);
    expectPlayed(await page.playElement('auto'), 'worker');
  });
}

test('a morph of the page changes nothing that the user has paused or started', async ({ load }) => {
  const page = await load<Page>(ELEMENT);
  expect(await page.changesOverUser()).toEqual([]);
});

test('embed.html plays in a sandbox that allows only scripts', async ({ load }) => {
  const page = await load<Page>(ELEMENT);
  const address = `${inject('site')}/embed.html#v=1&preset=wisp&simulation.maxParticles=300&puff.variations=1`;
  expectPlayed(await page.playFrame(address), 'frame');
});

function expectPlayed({ thread, steps, picture }: Awaited<ReturnType<Page['playElement']>>, where: string): void {
  expect(thread).toBe(where);
  expect(steps).toBeGreaterThanOrEqual(30);
  expect(colorsIn(pictureIn(picture))).toBeGreaterThan(20);
}
