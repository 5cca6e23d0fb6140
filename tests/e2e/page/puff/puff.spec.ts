/** `puff()` on a page of somebody else, with the files of the package. */
import type { Page } from '@playwright/test';
import type { Puff } from '../../../../src/page/puff/puff.ts';
import { expect, frames, scrollPage, test as base } from '../../../support/embed.ts';
import { longIf } from '../../../support/fixtures.ts';
import { watchConsole } from '../../../support/consoleErrors.ts';
import { keepContexts, loseForGood } from '../../stage/remote/context.ts';

declare const puff: Puff;

const SCRIPT = `<script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js" } }</script>
  <script type="module">
    import { puff } from '/package/dist/puff.js';
    Object.assign(window, { puff });
  </script>`;
const BODY = `<h1>A page</h1><button id="button" style="margin: 40px">Press</button><p id="below">Text</p>
  <div style="height: 2000px"></div>`;
const STYLE = 'canvas { display: none; width: 3px !important; opacity: 0; z-index: -5 !important }';

const test = base.extend<{ host: (options?: { script?: string; body?: string }) => Promise<void> }>({
  host: async ({ page, openPage }, use) => {
    // Fewer pixels are faster.
    await page.setViewportSize({ width: 320, height: 240 });
    await use(async ({ script = SCRIPT, body = BODY } = {}) => {
      await openPage(body, { script, style: STYLE });
      await page.waitForFunction(() => 'puff' in window);
    });
  },
});

const canvases = (page: Page) => page.locator('canvas');

/**
 * Sum of the opacity of the pixels of the canvas, and the middle of the smoke in client pixels. The smoke moves in the canvas,
 * and how far depends on the machine: `top` is that of the canvas.
 */
function smoke(page: Page): Promise<{ amount: number; x: number; y: number; top: number }> {
  return page.evaluate(async () => {
    const canvas = document.querySelector('canvas');
    if (!canvas) return { amount: 0, x: NaN, y: NaN, top: NaN };
    const picture = await createImageBitmap(canvas);
    const copy = new OffscreenCanvas(picture.width, picture.height);
    const context = copy.getContext('2d')!;
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, picture.width, picture.height);
    let [amount, x, y] = [0, 0, 0];
    for (let at = 3; at < data.length; at += 4) {
      const pixel = (at - 3) / 4;
      amount += data[at];
      x += data[at] * (pixel % picture.width);
      y += data[at] * Math.floor(pixel / picture.width);
    }
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const middle = [left + (x / amount / picture.width) * width, top + (y / amount / picture.height) * height];
    return { amount, x: middle[0], y: middle[1], top };
  });
}

/** Waits for smoke and returns it. A second read could come after its end. */
async function visibleSmoke(page: Page, least = 1000): ReturnType<typeof smoke> {
  let seen = await smoke(page);
  await expect.poll(async () => (seen = await smoke(page)).amount).toBeGreaterThan(least);
  return seen;
}

test('draws smoke around a button, lets clicks through, and leaves nothing behind', async ({ page, host }) => {
  const lines = watchConsole(page);
  await host();
  await page.evaluate(() => {
    Object.assign(window, { shift: 0, clicks: 0 });
    new PerformanceObserver((list) =>
      list
        .getEntries()
        .forEach(
          ({ value }: PerformanceEntry & { value?: number }) => (
            Reflect.get(window, 'shift'),
            Reflect.set(window, 'shift', Reflect.get(window, 'shift') + value)
          ),
        ),
    ).observe({ type: 'layout-shift', buffered: true });
    document.querySelector('button')!.onclick = () => Reflect.set(window, 'clicks', Reflect.get(window, 'clicks') + 1);
  });
  const before = await page.evaluate(() => [
    document.documentElement.scrollWidth,
    document.documentElement.scrollHeight,
  ]);
  const over = page.evaluate(() => puff(document.querySelector('button')));
  const { x, y } = await visibleSmoke(page);
  const box = (await page.locator('#button').boundingBox())!;
  expect(Math.abs(x - box.x - box.width / 2)).toBeLessThan(60);
  expect(Math.abs(y - box.y - box.height / 2)).toBeLessThan(80);
  await page.locator('#button').click();
  expect(await page.evaluate(() => Reflect.get(window, 'clicks') as number)).toBe(1);
  await over;
  await frames(page, 4);
  expect((await smoke(page)).amount).toBe(0);
  const after = await page.evaluate(() => [
    document.documentElement.scrollWidth,
    document.documentElement.scrollHeight,
  ]);
  expect(after).toEqual(before);
  expect(page.workers()).toHaveLength(1);
  // 10 s later.
  await expect(canvases(page)).toHaveCount(0);
  await expect.poll(() => page.workers().length).toBe(0);
  expect(await page.evaluate(() => Reflect.get(window, 'shift') as number)).toBe(0);
  expect(lines).toEqual([]);
});

