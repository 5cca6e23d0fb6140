/** Smoke in a cross-origin iframe with the strictest sandbox. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { ConsoleMessage } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { turningBox } from '../../../support/files/glb.ts';
import { PLAIN_LOOK } from '../../../support/plainLook.ts';
import { script } from '../../../support/server.ts';
import { keepContexts, loseForGood, restoreLate } from '../../stage/remote/context.ts';

interface ServeScript {
  serveSite(
    folder: string,
    place: string,
    headers: Record<string, string>,
  ): Promise<{ address: string; close(): Promise<void> }>;
}

// The built site: its frame is one script.
test.use({ showsBuiltSite: true });

type Cases = typeof import('../../stage/remote/stage.cases.ts');
type FrameCases = typeof import('./iframe.cases.ts');
const FRAMES = '/tests/e2e/page/iframe/iframe.cases.ts';
const SANDBOX = 'allow-scripts';
const SMALL = 'puff.variations=1&simulation.maxParticles=300';
const PLAIN = Object.entries(PLAIN_LOOK)
  .map(([key, value]) => `&${key}=${String(value)}`)
  .join('');
const WISP = `?paused=1#v=1&preset=wisp&${SMALL}${PLAIN}`;

test('a frame says that it has no models, and shows smoke that rides on a part of one', async ({ load, baseURL }) => {
  const frames = await load<FrameCases>(FRAMES);
  const link = `${baseURL}/embed.html${WISP}&model=box.glb&emitters.1.rigid=4099&emitters.1.share=1`;
  const { alive, ...error } = await frames.evaluate((module, [url, bytes]) => module.withoutModel(url, bytes), [
    link,
    [...turningBox().pack()],
  ] as const);
  expect(error).toEqual({
    name: 'LoadError',
    message: 'Models could not be loaded: an iframe of embed.html has none. Use the element or a stage instead.',
  });
  expect(alive).toBeGreaterThan(0);
});

test('a frame without an origin needs only scripts, and shows the same picture as a stage on this page', async ({
  load,
  blank,
  baseURL,
}) => {
  const fetched: string[] = [];
  const note = (request: { url(): string }) => fetched.push(new URL(request.url()).pathname);
  const frames = await load<FrameCases>(FRAMES);
  const cases = await load<Cases>('/tests/e2e/stage/remote/stage.cases.ts');
  blank.on('request', note);
  const framed = await frames.evaluateHandle((module, [url, sandbox]) => module.connect(url, sandbox), [
    `${baseURL}/embed.html${WISP}`,
    SANDBOX,
  ] as const);
  blank.off('request', note);
  expect(
    fetched.filter((path) => !/embed\.(html|css)$|check\.js$|favicon\.svg$|assets\/embed-[\w-]{8}\.js$/.test(path)),
  ).toEqual([]);
  await frames.evaluate((module, one) => module.isSized(one), framed);
  const report = await cases.evaluate(async (module, { stage }) => {
    const here = await module.open({ thread: 'main' });
    for (const each of [stage, here.stage]) await each.step(90);
    const pictures = await Promise.all([stage, here.stage].map(async (each) => module.pixelsOf(await each.picture())));
    const hashes = [await stage.hash(), await here.stage.hash()];
    await here.stage.dispose();
    return {
      thread: stage.thread,
      hashes,
      changed: module.differing(pictures[0], pictures[1]),
      colors: new Set(pictures[0]).size,
    };
  }, framed);
  expect(report.thread).toBe('frame');
  expect(report.hashes[0]).toBe(report.hashes[1]);
  expect(report.colors).toBeGreaterThan(20);
  expect(report.changed).toBe(0);
});

test('plays, emits events, rejects and disposes like any stage', async ({ load, baseURL }) => {
  const frames = await load<FrameCases>(FRAMES);
  const cases = await load<Cases>('/tests/e2e/stage/remote/stage.cases.ts');
  const framed = await frames.evaluateHandle((module, [url, sandbox]) => module.connect(url, sandbox), [
    `${baseURL}/embed.html${WISP}`,
    SANDBOX,
  ] as const);
  const report = await cases.evaluate(async (module, { stage, frame }) => {
    const notified: boolean[] = [];
    stage.on('statechange', ({ playing }) => notified.push(playing));
    await stage.play();
    await module.goesOn(stage, 2);
    await stage.pause();
    await stage.get();
    const rejected = await module.thrownBy(() => stage.set({ 'emission.rate': -5 }));
    await stage.set({ 'emission.rate': 50 });
    const rate = (await stage.get())['emission.rate'];
    const hasEnded = new Promise<string>((resolve) => stage.on('error', ({ name }) => resolve(name)));
    frame.src = frame.src.replace('paused=1', 'paused=true');
    const ended = await hasEnded;
    await stage.dispose();
    return { notified, rejected, rate, ended, after: (await module.thrownBy(() => stage.play()))?.name };
  }, framed);
  expect(report.notified.slice(0, 2)).toEqual([true, false]);
  expect(report.rejected).toMatchObject({ name: 'ParameterError', key: 'emission.rate', value: -5, isOurs: true });
  expect(report).toMatchObject({ rate: 50, ended: 'SimulatorError', after: 'SimulatorError' });
});

test('restarts on reconnect after dispose, and notifies the other connections', async ({ load, baseURL }) => {
  const frames = await load<FrameCases>(FRAMES);
  const report = await frames.evaluate((module, url) => module.endsAndBegins(url), `${baseURL}/embed.html${WISP}`);
  expect(report).toEqual({ other: 'SimulatorError', steps: 0 });
});

test('pending and later calls end with an error when the frame is removed, moved or shows another page', async ({
  load,
  blank,
  baseURL,
}) => {
  await blank.addInitScript(() =>
    addEventListener('message', ({ data }) => {
      const busyFor = (data as { busyFor?: number } | undefined | null)?.busyFor;
      if (typeof busyFor === 'number') for (const end = performance.now() + busyFor; performance.now() < end;);
    }),
  );
  const frames = await load<FrameCases>(FRAMES);
  for (const [how, reason] of [
    ['removed', 'was removed'],
    ['moved', 'was removed'],
    ['sent elsewhere', 'was unloaded'],
    ['sent elsewhere while busy', 'was unloaded'],
  ] as const) {
    const report = await frames.evaluate((module, given) => module.endFrame(...given), [
      `${baseURL}/embed.html${WISP}`,
      SANDBOX,
      how,
    ] as const);
    const notified = `The frame ${reason}; connect again.`;
    expect(report, how).toEqual({
      reasons: [notified, notified],
      later: notified,
      errors: [notified],
      before: 1,
      after: 0,
    });
  }
  const waiting = await frames.evaluate(
    (module, url) => module.removeWhileWaiting(url),
    `${baseURL}/embed.html${WISP}`,
  );
  expect(waiting).toBe('The frame was removed.');
});

test('reads hash and query like the demo, and loads physics only if needed', async ({ load, blank, baseURL }) => {
  const physics: string[] = [];
  blank.on('request', (request) => request.url().includes('embed-physics') && physics.push(request.url()));
  const frames = await load<FrameCases>(FRAMES);
  const address = `${baseURL}/embed.html?paused=1&t=0.5`;
  const framed = await frames.evaluateHandle((module, [url, sandbox]) => module.connect(url, sandbox), [
    `${address}#v=1&preset=wisp&puff.variations=1&simulation.maxParticles=300&seed=7#?secret=abc123`,
    SANDBOX,
  ] as const);
  const before = await frames.evaluate((module, { stage }) => module.stateOf(stage), framed);
  expect(before).toMatchObject({ steps: 30, values: { scene: 'wisp', seed: 7 } });
  expect(physics).toEqual([]);
  await framed.evaluate(
    ({ frame }, url) => (frame.src = url),
    `${address}#v=1&preset=lamp&simulation.maxParticles=300`,
  );
  await expect.poll(() => framed.evaluate(async ({ stage }) => (await stage.get()).scene)).toBe('lamp');
  expect(physics).toHaveLength(1);
});

test.describe('without the physics module', () => {
  // The browser logs failed requests itself.
  test.use({ allowed: /Failed to load resource/ });

  test('a frame shows its fallback and reports a LoadError to the host page', async ({ load, blank, baseURL }) => {
    const frames = await load<FrameCases>(FRAMES);
    const cases = await load<Cases>('/tests/e2e/stage/remote/stage.cases.ts');
    await blank.route('**/embed-physics*', (route) => route.abort());
    const address = `${baseURL}/embed.html?paused=1#v=1&preset=lamp&simulation.maxParticles=300`;
    const rejected = await cases.evaluate(
      (module, [connecting, url, sandbox]) => module.thrownBy(() => connecting.connect(url, sandbox)),
      [frames, address, SANDBOX] as const,
    );
    await blank.unroute('**/embed-physics*');
    expect(rejected).toMatchObject({ name: 'LoadError', isOurs: true });
    expect(rejected?.message).toContain('could not be fetched');
    await expect(blank.frameLocator('iframe').locator('cartoon-smoke p')).toBeVisible();
  });
});

