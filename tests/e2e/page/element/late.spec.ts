/** Late responses, failures and disposals that arrive after the page has changed its request. */
import type { Page, Route } from '@playwright/test';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { expect, stands, test, WISP } from '../../../support/embed.ts';

type Connect = typeof import('../../../../src/stage/remote/connectFrame.ts');

// The browser logs aborted requests itself.
test.use({ allowed: /ERR_FAILED/ });

const SIZE = 'style="width: 200px; height: 150px"';
const AIR = 'preset="air" simulation-max-particles="300" puff-variations="1" thread="main"';

/** Records the events of the first element, from before its upgrade. */
const LISTEN = `<script>
  window.notified = [];
  for (const type of ['ready', 'error', 'statechange']) {
    document.querySelector('cartoon-smoke').addEventListener(type, () => window.notified.push(type));
  }
</script>`;

function notifiedOn(page: Page): Promise<string[]> {
  return page.evaluate(() => Reflect.get(window, 'notified') as unknown as string[]);
}

function smokeOn(page: Page) {
  return page.locator('cartoon-smoke');
}

function valuesOn(page: Page) {
  return smokeOn(page).evaluate((smoke: CartoonSmokeElement) => smoke.get());
}

/** The first request for a file, held until the test continues it. */
async function hold(page: Page, file: string): Promise<{ asked: Promise<Route> }> {
  let take!: (route: Route) => void;
  const asked = new Promise<Route>((resolve) => (take = resolve));
  await page.route(`**/dist/${file}`, take);
  return { asked };
}

test('an aborted start has no effect after the element is inserted again', async ({ page, openPage }) => {
  const request = await hold(page, 'pointers.js');
  await openPage(`<cartoon-smoke ${WISP} interactive ${SIZE}></cartoon-smoke>${LISTEN}`);
  const route = await request.asked;
  await smokeOn(page).evaluate(async (smoke) => {
    smoke.remove();
    smoke.removeAttribute('interactive');
    await new Promise((resolve) => setTimeout(resolve));
    document.body.append(smoke);
  });
  await stands(page);
  const before = await notifiedOn(page);
  expect(before.filter((type) => type === 'ready')).toHaveLength(1);
  await route.continue();
  // Interaction needs the same file; the aborted start would have received it earlier.
  const isInteractive = () =>
    smokeOn(page).evaluate((smoke) => smoke.shadowRoot!.querySelector('.frame')!.matches('.interactive'));
  await smokeOn(page).evaluate((smoke) => smoke.toggleAttribute('interactive', true));
  await expect.poll(isInteractive).toBe(true);
  expect(await notifiedOn(page)).toEqual(before);
});

test('a failure of replaced smoke is not reported, and the new smoke starts', async ({ page, openPage }) => {
  const request = await hold(page, 'wisp.js');
  await openPage(`<cartoon-smoke ${WISP} paused ${SIZE}></cartoon-smoke>${LISTEN}`);
  const route = await request.asked;
  await smokeOn(page).evaluate((smoke) => smoke.setAttribute('preset', 'air'));
  await route.abort();
  await stands(page);
  expect((await valuesOn(page)).scene).toBe('air');
  expect(await notifiedOn(page)).not.toContain('error');
});