test('writes the text of an element, and needs one', async ({ page, host }) => {
  await host();
  const refused = await page.evaluate(async () => {
    const [button, empty] = [document.createElement('button'), document.createElement('button')];
    button.textContent = 'Save';
    empty.style.cssText = 'width: 50px; height: 20px';
    document.body.append(button, empty);
    const written = puff(button, { effect: 'form', count: 20, duration: 0 });
    const message = await puff(empty, { effect: 'form' }).catch((error: Error) => error.message);
    await written;
    return message;
  });
  expect(refused).toContain('text cannot be undefined: it takes 1 to 40 characters');
});

test('uses one canvas and one worker for many calls, and resolves each', async ({ page, host }) => {
  await host();
  const ended = await page.evaluate(async () => {
    const calls = puff.effects.flatMap((effect) => [
      puff({ x: 100, y: 100 }, { effect, text: 'hm', count: 4, duration: 0.2 }),
      puff(undefined, {
        effect,
        text: 'hm',
        count: 4,
        duration: 0.2,
        color: 'tomato',
        preset: 'lamp-noir',
        size: 2,
        direction: 20,
        spread: 40,
        speed: 0.5,
        seed: 3,
        layer: 'below',
        zIndex: 7,
      }),
    ]);
    return (await Promise.allSettled(calls)).map(({ status }) => status);
  });
  expect(ended).toEqual(Array(20).fill('fulfilled'));
  await expect(canvases(page)).toHaveCount(1);
  expect(page.workers()).toHaveLength(1);
});

test('stays with the page as it scrolls @long', async ({ page, host }) => {
  await host();
  await page.evaluate(() => puff.preload());
  const over = page.evaluate(() => puff({ x: 160, y: 160 }, { count: 300, speed: 0.1, duration: 60 }));
  const before = await visibleSmoke(page, 3000);
  await scrollPage(page, 100);
  const after = await smoke(page);
  expect([before.amount, after.amount], 'pictures without smoke').not.toContain(0);
  expect(before.top - after.top).toBe(100);
  await page.evaluate(() => puff.clear());
  await over;
});

test('stays with the scrolling box around its target, which other smoke does not follow', async ({ page, host }) => {
  await host({
    body: `<div id="box" style="height: 200px; overflow: auto">
      <button style="margin: 90px">Press</button><div style="height: 900px"></div></div>`,
  });
  const heights = () =>
    page.evaluate(() => [document.documentElement.scrollHeight, document.documentElement.scrollWidth]);
  const before = await heights();
  await page.evaluate(() => puff.preload());
  const place = async () => {
    return (await visibleSmoke(page, 3000)).top;
  };
  const scrollBox = async (top: number) => {
    await page.evaluate((y) => document.querySelector('#box')!.scrollTo(0, y), top);
    await frames(page, 2);
  };
  const options = { count: 300, speed: 0.1, duration: 60 };
  const call = (target?: string) =>
    page.evaluate(
      ([selector, given]) => puff(selector ? document.querySelector(selector) : { x: 160, y: 110 }, given),
      [target, options] as const,
    );
  const inside = call('button');
  const y = await place();
  await scrollBox(60);
  expect(y - (await place())).toBe(60);
  await scrollBox(0);
  expect(await place()).toBe(y);
  expect(await heights()).toEqual(before);
  const outside = call();
  await frames(page, 20);
  const both = await place();
  await scrollBox(100);
  expect(await place()).toBe(both);
  await page.evaluate(() => puff.clear());
  await Promise.all([inside, outside]);
});

/** Holds back all messages to the stage after the next one with this method, as if the page were interrupted there. */
async function holdAfter(page: Page, wanted: string): Promise<{ release: () => Promise<void> }> {
  await page.evaluate((method) => {
    const { prototype } = MessagePort;
    const native = prototype.postMessage as (...given: unknown[]) => void;
    let held: (() => void)[] | undefined;
    prototype.postMessage = function (this: MessagePort, ...given: unknown[]) {
      if (held) return void held.push(() => native.apply(this, given));
      native.apply(this, given);
      if ((given[0] as { method?: string }).method === method) held = [];
    } as never;
    Object.assign(window, {
      release() {
        prototype.postMessage = native as never;
        for (const send of held ?? []) send();
      },
    });
  }, wanted);
  return { release: () => page.evaluate(() => (Reflect.get(window, 'release') as () => void)()) };
}

