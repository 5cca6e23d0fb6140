/** A dead worker is distinguished from one that is too busy to respond, and from a page that was suspended. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { afterRunning, fetched } from '../../../../src/base/timeout.ts';
import { beatWhile, watchHeart } from '../../../../src/stage/remote/heartbeat.ts';

const MINUTE = 60_000;
const page = { hidden: false };
let answers = true;
let beats = 0;
let stop: () => void;
const onGone = vi.fn();

/** Watches a worker that responds immediately while it is alive. */
function watch(): EventTarget {
  const worker = new EventTarget();
  const postMessage = () => {
    beats += 1;
    if (answers) worker.dispatchEvent(new Event('message'));
  };
  stop = watchHeart({ worker: Object.assign(worker, { postMessage }), onGone });
  return worker;
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('document', page);
  Object.assign(page, { hidden: false });
  [answers, beats] = [true, 0];
  onGone.mockClear();
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test('a worker that answers stays alive and gets six heartbeats per minute', () => {
  watch();
  vi.advanceTimersByTime(60 * MINUTE);
  expect(onGone).not.toHaveBeenCalled();
  expect(beats).toBe(360);
});

test('a silent worker is reported lost once after two minutes and gets no more heartbeats', () => {
  watch();
  answers = false;
  vi.advanceTimersByTime(2 * MINUTE);
  expect(onGone).not.toHaveBeenCalled();
  vi.advanceTimersByTime(10_000);
  expect(onGone).toHaveBeenCalledTimes(1);
  vi.advanceTimersByTime(60 * MINUTE);
  expect([onGone.mock.calls.length, beats]).toEqual([1, 12]);
});

test('a busy worker sends heartbeats on its own and stays alive', () => {
  const worker = watch();
  answers = false;
  const onStep = beatWhile(() => worker.dispatchEvent(new Event('message')));
  const steps = (minutes: number) => {
    for (let second = 0; second < 60 * minutes; ++second) {
      vi.advanceTimersByTime(1000);
      onStep();
    }
  };
  steps(90);
  expect(onGone).not.toHaveBeenCalled();
  vi.advanceTimersByTime(2 * MINUTE + 10_000);
  expect(onGone).toHaveBeenCalledTimes(1);
});

test('a busy worker sends at most one heartbeat per ten seconds', () => {
  const beat = vi.fn();
  const onStep = beatWhile(beat);
  for (let step = 0; step < 6000; ++step) {
    vi.advanceTimersByTime(10);
    onStep();
  }
  expect(beat).toHaveBeenCalledTimes(6);
});

test('a hidden page sends no heartbeats and reports no worker lost', () => {
  watch();
  answers = false;
  vi.advanceTimersByTime(MINUTE);
  page.hidden = true;
  vi.advanceTimersByTime(24 * 60 * MINUTE);
  expect([onGone.mock.calls.length, beats]).toEqual([0, 6]);
  page.hidden = false;
  vi.advanceTimersByTime(2 * MINUTE);
  expect(onGone).not.toHaveBeenCalled();
});

test('a night of sleep counts as one heartbeat', () => {
  watch();
  answers = false;
  // As after system sleep or a debugger pause: the clock has advanced, and each timer fires once.
  for (let night = 0; night < 10; ++night) {
    vi.setSystemTime(Date.now() + 8 * 60 * MINUTE);
    vi.advanceTimersByTime(10_000);
  }
  expect(onGone).not.toHaveBeenCalled();
});

test('no loss is reported after watching has stopped', () => {
  watch();
  answers = false;
  stop();
  vi.advanceTimersByTime(60 * MINUTE);
  expect([onGone.mock.calls.length, beats]).toEqual([0, 0]);
});

test('timeouts count only seconds in which the page ran', () => {
  const late = vi.fn();
  afterRunning(MINUTE, late);
  vi.advanceTimersByTime(59_000);
  vi.setSystemTime(Date.now() + 60 * MINUTE);
  expect(late).not.toHaveBeenCalled();
  vi.advanceTimersByTime(1_000);
  expect(late).toHaveBeenCalledTimes(1);
  const stopWaiting = afterRunning(MINUTE, late);
  stopWaiting();
  vi.advanceTimersByTime(2 * MINUTE);
  expect(late).toHaveBeenCalledTimes(1);
});

test('a download succeeds, fails with a LoadError or times out after a minute, and leaves no timer', async () => {
  expect(await fetched('It', Promise.resolve(3))).toBe(3);
  const failed = expect(fetched('It', Promise.reject(new Error('gone')))).rejects;
  await failed.toMatchObject({ name: 'LoadError', message: 'It could not be loaded: gone' });
  const silent = fetched('It', new Promise(() => undefined)).catch((error: Error) => `${error.name}: ${error.message}`);
  vi.advanceTimersByTime(MINUTE);
  expect(await silent).toBe('LoadError: It could not be loaded: no data for 60 s.');
  expect(vi.getTimerCount()).toBe(0);
});