test('a paused link also pauses smoke that already plays', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${WISP} ${SIZE}></cartoon-smoke>`);
  await stands(page);
  await smokeOn(page).evaluate((smoke: CartoonSmokeElement) => (smoke.src = '?paused=1#preset=wisp'));
  const isPlaying = () => smokeOn(page).evaluate((smoke: CartoonSmokeElement) => smoke.playing);
  await expect.poll(isPlaying).toBe(false);
  await expect(smokeOn(page)).not.toHaveAttribute('paused');
  await smokeOn(page).evaluate((smoke: CartoonSmokeElement) => smoke.play());
  await smokeOn(page).evaluate((smoke) => smoke.setAttribute('light-azimuth', '12'));
  await expect.poll(async () => (await valuesOn(page))['light.azimuth']).toBe(12);
  expect(await isPlaying()).toBe(true);
});

test('a new link with a time restarts as on a new element; one without a time changes the running smoke', async ({
  page,
  openPage,
}) => {
  await openPage(`<cartoon-smoke ${WISP} paused ${SIZE}></cartoon-smoke>`);
  await stands(page);
  const smoke = smokeOn(page).first();
  const steps = () => smoke.evaluate(async (element: CartoonSmokeElement) => (await element.stats()).steps);
  const follow = (link: string) => smoke.evaluate((element: CartoonSmokeElement, src) => (element.src = src), link);
  await smoke.evaluate((element: CartoonSmokeElement) => element.step(30));
  await follow('?paused=1&t=4#preset=wisp&emission.rate=30');
  await expect.poll(steps).toBe(240);
  const hashes = await smoke.evaluate(async (element) => {
    const fresh = element.cloneNode() as CartoonSmokeElement;
    document.body.append(fresh);
    return Promise.all([element as CartoonSmokeElement, fresh].map((each) => each.hash()));
  });
  expect(hashes[0]).toBe(hashes[1]);
  await smoke.evaluate((element: CartoonSmokeElement) => element.step());
  await follow('?paused=1#preset=wisp&emission.rate=60');
  await expect
    .poll(() => smoke.evaluate(async (element: CartoonSmokeElement) => (await element.get())['emission.rate']))
    .toBe(60);
  expect(await steps()).toBe(241);
  await follow('?t=0#preset=wisp&emission.rate=60');
  await expect.poll(steps).toBe(0);
  await expect(smoke).toHaveAttribute('paused');
});

test('moves through templates and other documents without errors, and looks the same afterwards', async ({
  page,
  openPage,
}) => {
  await openPage(`<cartoon-smoke ${WISP} paused ${SIZE}></cartoon-smoke><iframe title="Another document"></iframe>`);
  await stands(page);
  const positions = await smokeOn(page).evaluate(async (smoke) => {
    const places = [
      document.createElement('template').content,
      document.implementation.createHTMLDocument().body,
      document.querySelector('iframe')!.contentDocument!.body,
      document.body,
    ];
    const seen = [];
    for (const place of places) {
      place.append(smoke);
      await new Promise((resolve) => setTimeout(resolve));
      seen.push(getComputedStyle(smoke.shadowRoot!.querySelector('.frame')!).position);
    }
    return seen;
  });
  expect(positions.slice(2)).toEqual(['relative', 'relative']);
  await stands(page);
});

test.describe('with all pixels', () => {
  test.use({ deviceScaleFactor: 1 });

  test('smoke taller than the largest possible canvas is drawn @long', async ({ page, openPage }) => {
    await openPage(`<cartoon-smoke ${WISP} paused start="3" style="width: 200px; height: 150px"></cartoon-smoke>`);
    await stands(page);
    const heights = () =>
      smokeOn(page).evaluate((smoke) => {
        const canvas = smoke.shadowRoot!.querySelector('canvas')!;
        return createImageBitmap(canvas).then(({ height }) => [height, canvas.clientHeight]);
      });
    for (const height of [12_000, 40_000]) {
      await smokeOn(page).evaluate((smoke, pixels) => (smoke.style.height = `${pixels}px`), height);
      await expect.poll(heights).toEqual([8192, height]);
    }
  });
});

test('a click on its button does not open the link around it @long', async ({ page, openPage }) => {
  await openPage(`<a href="#elsewhere"><cartoon-smoke ${WISP} ${SIZE}></cartoon-smoke></a>`);
  await stands(page);
  await page.getByRole('button', { name: 'Pause smoke' }).click();
  await expect(smokeOn(page)).toHaveAttribute('paused');
  expect(await page.evaluate(() => location.hash)).toBe('');
});

test('a camera drag that ends out of view does not continue with the pointer @long', async ({ page, openPage }) => {
  await openPage(
    `<cartoon-smoke ${WISP} paused interactive style="position: absolute; inset: 0 auto auto 0; width: 300px; height: 200px"></cartoon-smoke>`,
  );
  await stands(page);
  const azimuth = async () => Math.round((await valuesOn(page))['camera.azimuth'] ?? 0);
  const drag = async (left: number) => {
    await page.mouse.move(left, 60);
    await page.mouse.down();
    await page.mouse.move(left + 40, 60);
  };
  await drag(60);
  // From 6.9 degrees, 13.75 degrees per event.
  await expect.poll(azimuth).toBe(-7);
  await smokeOn(page).evaluate((smoke) => smoke.removeAttribute('interactive'));
  await page.mouse.up();
  await smokeOn(page).evaluate((smoke) => smoke.toggleAttribute('interactive', true));
  await drag(100);
  await expect.poll(azimuth).toBe(-21);
  await smokeOn(page).evaluate((smoke) => document.body.appendChild(document.createElement('div')).append(smoke));
  await page.mouse.move(500, 300);
  await page.mouse.up();
  await drag(60);
  await expect.poll(azimuth).toBe(-34);
  await page.mouse.up();
});

test('a drag that ends before its reply shows no grab cursor @long', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${WISP} paused interactive ${SIZE}></cartoon-smoke>`);
  await stands(page);
  const held = await smokeOn(page).evaluate(async (smoke: CartoonSmokeElement) => {
    const canvas = smoke.shadowRoot!.querySelector('canvas')!;
    Object.assign(await smoke.stage, { pointer: async () => 'rigid' });
    // No browser captures a pointer that does not exist.
    canvas.setPointerCapture = () => undefined;
    const isHeldAfter = async (...types: string[]) => {
      for (const type of types) canvas.dispatchEvent(new PointerEvent(type, { pointerId: 7 }));
      await new Promise((resolve) => setTimeout(resolve));
      return canvas.matches('.holding');
    };
    return [
      await isHeldAfter('pointerdown', 'pointerup'),
      await isHeldAfter('pointerdown'),
      await isHeldAfter('pointerup'),
    ];
  });
  expect(held).toEqual([false, true, false]);
});

