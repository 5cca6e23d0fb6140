/** Options of `clip()` that are refused, and what is missing is filled in. */
import { expect, test, vi } from 'vitest';
import { orderOf, requireSmoke, type ClipOptions } from '../../../../src/page/clip/options.ts';

const VALID = { format: 'apng', duration: 1, width: 240, height: 240 } as const;
const SMOKE = { get: () => ({}), save: () => new Uint8Array() };

const REFUSED: readonly (readonly [change: object, message: string])[] = [
  [{ format: undefined }, 'clip.format cannot be undefined: it takes one of apng, webp, gif.'],
  [{ format: 'mp4' }, 'clip.format cannot be “mp4”: it takes one of apng, webp, gif.'],
  [{ format: ['apng'] }, 'clip.format cannot be apng: it takes one of apng, webp, gif.'],
  [{ duration: undefined }, 'clip.duration cannot be undefined: it takes a number from 0.1 to 60 seconds.'],
  [{ duration: 0 }, 'clip.duration cannot be 0: it takes a number from 0.1 to 60 seconds.'],
  [{ duration: '2' }, 'clip.duration cannot be “2”: it takes a number from 0.1 to 60 seconds.'],
  [{ duration: 3600 }, 'clip.duration cannot be 3600: it takes a number from 0.1 to 60 seconds.'],
  [{ fps: NaN }, 'clip.fps cannot be NaN: it takes a number from 1 to 60 frames per second as apng.'],
  [{ fps: 61 }, 'clip.fps cannot be 61: it takes a number from 1 to 60 frames per second as apng.'],
  [{ format: 'gif', fps: 60 }, 'clip.fps cannot be 60: it takes a number from 1 to 30 frames per second as gif.'],
  [{ width: -1 }, 'clip.width cannot be -1: it takes a number from 1 to 16383 CSS pixels.'],
  [{ height: Infinity }, 'clip.height cannot be Infinity: it takes a number from 1 to 16383 CSS pixels.'],
  [{ width: 9000, pixelRatio: 2 }, 'clip.width cannot be 9000: it takes a number from 1 to 8191.5 CSS pixels.'],
  [
    { height: undefined },
    'clip.height cannot be undefined: it takes a number from 1 to 16383 CSS pixels. The smoke has no size of its own.',
  ],
  [{ pixelRatio: 0 }, 'clip.pixelRatio cannot be 0: it takes a number from 0.1 to 4 pixels per CSS pixel.'],
  [{ pixelRatio: 1e9 }, 'clip.pixelRatio cannot be 1000000000: it takes a number from 0.1 to 4 pixels per CSS pixel.'],
  [{ loop: 1 }, 'clip.loop cannot be 1: it takes true or false.'],
  [{ background: 'none' }, 'clip.background cannot be “none”: it takes true or false.'],
  [{ onProgress: true }, 'clip.onProgress cannot be true: it takes a function.'],
  [{ signal: null }, 'clip.signal cannot be null: it takes an AbortSignal.'],
  [{ model: 'model.glb' }, 'clip.model cannot be “model.glb”: it takes the bytes of a GLB file.'],
  [
    { seconds: 2 },
    'clip.seconds cannot be 2: it takes no value: its options are format, duration, fps, width, height, pixelRatio, background, loop, model, modelOptions, onProgress, signal.',
  ],
];

test.each(REFUSED)('%j is refused', (change, message) => {
  const given = { ...VALID, ...change } as ClipOptions;
  expect(() => orderOf(SMOKE, given)).toThrow(expect.objectContaining({ name: 'ParameterError', message }));
});

test.each([undefined, null, 5, 'apng'])('%j is not an object of options', (given) => {
  expect(() => orderOf(SMOKE, given as unknown as ClipOptions)).toThrow(
    /^clip cannot be .* an object with the options/,
  );
});

test('the other options have defaults, also where undefined is given', () => {
  const order = orderOf(SMOKE, { ...VALID, fps: undefined, loop: undefined });
  expect(order).toMatchObject({ ...VALID, fps: 24, pixelRatio: 1, background: false, loop: true });
  expect(order.signal.aborted).toBe(false);
});

test.each([undefined, null, 'cartoon-smoke', {}, { get: () => ({}) }, { get: 1, save: 2 }])(
  '%j is no smoke',
  (smoke) => {
    expect(() => requireSmoke(smoke)).toThrow(/^clip\.smoke cannot be .* RemoteStage or a Stage\.$/);
  },
);

test('smoke needs WebGL2', () => {
  expect(() => requireSmoke(SMOKE)).toThrow(expect.objectContaining({ name: 'UnsupportedError' }));
  vi.stubGlobal('WebGL2RenderingContext', Object);
  expect(() => requireSmoke(SMOKE)).not.toThrow();
  vi.unstubAllGlobals();
});
