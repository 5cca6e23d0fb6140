/** `clip()` of the package: files of what elements show, wherever their stage runs. */
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import type { clip as Clip, ClipOptions } from '../../../../src/clip.ts';
import { decodeApng } from '../../../support/files/apng.ts';
import { expect, stands, test } from '../../../support/embed.ts';
import { turningBox } from '../../../support/files/glb.ts';

declare global {
  interface Window {
    clip: typeof Clip;
  }
}

const SCRIPT = `
  <script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js" } }</script>
  <script type="module">
    import '/package/dist/element.js';
    import { clip } from '/package/dist/clip.js';
    window.clip = clip;
  </script>`;
const SMALL = 'preset="wisp" simulation-max-particles="300" puff-variations="1" start="3"';
const LOOP = { format: 'apng', duration: 1, fps: 12, width: 240, height: 240 } as const;
/** A box whose pixels are whole at the pixel ratio of the tests, 0.5. */
const OWN_BOX = 'style="width: 60px; height: 40px"';
const STRAIGHT = { format: 'apng', duration: 0.25, fps: 12, loop: false, background: true } as const;
const BRIEF = { format: 'apng', duration: 0.25, fps: 12, width: 60, height: 45 } as const;

/** A clip of an element, what the element reports before and after it, and the progress. */
function clipOf(page: Page, selector: string, options: ClipOptions) {
  return page.evaluate(
    async ([wanted, given]) => {
      const smoke = document.querySelector<CartoonSmokeElement>(wanted)!;
      const report = async () => [await smoke.hash(), (await smoke.stats()).time, smoke.playing, await smoke.get()];
      const before = await report();
      const shares: number[] = [];
      const file = await window.clip(smoke, { ...given, onProgress: (share) => void shares.push(share) });
      const text = Array.from(new Uint8Array(await file.arrayBuffer()), (byte) => String.fromCharCode(byte)).join('');
      const isUntouched = JSON.stringify(before) === JSON.stringify(await report());
      return { type: file.type, base64: btoa(text), shares, isUntouched, thread: (await smoke.stage).thread };
    },
    [selector, options] as const,
  );
}

/** The name and the message of the error of a clip. */
function errorOf(page: Page, selector: string, options: object): Promise<string> {
  return page.evaluate(
    ([wanted, given]) =>
      window.clip(document.querySelector<CartoonSmokeElement>(wanted)!, given as ClipOptions).then(
        () => 'a file',
        (error: Error) => `${error.name}: ${error.message}`,
      ),
    [selector, options] as const,
  );
}

/** The pixels of the element's picture, with its background. */
async function pictureOf(page: Page): Promise<Buffer> {
  const bytes = await page.evaluate(async () => {
    const picture = await document.querySelector<CartoonSmokeElement>('cartoon-smoke')!.picture();
    return [...new Uint8Array(await picture.arrayBuffer())];
  });
  return PNG.sync.read(Buffer.from(bytes)).data;
}

const framesOf = (base64: string) => decodeApng(Buffer.from(base64, 'base64'));

/** Number of pixels whose colour or alpha differs by more than 24. */
function moved(a: Uint8Array, b: Uint8Array): number {
  const pixels = new Set<number>();
  a.forEach((value, at) => Math.abs(value - b[at]) > 24 && pixels.add(at >> 2));
  return pixels.size;
}

test('a paused element gives the same loop with alpha and without a seam, from the page and from a worker', async ({
  page,
  openPage,
  server,
}) => {
  const one = (thread: string) => `<cartoon-smoke id="${thread}" ${SMALL} thread="${thread}" paused></cartoon-smoke>`;
  await openPage(one('main') + one('worker'), { script: SCRIPT });
  await stands(page, '#main');
  await stands(page, '#worker');
  const files = () => server.sent.map(({ file }) => file).join();
  expect(files()).not.toMatch(/makeClip|clipFiles/);
  const [onPage, inWorker] = [await clipOf(page, '#main', LOOP), await clipOf(page, '#worker', LOOP)];
  expect(files()).toMatch(/makeClip.*clipFiles|clipFiles.*makeClip/);
  expect([onPage.thread, inWorker.thread]).toEqual(['main', 'worker']);
  for (const { shares, type, isUntouched } of [onPage, inWorker]) {
    expect({ type, isUntouched }).toEqual({ type: 'image/apng', isUntouched: true });
    expect(shares).toEqual(shares.toSorted((a, b) => a - b));
    expect([shares.length, shares.at(-1)]).toEqual([12 + 6, 1]);
  }
  expect(inWorker.base64 === onPage.base64).toBe(true);
  const { frames, plays, width, height } = framesOf(onPage.base64);
  expect([frames.length, plays, width, height]).toEqual([12, 0, 240, 240]);
  for (const frame of frames) {
    const alphas = frame.filter((_, at) => at % 4 === 3);
    expect(alphas.filter((alpha) => alpha > 0 && alpha < 255).length).toBeGreaterThan(50);
    expect(alphas.filter((alpha) => alpha === 255).length).toBeGreaterThan(500);
    expect(alphas[0]).toBe(0);
  }
  const moves = frames.map((frame, at) => moved(frame, frames[(at + 1) % frames.length]));
  for (const move of moves) expect(move).toBeGreaterThan(20);
  expect(moves.at(-1)).toBeLessThanOrEqual(Math.max(...moves.slice(0, -1)));
});

