import { AxeBuilder } from '@axe-core/playwright';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { watchConsole } from '../../../support/consoleErrors.ts';
import { expect, frames, MODULES, scrollPage, stands, test, WISP } from '../../../support/embed.ts';
import { longIf } from '../../../support/fixtures.ts';
import { gpuKeepsUp } from '../../../support/gpuKeepsUp.ts';

const BOX = 'style="width: 200px; height: 150px"';

test.describe('with prefers-reduced-motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  test('shows a still frame with smoke until the user plays', async ({ page, openPage }) => {
    // Code that a test evaluates counts as user activation.
    await page.addInitScript(() => Object.defineProperty(navigator, 'userActivation', { value: { isActive: false } }));
    await openPage(`<cartoon-smoke ${WISP} ${BOX}></cartoon-smoke>`);
    await stands(page);
    const smoke = page.locator('cartoon-smoke');
    const steps = async () => (await smoke.evaluate((element: CartoonSmokeElement) => element.stats())).steps;
    expect(await steps()).toBe(240);
    // A page's own call of play() is not a user gesture.
    await smoke.evaluate((element: CartoonSmokeElement) => element.play());
    expect(await smoke.evaluate((element: CartoonSmokeElement) => element.playing)).toBe(false);
    expect(await steps()).toBe(240);
    await page.getByRole('button', { name: 'Play smoke' }).click();
    await expect.poll(steps).toBeGreaterThan(240);
    await expect(page.getByRole('button', { name: 'Pause smoke' })).toBeVisible();
  });
});

test('on a page that scrolls', async ({ page, openPage }) => {
  const style = '@media (prefers-color-scheme: dark) { :root { --cartoon-smoke-ink: white } }';
  await openPage(`<cartoon-smoke ${WISP} ${BOX}></cartoon-smoke><div style="height: 3000px"></div>`, { style });
  await stands(page);
  const smoke = page.locator('cartoon-smoke');
  const steps = async () => (await smoke.evaluate((element: CartoonSmokeElement) => element.stats())).steps;
  await test.step('it rests out of view and continues in view', async () => {
    await scrollPage(page, 2000);
    const before = await steps();
    await frames(page, 10);
    expect(await steps()).toBe(before);
    expect(await smoke.evaluate((element: CartoonSmokeElement) => element.playing)).toBe(true);
    await scrollPage(page, 0);
    await expect.poll(steps).toBeGreaterThan(before);
  });
  await test.step('it emits statechange once when it pauses and once when it plays', async () => {
    const notified = await smoke.evaluate((element: CartoonSmokeElement) => {
      const heard: boolean[] = [];
      element.addEventListener('statechange', ({ detail }) => heard.push(detail.playing));
      const button = element.shadowRoot!.querySelector('button')!;
      button.click();
      button.click();
      return heard;
    });
    expect(notified).toEqual([false, true]);
  });
  await test.step('its colours follow prefers-color-scheme', async () => {
    const ink = () => smoke.evaluate(async (element: CartoonSmokeElement) => (await element.get())['style.inkColor']);
    const light = await ink();
    expect(light).not.toBe('#ffffff');
    await page.emulateMedia({ colorScheme: 'dark' });
    await expect.poll(ink).toBe('#ffffff');
    await page.emulateMedia({ colorScheme: 'light' });
    await expect.poll(ink).toBe(light);
  });
  await test.step('its button is not printed', async () => {
    const frame = smoke.locator('.frame');
    const states = ['shown', 'shown still', 'failed lost', await frame.evaluate(({ classList }) => String(classList))];
    for (const state of states) {
      await frame.evaluate((element, name) => element.setAttribute('class', `frame ${name}`), state);
      await page.emulateMedia({ media: 'print' });
      await expect(frame.locator('button'), state).toBeHidden();
      await page.emulateMedia({ media: 'screen' });
      await expect(frame.locator('button'), state).toBeVisible();
    }
  });
  await test.step('it has a pause button, also by keyboard, and stays paused out of view and back', async () => {
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    await expect(smoke).toHaveAttribute('paused');
    const before = await steps();
    await scrollPage(page, 2000);
    await scrollPage(page, 0);
    await expect(page.getByRole('button', { name: 'Play smoke' })).toBeInViewport();
    await frames(page, 10);
    expect(await steps()).toBe(before);
  });
});

test('names its canvas and its button by attributes, also later, and passes axe', async ({ page, openPage }) => {
  await openPage(
    `<main><h1>A page</h1><cartoon-smoke ${WISP} paused alt="Eine Tasse Tee" label-play="Abspielen" label-pause="Anhalten" ${BOX}></cartoon-smoke></main>`,
  );
  await stands(page);
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id }) => id)).toEqual([]);
  await expect(page.getByRole('img', { name: 'Eine Tasse Tee' })).toBeVisible();
  await page.getByRole('button', { name: 'Abspielen' }).click();
  await expect(page.getByRole('button', { name: 'Anhalten' })).toBeVisible();
  const smoke = page.locator('cartoon-smoke');
  await smoke.evaluate((element: CartoonSmokeElement) => Object.assign(element, { labelPause: 'Stop', alt: '' }));
  await expect(page.getByRole('button', { name: 'Stop' })).toBeVisible();
  await expect(page.getByRole('img')).toHaveCount(0);
});