test('never shows the smoke before a call again', async ({ page, host }) => {
  await host();
  await page.evaluate(() => puff.preload());
  const call = () => page.evaluate(() => puff({ x: 160, y: 120 }, { count: 300, speed: 0.1, duration: 60 }));
  const amounts = async () => {
    const found = [];
    for (let at = 0; at < 4; at++) {
      await frames(page, 4);
      found.push((await smoke(page)).amount);
    }
    return found;
  };
  // The smoke of preload().
  let held = await holdAfter(page, 'set');
  let over = call();
  expect(await amounts()).toEqual(Array(4).fill(0));
  await held.release();
  await visibleSmoke(page);
  // That of a call.
  held = await holdAfter(page, 'restart');
  await page.evaluate(() => puff.clear());
  await over;
  await expect.poll(async () => (await smoke(page)).amount).toBe(0);
  expect(await amounts()).toEqual(Array(4).fill(0));
  await held.release();
  held = await holdAfter(page, 'set');
  over = call();
  expect(await amounts()).toEqual(Array(4).fill(0));
  await held.release();
  await visibleSmoke(page);
  await page.evaluate(() => puff.clear());
  await over;
});

for (const end of ['clear', 'Escape'] as const) {
  test(`${end} ends a long effect at once${longIf(end === 'clear')}`, async ({ page, host }) => {
    await host();
    const over = page.evaluate(() => puff({ x: 100, y: 100 }, { effect: 'trail', duration: 60 }));
    await visibleSmoke(page);
    if (end === 'clear') await page.evaluate(() => puff.clear());
    else await page.keyboard.press('Escape');
    await over;
    await expect.poll(async () => (await smoke(page)).amount).toBe(0);
  });
}

test('a trail follows the pointer', async ({ page, host }) => {
  await host();
  await page.mouse.move(60, 120);
  void page.evaluate(() => puff(undefined, { effect: 'trail', duration: 60 })).catch(() => undefined);
  await visibleSmoke(page);
  await expect
    .poll(async () => {
      await page.mouse.move(40, 60);
      await page.mouse.move(42, 60);
      return (await smoke(page)).x;
    })
    .toBeLessThan(90);
});

test('vanish hides an element and appear shows it', async ({ page, host }) => {
  await host();
  const state = (effect: 'vanish' | 'appear') =>
    page.evaluate(async (name) => {
      const button = document.querySelector('button')!;
      const { top } = button.getBoundingClientRect();
      await puff(button, { effect: name, count: 6 });
      const { visibility, opacity } = getComputedStyle(button);
      return {
        visibility,
        opacity,
        moved: button.getBoundingClientRect().top - top,
        animations: button.getAnimations().length,
      };
    }, effect);
  expect(await state('vanish')).toEqual({ visibility: 'hidden', opacity: '1', moved: 0, animations: 0 });
  expect(await state('appear')).toEqual({ visibility: 'visible', opacity: '1', moved: 0, animations: 0 });
});

test('elements without a box get no smoke, and nothing is fetched', async ({ page, host, server }) => {
  await host();
  const sent = server.sent.length;
  const results = await page.evaluate(async () => {
    const none = document.createElement('div');
    const hidden = document.querySelector<HTMLElement>('#below')!;
    hidden.style.display = 'none';
    const flat = document.body.appendChild(document.createElement('i'));
    return Promise.all([none, hidden, flat].map((target) => puff(target, { effect: 'vanish' })));
  });
  expect(results).toEqual([undefined, undefined, undefined]);
  expect(server.sent.length).toBe(sent);
});

test('preload draws hidden smoke, because drivers compile shaders at their first use', async ({ page, host }) => {
  // On the page's own thread, whose WebGL calls can be counted.
  await page.addInitScript(() => {
    Reflect.deleteProperty(HTMLCanvasElement.prototype, 'transferControlToOffscreen');
    const { prototype } = WebGL2RenderingContext;
    Object.assign(window, { hidden: 0, visible: 0 });
    const native = prototype.drawElements;
    prototype.drawElements = function (...given) {
      const { visibility } = getComputedStyle(document.querySelector('canvas')!);
      Reflect.set(window, visibility, Math.max(given[1], Reflect.get(window, visibility)));
      native.apply(this, given);
    };
  });
  await host();
  await page.evaluate(() => puff.preload());
  const [hidden, visible] = await page.evaluate(() => ['hidden', 'visible'].map((each) => Reflect.get(window, each)));
  const corners = 6;
  expect(hidden).toBeGreaterThan(5 * corners);
  // The empty scene has obstacles.
  expect(visible).toBeLessThan(5 * corners);
  expect((await smoke(page)).amount).toBe(0);
  await expect(canvases(page)).toHaveCSS('visibility', 'visible');
  const over = page.evaluate(() => puff(document.querySelector('button')));
  await visibleSmoke(page);
  await over;
});