test('without a loop the clip begins with the picture of the element, and may have its background', async ({
  page,
  openPage,
}) => {
  await openPage(`<cartoon-smoke ${SMALL} thread="main" paused ${OWN_BOX}></cartoon-smoke>`, { script: SCRIPT });
  await stands(page);
  const { base64, shares } = await clipOf(page, 'cartoon-smoke', { ...STRAIGHT, pixelRatio: 0.5 });
  const { frames, width, height } = framesOf(base64);
  expect([shares.length, frames.length, width, height]).toEqual([3, 3, 30, 20]);
  expect(Buffer.compare(frames[0], await pictureOf(page))).toBe(0);
  const looped = framesOf((await clipOf(page, 'cartoon-smoke', { ...STRAIGHT, pixelRatio: 0.5, loop: true })).base64);
  // The first frame of the loop is a twelfth of a second later.
  expect(moved(looped.frames[0], frames[0])).toBeGreaterThan(0);
  expect(Buffer.compare(looped.frames[0], frames[1])).toBe(0);
});

for (const format of ['webp', 'gif'] as const) {
  test(`a ${format} has all frames and alpha`, async ({ page, openPage }) => {
    await openPage(`<cartoon-smoke ${SMALL} thread="main" paused></cartoon-smoke>`, { script: SCRIPT });
    await stands(page);
    const { type, base64 } = await clipOf(page, 'cartoon-smoke', { ...BRIEF, format });
    expect(type).toBe(`image/${format}`);
    const found = await page.evaluate(
      async ([file, kind]) => {
        const data = Uint8Array.from(atob(file), (letter) => letter.charCodeAt(0));
        const decoder = new ImageDecoder({ data, type: kind });
        await decoder.tracks.ready;
        await decoder.completed;
        const { frameCount, repetitionCount } = decoder.tracks.selectedTrack!;
        const { image } = await decoder.decode({ frameIndex: frameCount - 1 });
        const context = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext('2d')!;
        context.drawImage(image, 0, 0);
        const alphas = context.getImageData(0, 0, 60, 45).data.filter((_, at) => at % 4 === 3);
        const opaque = alphas.filter((alpha) => alpha === 255).length;
        return { frameCount, loops: repetitionCount === Infinity, corner: alphas[0], hasSmoke: opaque > 50 };
      },
      [base64, type] as const,
    );
    expect(found).toEqual({ frameCount: 3, loops: true, corner: 0, hasSmoke: true });
  });
}

test('an element without a box and one that plays give clips, and go on @long', async ({ page, openPage }) => {
  const [hidden, playing] = ['id="hidden" loading="eager" paused style="display: none"', 'id="playing"'];
  const elements = [hidden, playing].map((attributes) => `<cartoon-smoke ${SMALL} ${attributes}></cartoon-smoke>`);
  await openPage(elements.join(''), { script: SCRIPT });
  await stands(page, '#hidden');
  await stands(page, '#playing');
  const found = await clipOf(page, '#hidden', BRIEF);
  expect(framesOf(found.base64).frames[0].some((value) => value > 0)).toBe(true);
  expect(found.isUntouched).toBe(true);
  await clipOf(page, '#playing', BRIEF);
  const time = () => page.evaluate(() => document.querySelector<CartoonSmokeElement>('#playing')!.stats());
  const { steps } = await time();
  await expect.poll(async () => (await time()).steps).toBeGreaterThan(steps);
  expect(await page.evaluate(() => document.querySelector<CartoonSmokeElement>('#playing')!.playing)).toBe(true);
});

test.describe('where the page forbids workers', () => {
  test.use({ allowed: /violates the following Content Security Policy directive: "worker-src 'none'"/ });

  test('the file is the same @long', async ({ page, openPage }) => {
    const started: string[] = [];
    page.on('worker', (worker) => started.push(worker.url()));
    const fileOn = async (headers: Record<string, string>) => {
      await openPage(`<cartoon-smoke ${SMALL} thread="main" paused></cartoon-smoke>`, { script: SCRIPT, headers });
      await stands(page);
      return (await clipOf(page, 'cartoon-smoke', BRIEF)).base64;
    };
    const file = await fileOn({});
    expect(started).toEqual([expect.stringMatching(/clipFiles\.js$/)]);
    expect((await fileOn({ 'content-security-policy': "worker-src 'none'" })) === file).toBe(true);
    expect(started.length).toBe(1);
  });
});