test.describe('a frame whose context is lost for good', () => {
  test.use({ ownPage: true, allowed: /context lost|context restored|CONTEXT_LOST/i });

  test('restarts by a late restoration or by its button, and stays connected @long', async ({
    load,
    blank,
    baseURL,
  }) => {
    await keepContexts(blank);
    const frames = await load<FrameCases>(FRAMES);
    const framed = await frames.evaluateHandle((module, [url, sandbox]) => module.connect(url, sandbox), [
      `${baseURL}/embed.html${WISP}`,
      SANDBOX,
    ] as const);
    const errors = await framed.evaluateHandle(({ stage }) => {
      const names: string[] = [];
      stage.on('error', ({ name }) => names.push(name));
      return names;
    });
    const inside = blank.frames()[1];
    const button = (name: string) => inside.getByRole('button', { name });
    for (const restart of [() => restoreLate(inside), () => button('Restart smoke').click(), undefined]) {
      await errors.evaluate((names) => names.splice(0));
      await framed.evaluate(({ stage }) => stage.step(3));
      await loseForGood(inside);
      await expect.poll(() => errors.jsonValue()).toEqual(['ContextError']);
      await expect(button('Restart smoke')).toBeVisible();
      await restart?.();
      if (restart) await expect(button('Play smoke')).toBeVisible();
    }
  });
});

