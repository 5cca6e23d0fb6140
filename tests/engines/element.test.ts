/** The element plays on both threads, and in a frame with an opaque origin. */
import { expect, inject } from 'vitest';
import { start } from './engines.ts';
import { startWebKit } from './drivers/webkit.ts';
import { blankPage, engine, inPage, test } from './fixtures.ts';
import { colorsIn, pictureIn } from './pictures.ts';

import { findPreset, presetValues } from '../../src/parameters/presets.ts';
import type { CssCase } from './page/element.ts';

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

test('a morph of the page changes nothing that a call of set() has changed', async ({ load }) => {
  const page = await load<Page>(ELEMENT);
  expect(await page.changesOverSet()).toEqual([]);
});

const COLOR = 'style.smokeColor';
const BACKDROP = 'style.backdrop';
const { [COLOR]: ownColor, [BACKDROP]: ownBackdrop, 'style.ramp': ownRamp } = presetValues(findPreset('wisp')!);
const styleSheets: CssCase[] = [
  { css: ':root { --cartoon-smoke-color: tomato }', values: { [COLOR]: '#ff6347', 'style.ramp': '' } },
  { css: 'body { --cartoon-smoke-color: hsl(240 100% 50%) }', values: { [COLOR]: '#0000ff' } },
  { css: 'cartoon-smoke { --cartoon-smoke-color: #0f08 }', values: { [COLOR]: '#00ff00' } },
  { css: 'cartoon-smoke { color: #123; --cartoon-smoke-color: currentColor }', values: { [COLOR]: '#112233' } },
  {
    css: ':root { --brand: #fe0; --cartoon-smoke-backdrop: var(--brand) }',
    values: { [COLOR]: ownColor, [BACKDROP]: '0:ffee00,1:ffee00', 'style.ramp': ownRamp },
  },
  {
    css: '@media (min-width: 1px) { cartoon-smoke { --cartoon-smoke-backdrop: color(srgb 1 0 0.5) } }',
    values: { [BACKDROP]: '0:ff0080,1:ff0080' },
  },
  { css: 'cartoon-smoke { --cartoon-smoke-color: 12px }', values: { [COLOR]: ownColor, [BACKDROP]: ownBackdrop } },
  { css: 'cartoon-smoke { --cartoon-smoke-ink: red }', values: { 'style.inkColor': '#012345' } },
  { css: '', values: { [COLOR]: ownColor } },
];

test('style sheets set colours, and attributes override them', async ({ load }) => {
  const page = await load<Page>(ELEMENT);
  expect(await page.valuesByCss(styleSheets)).toEqual(styleSheets.map(({ values }) => values));
});

const zoomed: Record<string, string>[] = [
  {},
  ...[0.5, 0.9, 1.25, 1.5, 2].map((zoom) => ({ html: `zoom: ${zoom}` })),
  { body: 'zoom: 1.5' },
  { '#outer': 'zoom: 2' },
  { html: 'zoom: 0.5', '#outer': 'zoom: 2.5' },
  { html: 'zoom: 1.5', '#outer': 'transform: scale(.8); transform-origin: 0 0' },
];

for (const styles of zoomed) {
  const name = JSON.stringify(styles);
  test(`in a zoomed page, pixels, presses and obstacles are those of the element: ${name}`, async ({ load }) => {
    const page = await load<Page>(ELEMENT);
    const { pixels, press, obstacle } = await page.measuredIn(styles);
    // A transform does not change the size of the picture.
    expect(pixels).toBeCloseTo(name.includes('transform') ? 1.25 : 1, 1);
    expect(Math.abs((press[0] as number) - 30)).toBeLessThan(5);
    expect(Math.abs((press[1] as number) - 20)).toBeLessThan(5);
    // The middle of the box is 30 px left of and 20 px above that of the element.
    expect(obstacle[0]).toBeCloseTo(-0.3, 1);
    expect(obstacle[1]).toBeCloseTo(0.2, 1);
    expect(obstacle[2]).toBeCloseTo(0.1, 1);
  });
}

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