test('a clip is cancelled before it starts, while the smoke loads and between frames', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${SMALL} thread="main" paused></cartoon-smoke>`, { script: SCRIPT });
  const outcomes = await page.evaluate(async (options) => {
    const smoke = document.querySelector<CartoonSmokeElement>('cartoon-smoke')!;
    const nameOf = (work: Promise<unknown>) =>
      work.then(
        () => 'a file',
        (error: Error) => error.name,
      );
    const before = await nameOf(window.clip(smoke, { ...options, signal: AbortSignal.abort() }));
    // Never answers, as an element whose smoke loads for long.
    const endless = new Promise<never>(() => undefined);
    const loading = new AbortController();
    const waits = window.clip({ get: () => endless, save: () => endless }, { ...options, signal: loading.signal });
    setTimeout(() => loading.abort(), 50);
    const meanwhile = await nameOf(waits);
    const between = new AbortController();
    let shares = 0;
    const onProgress = () => void (++shares === 2 && between.abort());
    const hash = await smoke.hash();
    const during = await nameOf(window.clip(smoke, { ...options, duration: 5, onProgress, signal: between.signal }));
    return { before, meanwhile, during, shares, isSame: hash === (await smoke.hash()) };
  }, BRIEF);
  const cancelled = { before: 'AbortError', meanwhile: 'AbortError', during: 'AbortError' };
  expect(outcomes).toEqual({ ...cancelled, shares: 2, isSame: true });
  await expect.poll(() => page.workers().length).toBe(0);
});

test('errors say what is missing', async ({ page, openPage }) => {
  await openPage(`<p></p><cartoon-smoke ${SMALL} style="display: none" thread="main" paused></cartoon-smoke>`, {
    script: SCRIPT,
  });
  await page.waitForFunction(() => window.clip);
  const { width: _width, height: _height, ...ownSize } = BRIEF;
  expect(await errorOf(page, 'p', BRIEF)).toContain('it takes an element <cartoon-smoke>, a RemoteStage or a Stage.');
  expect(await errorOf(page, 'cartoon-smoke', ownSize)).toBe(
    'ParameterError: clip.width cannot be 0: it takes a number from 1 to 16383 CSS pixels. The smoke has no size of its own.',
  );
  expect(await errorOf(page, 'cartoon-smoke', { ...BRIEF, width: 16_383 })).toMatch(
    /^UnsupportedError: 16383 × 45 pixels are too large for this GPU\. The limit is \d+ pixels per side\.$/,
  );
  expect(await errorOf(page, 'cartoon-smoke', { ...BRIEF, format: 'mp4' })).toMatch(/^ParameterError: clip\.format/);
  const others = await page.evaluate(async (options) => {
    const messageOf = (work: Promise<unknown>) =>
      work.then(
        () => 'a file',
        (error: Error) => error.message,
      );
    const removed = document.querySelector<CartoonSmokeElement>('cartoon-smoke')!;
    removed.remove();
    const detached = await messageOf(window.clip(removed, options));
    const { convertToBlob } = OffscreenCanvas.prototype;
    OffscreenCanvas.prototype.convertToBlob = function () {
      return convertToBlob.call(this, { type: 'image/png' });
    };
    document.body.append(removed);
    return [detached, await messageOf(window.clip(removed, { ...options, format: 'webp' }))];
  }, BRIEF);
  expect(others[0]).toContain('it takes an element that is in the page.');
  expect(others[1]).toBe('This browser cannot encode WebP. Use the format apng, which every browser shows.');
});

test('smoke with a model needs its file, and is then the picture of the element @long', async ({ page, openPage }) => {
  await openPage(`<cartoon-smoke ${SMALL} thread="worker" paused ${OWN_BOX}></cartoon-smoke>`, { script: SCRIPT });
  await stands(page);
  const plain = await pictureOf(page);
  const found = await page.evaluate(
    async ([file, options]) => {
      const smoke = document.querySelector<CartoonSmokeElement>('cartoon-smoke')!;
      await smoke.setModel(Uint8Array.from(file));
      await smoke.step(30);
      const without = await window.clip(smoke, options).catch((error: Error) => error.name);
      const clip = await window.clip(smoke, { ...options, pixelRatio: 0.5, model: Uint8Array.from(file) });
      return { without, bytes: [...new Uint8Array(await clip.arrayBuffer())] };
    },
    [[...turningBox().pack()], STRAIGHT] as const,
  );
  expect(found.without).toBe('SimulatorError');
  const [first] = decodeApng(Buffer.from(found.bytes)).frames;
  const picture = await pictureOf(page);
  expect(Buffer.compare(first, picture)).toBe(0);
  expect(moved(picture, plain)).toBeGreaterThan(20);
});