test('only the origin in the address can connect', async ({ load, baseURL }) => {
  const frames = await load<FrameCases>(FRAMES);
  const origin = await frames.evaluate(() => location.origin);
  const letsIn = (query: string, timeout?: number) =>
    frames.evaluate((module, given) => module.letsIn(...given), [
      `${baseURL}/embed.html?${query}${WISP.slice(1)}`,
      timeout,
    ] as const);
  expect(await letsIn(`origin=${origin}&`)).toBe(true);
  const untrusted = ['https://example.org', 'null', '*'].map((other) => letsIn(`origin=${other}&`, 3_000));
  expect(await Promise.all(untrusted)).toEqual([false, false, false]);
});

test('waiting for a frame of a given origin writes nothing to the console', async ({ load, blank, baseURL }) => {
  const frames = await load<FrameCases>(FRAMES);
  const lines: string[] = [];
  const note = (message: ConsoleMessage) => message.type() !== 'debug' && lines.push(message.text());
  blank.on('console', note);
  const framed = await frames.evaluateHandle((module, [url, origin]) => module.connect(url, undefined, origin), [
    `${baseURL}/embed.html${WISP}`,
    new URL(baseURL!).origin,
  ] as const);
  blank.off('console', note);
  expect(lines).toEqual([]);
  expect(await framed.evaluate(({ stage }) => stage.thread)).toBe('frame');
});

test('five thousand hostile messages change nothing and throw nothing', async ({ load, baseURL }) => {
  const frames = await load<FrameCases>(FRAMES);
  const framed = await frames.evaluateHandle((module, [url, sandbox]) => module.connect(url, sandbox), [
    `${baseURL}/embed.html${WISP}`,
    SANDBOX,
  ] as const);
  await framed.evaluate(({ stage }) => stage.step(30));
  const before = await frames.evaluate((module, { stage }) => module.stateOf(stage), framed);
  const report = await frames.evaluate((module, { frame }) => module.attack(frame, 5_000), framed);
  expect(report).toEqual({ accepted: 0, sent: 5_000 });
  expect(await frames.evaluate((module, { stage }) => module.stateOf(stage), framed)).toEqual(before);
});

test('works from a host with a strict Content-Security-Policy', async ({ load }) => {
  const { serveSite } = await script<ServeScript>('site/serve.mjs');
  const folder = fileURLToPath(new URL('../../../../dist', import.meta.url));
  const policy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'";
  const server = await serveSite(folder, '/deep/inside/', { 'content-security-policy': policy });
  const frames = await load<FrameCases>(FRAMES);
  const steps = await frames.evaluate(
    async (module, [url, sandbox]) => {
      const { stage } = await module.connect(url, sandbox);
      return (await module.stateOf(stage)).steps;
    },
    [`${server.address}embed.html?t=0.5&${WISP.slice(1)}`, SANDBOX] as const,
  );
  expect(steps).toBe(30);
  await server.close();
});

test('each preset of the gallery has an oEmbed response and a page that links to it', () => {
  const page = readFileSync(new URL('../../../../dist/gallery/wisp.html', import.meta.url), 'utf8');
  const link = /<link rel="alternate" type="application\/json\+oembed" href="([^"]*)"/.exec(page)![1];
  expect(new URL(link, 'https://example.org/gallery/wisp.html').pathname).toBe('/oembed/wisp.json');
  expect(page).toContain('href="../#v=1&amp;preset=wisp"');
  expect(page).toMatch(/<meta name="description" content="[^"]{40,160}" \/>/);
  const answer = JSON.parse(
    readFileSync(new URL('../../../../dist/oembed/wisp.json', import.meta.url), 'utf8'),
  ) as object;
  expect(answer).toMatchObject({ version: '1.0', type: 'rich', width: 640, height: 360 });
  expect(answer).toHaveProperty(
    'html',
    expect.stringMatching(/^<iframe src="[^"]*embed\.html#v=1&amp;preset=wisp" title="/),
  );
});