test('starts far below the viewport with loading=eager or on a method call; CSS properties style its button', async ({
  page,
  openPage,
}) => {
  const parts = `cartoon-smoke::part(button) { border-radius: 3px } cartoon-smoke::part(canvas) { opacity: .5 }
    cartoon-smoke { --cartoon-smoke-button-size: 50px; --cartoon-smoke-button-inset: 4px;
      --cartoon-smoke-button-color: rgb(1, 2, 3); --cartoon-smoke-button-background: rgb(4, 5, 6);
      --cartoon-smoke-focus-color: rgb(7, 8, 9) }`;
  await openPage(
    `<div style="height: 5000px">An article</div>
    <cartoon-smoke id="eager" loading="eager" ${WISP} paused ${BOX}></cartoon-smoke>
    <cartoon-smoke id="asked" ${WISP} paused ${BOX}></cartoon-smoke>
    <cartoon-smoke id="lazy" ${WISP} paused ${BOX}></cartoon-smoke>`,
    { style: parts },
  );
  await stands(page, '#eager');
  const asked = await page.locator('#asked').evaluate((smoke: CartoonSmokeElement) => smoke.get());
  expect(asked.scene).toBe('wisp');
  const canvases = await page.evaluate(() =>
    [...document.querySelectorAll('cartoon-smoke')].map((smoke) => Boolean(smoke.shadowRoot!.querySelector('canvas'))),
  );
  expect(canvases).toEqual([true, true, false]);
  const looks = await page.locator('#eager').evaluate((smoke) => {
    const [button, canvas] = ['button', 'canvas'].map((part) => smoke.shadowRoot!.querySelector<HTMLElement>(part)!);
    button.focus({ focusVisible: true });
    const { width, borderRadius, bottom, color, backgroundColor, outlineColor } = getComputedStyle(button);
    return [width, borderRadius, bottom, color, backgroundColor, outlineColor, getComputedStyle(canvas).opacity];
  });
  expect(looks).toEqual(['50px', '3px', '4px', 'rgb(1, 2, 3)', 'rgb(4, 5, 6)', 'rgb(7, 8, 9)', '0.5']);
});

test('draws 60 frames per second on a 240 Hz display', async ({ page, openPage }) => {
  await page.addInitScript(gpuKeepsUp);
  await openPage(`<cartoon-smoke ${WISP} ${BOX}></cartoon-smoke>`);
  await stands(page);
  const drawn = await page.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement) => {
    const stage = await smoke.stage;
    const native = window.requestAnimationFrame;
    const waiting = new Map<number, FrameRequestCallback>();
    let latest = 0;
    window.requestAnimationFrame = (act) => {
      waiting.set(++latest, act);
      return latest;
    };
    window.cancelAnimationFrame = (request) => waiting.delete(request);
    while (waiting.size === 0) await new Promise((resolve) => native(resolve));
    const count = { frames: 0, steps: (await smoke.stats()).steps };
    stage.on('frame', () => (count.frames += 1));
    const begin = performance.now() + 1_000;
    for (let frame = 0; frame < 240; ++frame) {
      const due = [...waiting.values()];
      waiting.clear();
      for (const act of due) act(begin + (frame * 1_000) / 240);
    }
    return { ...count, steps: (await smoke.stats()).steps - count.steps };
  });
  expect(Math.abs(drawn.frames - 60)).toBeLessThanOrEqual(1);
  // The time before the first frame counts, too, up to the limit.
  expect(drawn.steps).toBeGreaterThan(55);
});

test.describe('with all pixels', () => {
  test.use({ deviceScaleFactor: 1 });

  test('follows the pixel ratio when the page is zoomed while it plays', async ({ page, openPage }) => {
    await openPage(`<cartoon-smoke ${WISP} ${BOX}></cartoon-smoke>`);
    await stands(page);
    const smoke = page.locator('cartoon-smoke');
    const size = () =>
      smoke.evaluate(async (element) => {
        const canvas = element.shadowRoot!.querySelector('canvas')!;
        const { width, height } = await createImageBitmap(canvas);
        return [width, height, canvas.clientWidth];
      });
    const session = await page.context().newCDPSession(page);
    for (const zoom of [1, 2, 1.25]) {
      // As browser zoom: fewer CSS pixels with more device pixels each.
      const [width, height] = [640 / zoom, 360 / zoom];
      const metrics = { width, height, mobile: false, deviceScaleFactor: zoom };
      await session.send('Emulation.setDeviceMetricsOverride', metrics);
      await expect.poll(size).toEqual([200 * zoom, Math.round(150 * zoom), 200]);
    }
    const steps = async () => (await smoke.evaluate((element: CartoonSmokeElement) => element.stats())).steps;
    const before = await steps();
    await expect.poll(steps).toBeGreaterThan(before);
  });
});