test('an invalid origin is rejected at once, and nothing is thrown when the frame loads', async ({ load, blank }) => {
  const remote = await load<Connect>('/src/stage/remote/connectFrame.ts');
  const said = await remote.evaluate(async ({ connectFrame }) => {
    const frame = document.body.appendChild(document.createElement('iframe'));
    const rejected = connectFrame(frame, { origin: 'somewhere' }).catch(
      ({ name, message }: Error) => `${name}: ${message}`,
    );
    const heard = new Promise((resolve) => window.addEventListener('message', resolve, { once: true }));
    frame.srcdoc = '<script>parent.postMessage({ cartoonSmoke: "here" }, "*")</script>';
    await heard;
    return rejected;
  });
  expect(said).toMatch(/^ParameterError: origin cannot be “somewhere”: it takes an address/);
  expect(blank.url()).toContain('blank');
});

test.describe('with prefers-reduced-motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  test('another preset shows its still frame, too @long', async ({ page, openPage }) => {
    await openPage(`<cartoon-smoke ${WISP} ${SIZE}></cartoon-smoke>`);
    await stands(page);
    await smokeOn(page).evaluate((smoke: CartoonSmokeElement) => (smoke.preset = 'air'));
    await expect.poll(async () => (await valuesOn(page)).scene).toBe('air');
    const steps = () => smokeOn(page).evaluate(async (smoke: CartoonSmokeElement) => (await smoke.stats()).steps);
    await expect.poll(steps).toBe(240);
  });

  test('a link to a moment shows it, another link its still frame, and neither of them plays', async ({
    page,
    openPage,
  }) => {
    await openPage(`<cartoon-smoke ${WISP} ${SIZE}></cartoon-smoke>`);
    await stands(page);
    const steps = () => smokeOn(page).evaluate(async (smoke: CartoonSmokeElement) => (await smoke.stats()).steps);
    expect(await steps()).toBe(240);
    for (const [link, goal] of [
      ['?t=2#preset=wisp', 120],
      ['#preset=wisp&emission.rate=60', 240],
      ['?t=1#preset=wisp', 60],
      [undefined, 240],
    ] as const) {
      await smokeOn(page).evaluate((smoke: CartoonSmokeElement, src) => (smoke.src = src), link);
      await expect.poll(steps).toBe(goal);
    }
    expect(await smokeOn(page).evaluate((smoke: CartoonSmokeElement) => smoke.playing)).toBe(false);
  });

  test('a user who presses play while the smoke loads gets motion @long', async ({ page, openPage }) => {
    const request = await hold(page, 'session.js');
    await openPage(`<cartoon-smoke ${AIR} ${SIZE}></cartoon-smoke>
      <button onclick="document.querySelector('cartoon-smoke').play()">Go</button>`);
    const route = await request.asked;
    await page.getByRole('button', { name: 'Go' }).click();
    await route.continue();
    await stands(page);
    expect(await smokeOn(page).evaluate((smoke: CartoonSmokeElement) => smoke.playing)).toBe(true);
  });
});