test('an element that goes away in mid-puff does not stop it @long', async ({ page, host }) => {
  await host();
  const box = (await page.locator('#button').boundingBox())!;
  const over = page.evaluate(async () => {
    const [button, text] = ['#button', '#below'].map((each) => document.querySelector(each)!);
    Object.assign(window, { trail: puff(button, { effect: 'trail', duration: 60 }) });
    const calls = [puff(text), puff(button), puff(button, { effect: 'vanish' })];
    // Before the code has arrived.
    text.remove();
    return (await Promise.allSettled(calls)).map(({ status }) => status);
  });
  await visibleSmoke(page);
  await page.evaluate(() => document.querySelector('button')!.remove());
  expect(await over).toEqual(Array(3).fill('fulfilled'));
  // The trail goes on where the button was.
  const { amount, x, y } = await smoke(page);
  expect(amount).toBeGreaterThan(1000);
  expect(Math.abs(x - box.x - box.width / 2)).toBeLessThan(60);
  expect(Math.abs(y - box.y - box.height / 2)).toBeLessThan(80);
  await page.evaluate(() => {
    puff.clear();
    return Reflect.get(window, 'trail') as Promise<void>;
  });
});

test('invalid arguments reject with a ParameterError that lists what is accepted', async ({ page, host }) => {
  await host();
  const messages = await page.evaluate(async () => {
    const invalid = [
      [undefined, { effect: 'bang' }],
      [undefined, { count: NaN }],
      [undefined, { size: Infinity }],
      [undefined, { color: 'no colour' }],
      [undefined, { colour: 'red' }],
      [undefined, { preset: 'none' }],
      [{ x: NaN, y: 1 }, {}],
      ['button', {}],
    ] as [never, never][];
    const found = await Promise.all(
      invalid.map((each) => puff(...each).then(String, (error: Error) => `${error.name}: ${error.message}`)),
    );
    return found;
  });
  expect(messages[0]).toContain('ParameterError: effect');
  expect(messages[0]).toContain('poof, pop, dust, trail, burst, whoosh, boom, vanish, appear');
  for (const [index, name] of ['effect', 'count', 'size', 'color', 'colour', 'preset', 'target', 'target'].entries()) {
    expect(messages[index]).toMatch(new RegExp(`^ParameterError: ${name} `));
  }
});

test('draws on a canvas of the page @long', async ({ page, host }) => {
  await host({
    body: '<canvas id="own" style="display: block !important; opacity: 1; width: 200px !important; height: 150px"></canvas>',
  });
  const over = page.evaluate(async () => {
    const own = puff.create(document.querySelector('canvas')!);
    await own({ x: 100, y: 100 }, { count: 8 });
    own.dispose();
  });
  await visibleSmoke(page);
  await over;
  await expect(canvases(page)).toHaveCount(1);
});

test.describe('with prefers-reduced-motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  test('shows no smoke unless asked, but hides and shows elements', async ({ page, host, server }) => {
    await host();
    const sent = server.sent.length;
    const visibility = await page.evaluate(async () => {
      const button = document.querySelector('button')!;
      await puff(button);
      await puff(button, { effect: 'vanish' });
      const hidden = getComputedStyle(button).visibility;
      await puff(button, { effect: 'appear' });
      return [hidden, getComputedStyle(button).visibility];
    });
    expect(visibility).toEqual(['hidden', 'visible']);
    expect(server.sent.length).toBe(sent);
    await page.evaluate(() => puff(undefined, { count: 3, reducedMotion: 'play' }));
    await expect(canvases(page)).toHaveCount(1);
  });
});

