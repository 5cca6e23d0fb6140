import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Device } from '../../../../src/renderer/gpu/device.ts';
import { FrameLoop } from '../../../../src/stage/frameLoop.ts';
import { Crowd, type CrowdTurns } from '../../../../src/stage/remote/crowd.ts';

const [UNSIGNALED, SIGNALED] = [0, 1];
const REFRESH = 1000 / 60;

let callbacks: ((now: number) => void)[];
beforeEach(() => {
  callbacks = [];
  vi.stubGlobal('requestAnimationFrame', (callback: (now: number) => void) => callbacks.push(callback));
  vi.stubGlobal('cancelAnimationFrame', (request: number) => (callbacks[request - 1] = () => {}));
});
afterEach(() => vi.unstubAllGlobals());

/** A stage without a scene. */
interface FakeStage {
  readonly turns: CrowdTurns;
  readonly loop: FrameLoop;
  /** Numbers of the page's frames in which it drew. */
  readonly drawn: number[];
  steps: number;
}

/** Milliseconds that a frame takes, by its drawings. */
type Load = (drawings: number) => number;

/** A page with playing stages on a slow machine with a 60 Hz display. */
class Page {
  readonly stages: FakeStage[];
  frame = 0;
  isGpuBusy = false;
  /** In refreshes of the display. */
  private now = 300;
  private readonly load: Load;

  constructor(count: number, load: Load) {
    this.load = load;
    const context = {
      fenceSync: () => ({}),
      flush: () => {},
      deleteSync: () => {},
      getSyncParameter: () => (this.isGpuBusy ? UNSIGNALED : SIGNALED),
      UNSIGNALED,
    };
    const device = { renderer: { getContext: () => context }, onContext: () => () => {} };
    const crowd = new Crowd(device as unknown as Device);
    this.stages = Array.from({ length: count }, () => this.join(crowd));
  }

  run(seconds: number): this {
    const end = this.now + Math.round(60 * seconds);
    while (this.now < end) {
      this.frame += 1;
      for (const callback of callbacks.splice(0)) callback(this.now * REFRESH);
      const ms = this.load(this.drawings(this.frame));
      this.now += Math.max(1, Math.ceil(ms / REFRESH - 1e-6));
    }
    return this;
  }

  /** Number of drawings in a frame. */
  drawings(frame: number): number {
    return this.stages.filter(({ drawn }) => drawn.includes(frame)).length;
  }

  /** Runs for some seconds and returns the drawings of each stage and of each frame, and the steps of each stage. */
  count(seconds: number): { byStage: number[]; byFrame: number[]; steps: number[] } {
    const first = this.frame + 1;
    const before = this.stages.map(({ steps }) => steps);
    this.run(seconds);
    return {
      byStage: this.stages.map(({ drawn }) => drawn.filter((frame) => frame >= first).length),
      byFrame: Array.from({ length: this.frame - first + 1 }, (_, index) => this.drawings(first + index)),
      steps: this.stages.map(({ steps }, index) => steps - before[index]),
    };
  }

  private join(crowd: Crowd): FakeStage {
    const turns = crowd.join();
    const tasks = {
      isBehind: false,
      frame: (steps: number, isDrawn: boolean) => {
        stage.steps += steps;
        if (isDrawn) stage.drawn.push(this.frame);
      },
      fail: (error: Error) => {
        throw error;
      },
    };
    const stage: FakeStage = { turns, loop: new FrameLoop(tasks, 60, turns), drawn: [], steps: 0 };
    stage.loop.play();
    return stage;
  }
}

/** @param ms for each drawing */
function each(ms: number): Load {
  return (drawings) => ms * drawings;
}

function expectAll(values: readonly number[], least: number, most = least): void {
  expect(Math.min(...values)).toBeGreaterThanOrEqual(least);
  expect(Math.max(...values)).toBeLessThanOrEqual(most);
}

test('a crowd that keeps its rate draws in every frame', () => {
  const { byStage, byFrame } = new Page(40, each(0.4)).run(3).count(1);
  expect(byFrame.length).toBe(60);
  expectAll(byStage, 60);
});

test('a crowd that is too slow draws on twos, with equal shares in all frames, and takes all steps', () => {
  const { byStage, byFrame, steps } = new Page(40, each(2)).run(3).count(1);
  expectAll(byFrame, 8);
  expectAll(byStage, 12);
  expectAll(steps, 60);
});

test.each([
  [2, 3],
  [3, 4],
])('a share of one in %i is enough for a crowd of 10 with %s ms a drawing', (period, ms) => {
  const page = new Page(10, each(ms)).run(3);
  const { byStage, byFrame } = page.count(1);
  expectAll(byFrame, Math.floor(10 / period), Math.ceil(10 / period));
  expectAll(byStage, 60 / period);
  for (const { drawn } of page.stages) {
    const latest = drawn.slice(-10);
    expectAll(
      latest.slice(1).map((frame, index) => frame - latest[index]),
      period,
    );
  }
});

test('neighbours draw in the same frame', () => {
  const page = new Page(40, each(2)).run(4);
  const places = page.stages.flatMap(({ drawn }, place) => (drawn.includes(page.frame) ? [place] : []));
  expect(places.length).toBe(8);
  expect(places.at(-1)! - places[0]).toBe(7);
});

test('a few stages draw in every frame, however slow', () => {
  const { byStage, byFrame } = new Page(4, each(20)).run(5).count(2);
  expectAll(byStage, byFrame.length);
});

test('a stage with input draws in every frame for a second', () => {
  const page = new Page(40, each(1.4)).run(2);
  page.stages[7].turns.touch();
  const touched = page.count(0.9);
  expect(touched.byStage[7]).toBe(touched.byFrame.length);
  expectAll(touched.byStage.toSpliced(7, 1), 13, 14);
  page.run(1);
  expect(page.count(1).byStage[7]).toBe(15);
});

test('a crowd that shrinks to a few draws in every frame at once', () => {
  const page = new Page(40, each(2)).run(4);
  for (const { loop } of page.stages.slice(4)) loop.isSeen = false;
  page.run(0.1);
  expectAll(page.count(1).byStage.slice(0, 4), 60);
});

test('a crowd that comes into view does not draw all at once', () => {
  const page = new Page(40, each(2)).run(3);
  const showAll = (isSeen: boolean) => page.stages.forEach(({ loop }) => (loop.isSeen = isSeen));
  showAll(false);
  page.run(1);
  showAll(true);
  const { byFrame } = page.count(1);
  // The first frame has no steps, so its turn moves to the second.
  expectAll(byFrame.slice(0, 2), 0, 16);
  expectAll(byFrame.slice(2), 8);
});

test('on a display that is slow by itself, stages draw in every frame', () => {
  const { byStage, byFrame } = new Page(10, () => 2 * REFRESH).run(20).count(2);
  expectAll(byStage, byFrame.length);
});

test('while the GPU still draws the last two frames, no stage steps or draws', () => {
  const page = new Page(6, each(1)).run(1);
  page.isGpuBusy = true;
  const { byStage, steps } = page.count(1);
  expectAll(byStage, 1);
  expectAll(steps, 1);
  page.isGpuBusy = false;
  expectAll(page.count(1).byStage, 60);
});