test('works without a size, hidden, in a shadow tree, in a dialog and in a table cell', async ({ page, openPage }) => {
  await openPage(`<div id="box" style="width: 200px; height: 150px"><cartoon-smoke ${WISP} paused start="1" style="height: 100%"></cartoon-smoke></div>
    <dialog></dialog><table><tr><td></td></tr></table><div id="tree"></div>`);
  await stands(page);
  const sized = (width: string, height: string) =>
    page.evaluate(
      ([w, h]) => Object.assign(document.querySelector<HTMLElement>('#box')!.style, { width: w, height: h }),
      [width, height],
    );
  const smoke = page.locator('cartoon-smoke');
  const before = await smoke.screenshot();
  await sized('0', '0');
  await smoke.evaluate((element: CartoonSmokeElement) => element.step(0));
  await sized('200px', '150px');
  await expect.poll(async () => before.equals(await smoke.screenshot())).toBe(true);
  await smoke.evaluate((element: CartoonSmokeElement) => (element.hidden = true));
  await expect(smoke).toBeHidden();
  await smoke.evaluate((element: CartoonSmokeElement) => element.step(0));
  await smoke.evaluate((element: CartoonSmokeElement) => (element.hidden = false));
  await expect.poll(async () => before.equals(await smoke.screenshot())).toBe(true);
  const kept = await smoke.evaluate(async (element: CartoonSmokeElement) => {
    const root = document.querySelector('#tree')!.attachShadow({ mode: 'open' });
    const dialog = document.querySelector('dialog')!;
    const widths = [];
    for (const place of [root, dialog, document.querySelector('td')!]) {
      place.append(element);
      dialog.showModal();
      widths.push(Math.round(element.getBoundingClientRect().width));
      dialog.close();
    }
    return { widths, steps: (await element.stats()).steps };
  });
  expect(kept.steps).toBe(60);
  for (const width of kept.widths) expect(width).toBeGreaterThan(100);
});

test('keeps its box and its button on a page that unsets, rotates and blurs everything', async ({ page, openPage }) => {
  await openPage(
    `<main style="transform: rotate(2deg) scale(.9); filter: hue-rotate(20deg)"><div style="width: 320px"><cartoon-smoke ${WISP} paused></cartoon-smoke></div></main>`,
    { style: '* { all: unset !important }' },
  );
  await stands(page);
  const box = await page.locator('cartoon-smoke').evaluate((element) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
    return { ratio: canvas.width / canvas.height, width: canvas.width };
  });
  expect(box.width).toBeGreaterThan(250);
  expect(box.ratio).toBeCloseTo(16 / 9, 1);
  await page.getByRole('button', { name: 'Play smoke' }).click();
  await expect(page.getByRole('button', { name: 'Pause smoke' })).toBeVisible();
});

const MISTAKES = `<cartoon-smoke ${WISP} ${BOX} class="a" data-a="b" emision-rate="3" emission-lifetime="9999" collide=".none"></cartoon-smoke><cartoon-smoke ${WISP.replace('wisp', 'wips')} ${BOX}></cartoon-smoke>`;

for (const [build, warnings] of [
  ['element', []],
  [
    'development/element',
    [
      /no attribute .emision-rate.. Did you mean .emission-rate.\?$/,
      /no preset .wips./,
      /collide=.\.none. matches no element/,
      /emission-lifetime|emission\.lifetime|Lifetime/,
      /^element\.stage: \.set was read from a promise/,
    ],
  ],
] as const) {
  const tag = longIf(warnings.length === 0);
  test(`${build}.js writes ${warnings.length} warnings on two elements with the same mistakes${tag}`, async ({
    page,
    openPage,
  }) => {
    const lines = watchConsole(page);
    await openPage(MISTAKES + MISTAKES, { script: MODULES.replace('element.js', `${build}.js`) });
    await stands(page);
    await stands(page, 'cartoon-smoke:last-of-type');
    await page.evaluate(() => {
      for (const { stage } of document.querySelectorAll('cartoon-smoke')) void (stage as never as { set: unknown }).set;
    });
    // Longer than the element waits for what its selector names.
    await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 2500)));
    await frames(page, 2);
    expect(lines).toHaveLength(warnings.length);
    warnings.forEach((warning, index) => expect(lines.toSorted()[index]).toMatch(warning));
  });
}

test.describe('with a failed download', () => {
  test.use({ allowed: /ERR_FAILED/ });

  test('the development build writes the error once', async ({ page, openPage }) => {
    const lines = watchConsole(page);
    await page.route('**/bindings_bg.wasm', (route) => route.abort());
    const script = MODULES.replace('element.js', 'development/element.js');
    await openPage(`<cartoon-smoke ${WISP} ${BOX}></cartoon-smoke>`.repeat(2), { script });
    const failures = () => lines.filter((line) => line.startsWith('<cartoon-smoke>: LoadError: '));
    await expect.poll(failures).toHaveLength(1);
    await frames(page, 10);
    expect(failures()).toHaveLength(1);
  });
});
