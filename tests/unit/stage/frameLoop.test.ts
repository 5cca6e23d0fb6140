import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { FrameLoop } from '../../../src/stage/frameLoop.ts';

let callbacks: ((now: number) => void)[];
let frames: number;
let steps: number;
let isBehind: boolean;

beforeEach(() => {
  callbacks = [];
  frames = steps = 0;
  isBehind = false;
  vi.stubGlobal('requestAnimationFrame', (callback: (now: number) => void) => callbacks.push(callback));
  vi.stubGlobal('cancelAnimationFrame', (request: number) => (callbacks[request - 1] = () => {}));
});
afterEach(() => vi.unstubAllGlobals());

function loopOf(frameRate?: number): FrameLoop {
  const tasks = {
    get isBehind() {
      return isBehind;
    },
    frame: (count: number) => {
      frames += 1;
      steps += count;
    },
    fail: (error: Error) => {
      throw error;
    },
  };
  return new FrameLoop(tasks, frameRate);
}

/** Simulates one second of screen frames with one millisecond of jitter. */
function second(screenRate: number, from = 0): void {
  for (let frame = 0; frame < screenRate; ++frame) {
    callbacks.splice(-1).forEach((callback) => callback(from + (1000 * frame) / screenRate + (frame % 2)));
  }
}

test.each([
  [undefined, 120, 120],
  [60, 60, 60],
  [60, 75, 60],
  [60, 120, 60],
  [60, 144, 60],
  [30, 60, 30],
  [60, 30, 30],
])('a loop with a cap of %s frames per second on a display of %i Hz draws %i', (cap, screen, expected) => {
  loopOf(cap).play();
  second(screen);
  expect(Math.abs(frames - expected)).toBeLessThanOrEqual(1);
});

test('out of view it requests no frames and stays playing', () => {
  const loop = loopOf();
  loop.play();
  second(60);
  loop.isSeen = false;
  const before = frames;
  second(60, 1000);
  expect(frames).toBe(before);
  expect(loop.isPlaying).toBe(true);
  loop.isSeen = true;
  second(60, 2000);
  // No time has passed before the first frame.
  expect(frames).toBe(before + 59);
});

test('no picture is drawn twice for the same time', () => {
  const loop = loopOf();
  loop.play();
  second(1);
  expect(frames).toBe(0);
  second(1, 1000 / 60);
  expect(frames).toBe(1);
});

test('if a whole step is due at the start, it is drawn at once', () => {
  const loop = loopOf();
  loop.clock.settle();
  loop.play();
  second(1);
  expect(frames).toBe(1);
});

test('coming into view does not resume what was paused before or meanwhile', () => {
  const loop = loopOf();
  loop.isSeen = false;
  loop.isSeen = true;
  second(60);
  loop.play();
  loop.isSeen = false;
  loop.stop();
  loop.isSeen = true;
  second(60);
  expect(frames).toBe(0);
  expect(loop.isPlaying).toBe(false);
});

test('frames are skipped while earlier ones are still drawn, and the next one advances by the whole time', () => {
  const loop = loopOf();
  loop.play();
  second(60);
  const [before, taken] = [frames, steps];
  isBehind = true;
  for (const now of [1000, 1016, 1033]) second(1, now);
  expect(frames).toBe(before);
  isBehind = false;
  second(1, 1050);
  expect(frames).toBe(before + 1);
  expect(steps - taken).toBeGreaterThanOrEqual(3);
});