test('without WebGL2 it rejects with an UnsupportedError, but hides and shows elements', async ({ page, host }) => {
  await page.addInitScript(() => {
    Reflect.deleteProperty(window, 'Worker');
    for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
      const native = prototype.getContext as (...given: unknown[]) => unknown;
      prototype.getContext = function (this: unknown, kind: string, ...rest: unknown[]) {
        return kind.startsWith('webgl') ? null : native.call(this, kind, ...rest);
      } as never;
    }
  });
  await host();
  const found = await page.evaluate(async () => {
    const button = document.querySelector('button')!;
    const name = (effect: 'vanish' | 'appear') => puff(button, { effect }).catch((error: Error) => error.name);
    const errors = [await name('vanish'), getComputedStyle(button).visibility, await name('appear')];
    return [...errors, getComputedStyle(button).visibility];
  });
  expect(found).toEqual(['UnsupportedError', 'hidden', 'UnsupportedError', 'visible']);
  await expect(canvases(page)).toHaveCount(0);
});

test.describe('without the simulator', () => {
  test.use({ allowed: /Failed to load resource/ });

  test('it rejects with a LoadError, and works when it can be fetched', async ({ page, host }) => {
    const wasm = '**/bindings_bg.wasm';
    await page.context().route(wasm, (route) => route.fulfill({ status: 404 }));
    await host();
    const name = () => page.evaluate(() => puff(undefined, { count: 3 }).then(String, (error: Error) => error.name));
    expect(await name()).toBe('LoadError');
    await expect(canvases(page)).toHaveCount(0);
    await page.context().unroute(wasm);
    expect(await name()).toBe('undefined');
  });
});

test('a context that is lost for good rejects with a ContextError, and vanish hides', async ({ page, host }) => {
  await keepContexts(page);
  await page.addInitScript(() => void Reflect.deleteProperty(window, 'Worker'));
  await host();
  await page.evaluate(() => puff.preload());
  const over = page.evaluate(async () => {
    const button = document.querySelector('button')!;
    const error = await puff(button, { effect: 'vanish', duration: 60 }).catch(({ name }: Error) => name);
    return [error, getComputedStyle(button).visibility];
  });
  await visibleSmoke(page);
  await loseForGood(page);
  expect(await over).toEqual(['ContextError', 'hidden']);
  await expect(canvases(page)).toHaveCount(0);
});

for (const target of ['button', 'dialog button']) {
  test(`its canvas is not printed: ${target} @long`, async ({ page, host }) => {
    await host({ body: `${BODY}<dialog><button>Press</button></dialog>` });
    await page.evaluate(() => document.querySelector('dialog')!.showModal());
    const call = { count: 300, speed: 0.1, duration: 60 };
    const over = page.evaluate(([selector, options]) => puff(document.querySelector(selector), options), [
      target,
      call,
    ] as const);
    await visibleSmoke(page);
    const isShown = () => page.evaluate(() => document.querySelector('canvas')!.checkVisibility());
    for (const media of ['screen', 'print', 'screen'] as const) {
      await page.emulateMedia({ media });
      await expect.poll(isShown, { message: media }).toBe(media === 'screen');
    }
    await page.evaluate(() => puff.clear());
    await over;
  });
}

for (const [kind, options, isOurs] of [
  ['a plain page', {}, true],
  ['a page with an element of this ID', { body: '<p id="puff">Text</p>' }, true],
  ['a page with a global of its own', { body: '<script>window.puff = () => "own"</script>' }, false],
] as const) {
  test(`the script for CDNs sets window.puff: ${kind}${longIf(isOurs)}`, async ({ page, host, server }) => {
    const url = '/package/dist/cartoon-smoke.min.js';
    await host({ ...options, script: `<script type="module" src="${url}"></script>` });
    await page.waitForFunction(() => customElements.get('cartoon-smoke'));
    expect(await page.evaluate(() => 'preload' in puff)).toBe(isOurs);
    if (isOurs) await page.evaluate(() => puff(undefined, { count: 3 }));
    const scripts = new Set(server.sent.map(({ file }) => `/${file}`).filter((file) => file.endsWith('.js')));
    expect([...scripts]).toEqual([url]);
  });
}

test('downloads at most 6 kB before the first call', async ({ page, host, server }) => {
  await host();
  const kB = server.sent.filter(({ file }) => file.endsWith('.js')).reduce((sum, { bytes }) => sum + bytes, 0) / 1000;
  process.stdout.write(`puff.firstKb: ${kB.toFixed(1)} kB\n`);
  expect(kB).toBeGreaterThan(1);
  expect(kB).toBeLessThan(6);
  await page.evaluate(() => puff(undefined, { count: 3 }));
  expect(server.sent.map(({ file }) => file).join()).not.toContain('three');
});
