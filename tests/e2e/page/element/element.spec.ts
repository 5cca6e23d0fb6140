import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { watchConsole } from '../../../support/consoleErrors.ts';
import { expect, scrollPage, stands, test, WISP } from '../../../support/embed.ts';

declare global {
  interface Window {
    notified: { type: string; detail: { playing?: boolean; notices?: { message: string }[]; error?: Error } }[];
  }
}

/** Records all events of the first element, from before its upgrade. */
const LISTEN = `<script>
  window.notified = [];
  for (const type of ['ready', 'error', 'statechange']) {
    document.querySelector('cartoon-smoke').addEventListener(type, ({ detail }) => window.notified.push({ type, detail }));
  }
</script>`;

test('draws smoke by its attributes, and plays', async ({ page, openPage }) => {
  await openPage(
    `<cartoon-smoke ${WISP} emission-rate="60" seed="7" style="width: 320px; height: 240px"></cartoon-smoke>${LISTEN}`,
  );
  await stands(page);
  const element = page.locator('cartoon-smoke');
  const values = await element.evaluate((smoke: CartoonSmokeElement) => smoke.get());
  expect(values).toMatchObject({ scene: 'wisp', 'emission.rate': 60, seed: 7 });
  await expect
    .poll(() => element.evaluate(async (smoke: CartoonSmokeElement) => (await smoke.stats()).alive))
    .toBeGreaterThan(3);
  const notified = await page.evaluate(() => window.notified.map(({ type, detail }) => [type, detail.playing]));
  expect(notified).toContainEqual(['ready', undefined]);
  expect(notified).toContainEqual(['statechange', true]);
});

test('loads only itself until it is near the viewport, and causes no layout shift', async ({
  page,
  openPage,
  server,
}) => {
  await openPage(`<div style="height: 4000px">An article</div>
    <cartoon-smoke ${WISP} style="height: 240px"></cartoon-smoke><p>More of it</p>
    <script>
      window.shift = 0;
      new PerformanceObserver((list) => {
        for (const entry of list.getEntries()) window.shift += entry.value;
      }).observe({ type: 'layout-shift', buffered: true });
    </script>`);
  await page.waitForFunction(() => customElements.get('cartoon-smoke') && document.readyState === 'complete');
  const before = new Set(server.sent.map(({ file }) => file.split('/').at(-1)));
  expect(before).toEqual(new Set(['cartoonSmokeElement.js', 'element.js', 'errors.js']));
  expect(server.sent.reduce((sum, { bytes }) => sum + bytes, 0)).toBeLessThan(6_900);
  await scrollPage(page, 3500);
  await stands(page);
  expect(await page.evaluate(() => (window as unknown as { shift: number }).shift)).toBe(0);
});

