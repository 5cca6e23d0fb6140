/** Frame times of the GPU, with a stub of EXT_disjoint_timer_query_webgl2. */
import { expect, test } from 'vitest';
import type { ContextEvent, Device } from '../../../../src/renderer/gpu/device.ts';
import { createGpuTimer, type GpuTimer } from '../../../../src/renderer/gpu/gpuTimer.ts';

const [TIME_ELAPSED_EXT, GPU_DISJOINT_EXT, QUERY_RESULT_AVAILABLE, QUERY_RESULT] = [1, 2, 3, 4];

interface Query {
  isOpen: boolean;
  nanoseconds?: number;
}

/** A context whose queries have results when `finish` is called. Fails where WebGL would report an error. */
class Browser {
  isDisjoint = false;
  queries: Query[] = [];
  begun = 0;
  readonly listeners = new Set<(event: ContextEvent) => void>();
  private extension: object | null = { TIME_ELAPSED_EXT, GPU_DISJOINT_EXT };
  private readonly context = {
    QUERY_RESULT_AVAILABLE,
    QUERY_RESULT,
    getExtension: () => this.extension,
    createQuery: () => ({ isOpen: false }),
    beginQuery: (target: number, query: Query) => {
      expect(target).toBe(TIME_ELAPSED_EXT);
      expect(this.queries.some(({ isOpen }) => isOpen)).toBe(false);
      query.isOpen = true;
      this.begun += 1;
      this.queries.push(query);
    },
    endQuery: () => (this.open!.isOpen = false),
    deleteQuery: (query: Query) => {
      expect(this.queries).toContain(query);
      this.queries = this.queries.filter((each) => each !== query);
    },
    getQueryParameter: (query: Query, name: number) => {
      expect(this.queries, 'a query of a lost context').toContain(query);
      if (name === QUERY_RESULT_AVAILABLE) return query.nanoseconds !== undefined;
      expect(query.nanoseconds, 'reading would wait for the GPU').toBeDefined();
      return query.nanoseconds;
    },
    getParameter: () => {
      const { isDisjoint } = this;
      this.isDisjoint = false;
      return isDisjoint;
    },
  };

  get device(): Pick<Device, 'renderer' | 'onContext'> {
    return {
      renderer: { getContext: () => this.context } as unknown as Device['renderer'],
      onContext: (listener) => {
        this.listeners.add(listener);
        return () => this.listeners.delete(listener);
      },
    };
  }

  private get open(): Query | undefined {
    return this.queries.find(({ isOpen }) => isOpen);
  }

  without(): this {
    this.extension = null;
    return this;
  }

  draw(...timers: GpuTimer[]): void {
    for (const timer of timers) timer.begin()?.();
  }

  /** Gives the oldest query without a result one. */
  finish(milliseconds: number): void {
    this.queries.find(({ nanoseconds }) => nanoseconds === undefined)!.nanoseconds = milliseconds * 1e6;
  }

  lose(): void {
    for (const listener of this.listeners) listener('lost');
    this.queries = [];
    for (const listener of this.listeners) listener('restored');
  }
}

test('a frame has its time when the result is available', () => {
  const browser = new Browser();
  const timer = createGpuTimer(browser.device);
  browser.draw(timer, timer);
  expect(timer.read()).toBeUndefined();
  browser.finish(2.5);
  expect(timer.read()).toEqual({ gpuMs: 2.5 });
  browser.finish(3);
  expect(timer.read()).toEqual({ gpuMs: 3 });
  expect(browser.queries).toEqual([]);
});

test('three frames at most wait for their results', () => {
  const browser = new Browser();
  const timer = createGpuTimer(browser.device);
  for (let frame = 0; frame < 9; frame++) browser.draw(timer);
  expect(browser.begun).toBe(3);
  browser.finish(1);
  browser.draw(timer, timer);
  expect(browser.begun).toBe(4);
});

test('a disjoint GPU drops the frames of every stage of the context', () => {
  const browser = new Browser();
  const [timer, other] = [createGpuTimer(browser.device), createGpuTimer(browser.device)];
  browser.draw(timer, other, timer, other);
  browser.finish(400);
  browser.isDisjoint = true;
  expect(timer.read()).toBeUndefined();
  expect(browser.queries).toEqual([]);
  browser.draw(timer, other);
  browser.finish(4);
  browser.finish(5);
  expect([timer.read(), other.read()]).toEqual([{ gpuMs: 4 }, { gpuMs: 5 }]);
});

test('creating and disposing of a timer leaves the frames of others', () => {
  const browser = new Browser();
  const timer = createGpuTimer(browser.device);
  browser.draw(timer);
  const other = createGpuTimer(browser.device);
  browser.draw(other);
  other.dispose();
  browser.finish(7);
  expect(timer.read()).toEqual({ gpuMs: 7 });
});

test('without the extension nothing is measured', () => {
  const browser = new Browser().without();
  const timer = createGpuTimer(browser.device);
  browser.draw(timer);
  expect([browser.begun, timer.read()]).toEqual([0, undefined]);
});

test('it continues after a lost context, and leaves no query behind', () => {
  const browser = new Browser();
  const [timer, other] = [createGpuTimer(browser.device), createGpuTimer(browser.device)];
  browser.draw(timer, other);
  browser.lose();
  browser.draw(timer, other);
  browser.finish(6);
  expect(timer.read()).toEqual({ gpuMs: 6 });
  browser.draw(timer, other);
  timer.dispose();
  other.dispose();
  expect([browser.queries, browser.listeners.size]).toEqual([[], 0]);
});