test('accepts properties set before its definition, and reflects later ones', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${WISP}></cartoon-smoke>
    <script>Object.assign(document.querySelector('cartoon-smoke'), { emissionRate: 44, paused: true });</script>`);
  await stands(page);
  const element = page.locator('cartoon-smoke');
  await expect(element).toHaveAttribute('emission-rate', '44');
  await expect(element).toHaveAttribute('paused');
  await element.evaluate((smoke: CartoonSmokeElement) =>
    Object.assign(smoke, { styleTones: 3, emissionRate: undefined }),
  );
  await expect(element).toHaveAttribute('style-tones', '3');
  const rate = () => element.evaluate(async (smoke: CartoonSmokeElement) => (await smoke.get())['emission.rate']);
  await expect.poll(rate).not.toBe(44);
  expect(await element.evaluate((smoke: CartoonSmokeElement) => Reflect.get(smoke, 'styleTones'))).toBe(3);
});

test('rejects calls with values out of range, and changes nothing; a clone is an independent element', async ({
  page,
  openPage,
}) => {
  await openPage(`<cartoon-smoke ${WISP} paused emission-rate="33"></cartoon-smoke>`);
  await stands(page);
  const report = await page.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement) => {
    const rejected = await smoke.set({ 'emission.rate': -5, 'emission.lifetime': 2 }).then(
      () => undefined,
      ({ name, message }: Error) => `${name}: ${message}`,
    );
    const { 'emission.rate': rate, 'emission.lifetime': lifetime } = await smoke.get();
    return { rejected, rate, isSame: lifetime !== 2 };
  });
  expect(report).toMatchObject({ rate: 33, isSame: true });
  expect(report.rejected).toMatch(/^ParameterError: emission.rate cannot be -5: it takes /);
  const values = await page.evaluate(async () => {
    const copy = document.querySelector('cartoon-smoke')!.cloneNode(true) as CartoonSmokeElement;
    document.body.append(copy);
    return copy.get();
  });
  expect(values['emission.rate']).toBe(33);
});

test('uses the default for invalid values, with a notice and no console output', async ({ page, openPage }) => {
  const lines = watchConsole(page);
  await openPage(`<cartoon-smoke preset="fog" scene="wisp" emission-rate="plenty" emission-lifetime="1000" thread="main"
    simulation-max-particles="300" loading="soon" start="dusk" style="height: 200px"></cartoon-smoke>${LISTEN}`);
  await stands(page);
  const notified = await page.evaluate(() => window.notified.flatMap(({ detail }) => detail.notices ?? []));
  const messages = notified.map(({ message }) => message).join('\n');
  expect(messages).toContain('no preset');
  for (const name of ['emission.rate', 'emission.lifetime', 'loading', 'start']) {
    expect(messages).toMatch(new RegExp(`^${name} cannot be`, 'm'));
  }
  const values = await page.locator('cartoon-smoke').evaluate((smoke: CartoonSmokeElement) => smoke.get());
  expect(values).toMatchObject({ 'emission.lifetime': 60 });
  expect(lines).toEqual([]);
});

test('plays the timeline of its attribute, and one that comes later as an object', async ({ page, openPage }) => {
  await openPage(
    `<cartoon-smoke ${WISP} paused timeline="60;emission.rate/0*0;seed/0*1;style.smokeColor/0*ff0000"></cartoon-smoke>${LISTEN}`,
  );
  await stands(page);
  const notices = await page.evaluate(() => window.notified.flatMap(({ detail }) => detail.notices ?? []));
  expect(notices.map(({ message }) => message)).toEqual([expect.stringContaining('timeline.seed')]);
  const found = await page.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement) => {
    await smoke.seek(1);
    const before = [(await smoke.stats()).alive, (await smoke.get()).timeline];
    const keyframes = [{ step: 0, value: 60, easing: 'linear' as const }];
    await smoke.set({
      timeline: { length: 60, loops: true, lanes: [{ key: 'emission.rate', keyframes }], bursts: [] },
    });
    await smoke.seek(2);
    const error = await smoke.set({ timeline: '60;seed/0*1' }).catch(({ name, message }: Error) => [name, message]);
    return [...before, (await smoke.stats()).alive, (await smoke.get()).timeline, error];
  });
  expect(found).toEqual([
    0,
    '60;emission.rate/0*0;style.smokeColor/0*ff0000',
    expect.any(Number),
    '60*loop;emission.rate/0*60',
    ['ParameterError', expect.stringContaining('timeline.seed')],
  ]);
  expect(found[2]).toBeGreaterThan(20);
});

test('a poster in a picture element is as wide as the smoke', async ({ page, openPage }) => {
  const drawing = (width: number) =>
    `data:image/svg+xml,%3Csvg%20xmlns='http://www.w3.org/2000/svg'%20width='${width}'%20height='300'/%3E`;
  await openPage(`<div style="height: 5000px">An article</div>
    <cartoon-smoke ${WISP} style="width: 200px; height: 150px">
      <picture slot="poster">
        <source media="(min-width: 1px)" srcset="${drawing(400)}" /><img src="${drawing(900)}" alt="" />
      </picture>
    </cartoon-smoke>`);
  const [smoke, image] = await page.evaluate(async () => {
    await customElements.whenDefined('cartoon-smoke');
    const shown = document.querySelector('img')!;
    await shown.decode();
    return [document.querySelector('cartoon-smoke')!, shown].map((element) => element.getBoundingClientRect().toJSON());
  });
  expect(image).toEqual(smoke);
});

test('keeps its smoke when it is moved, and restarts when it is removed and inserted again', async ({
  page,
  openPage,
}) => {
  await openPage(`<div id="a"><cartoon-smoke ${WISP} paused></cartoon-smoke></div><dialog open id="b"></dialog>`);
  await stands(page);
  const smoke = page.locator('cartoon-smoke');
  const steps = async () => (await smoke.evaluate((element: CartoonSmokeElement) => element.stats())).steps;
  await smoke.evaluate((element: CartoonSmokeElement) => element.step(5));
  await smoke.evaluate((element) => document.querySelector('#b')!.append(element));
  expect(await steps()).toBe(5);
  await smoke.evaluate(async (element) => {
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    document.body.append(element);
  });
  expect(await steps()).toBe(0);
});

test('lets pointers through unless it is interactive', async ({ page, openPage }) => {
  await openPage(`<a href="#under" style="position: absolute; inset: 0 auto auto 0; width: 300px; height: 200px">Below</a>
    <cartoon-smoke ${WISP} paused style="position: absolute; inset: 0 auto auto 0; width: 300px; height: 200px"></cartoon-smoke>`);
  await stands(page);
  const below = () => page.evaluate(() => document.elementFromPoint(150, 100)?.localName);
  expect(await below()).toBe('a');
  await page.locator('cartoon-smoke').evaluate((smoke: CartoonSmokeElement) => (smoke.interactive = true));
  expect(await below()).toBe('cartoon-smoke');
  // The orbit controls are loaded lazily.
  await expect(page.locator('cartoon-smoke canvas')).toHaveAttribute('tabindex');
  const azimuth = () => page.locator('cartoon-smoke').screenshot();
  const before = await azimuth();
  await page.mouse.move(150, 60);
  await page.mouse.down();
  await page.mouse.move(250, 60);
  await page.mouse.up();
  await expect.poll(async () => before.equals(await azimuth())).toBe(false);
});

test('is registered once, in either order of the scripts', async ({ page, openPage }) => {
  const script = `<script type="module" src="/package/dist/cartoon-smoke.min.js"></script>
    <script type="module">
      const first = await import('/package/dist/cartoon-smoke.min.js');
      window.first = first.CartoonSmokeElement;
    </script>
    <script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js" } }</script>`;
  await openPage(
    `<cartoon-smoke ${WISP} paused></cartoon-smoke>
    <script type="module">import '/package/dist/element.js'; window.second = true;</script>`,
    { script },
  );
  await stands(page);
  expect(await page.evaluate(() => customElements.get('cartoon-smoke') === Reflect.get(window, 'first'))).toBe(true);
});
