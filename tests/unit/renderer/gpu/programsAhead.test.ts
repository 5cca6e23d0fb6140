/** When programs count as compiled, with stubs of the context: with KHR_parallel_shader_compile and without. */
import { RawShaderMaterial, type WebGLRenderer } from 'three';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { ProgramsAhead, shadersOf } from '../../../../src/renderer/gpu/programsAhead.ts';
import { nextTask } from '../../../../src/base/work.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const [SYNC_STATUS, UNSIGNALED, SIGNALED] = [1, 2, 3];

/** A browser whose fence has passed and whose programs are ready when the flags say so. */
class Browser {
  fence = UNSIGNALED;
  isReady = false;
  isLost = false;
  readonly context = {
    SYNC_STATUS,
    UNSIGNALED,
    fenceSync: () => (this.isLost ? null : {}),
    flush: () => undefined,
    getSyncParameter: () => this.fence,
    isContextLost: () => this.isLost,
  };
  readonly renderer = {
    getContext: () => this.context,
    info: {
      programs: [true, false].map((always) => ({
        isReady: () => always || this.isReady,
        getUniforms: () => void this.read++,
      })),
    },
  } as unknown as WebGLRenderer;
  hasFinished = false;
  /** Programs whose uniforms were read. */
  read = 0;

  wait(): void {
    void new ProgramsAhead().finished(this.renderer).then(() => (this.hasFinished = true));
  }
}

async function hasFinished(browser: Browser, milliseconds = 100): Promise<boolean> {
  await vi.advanceTimersByTimeAsync(milliseconds);
  // The uniforms of each program are read in a task of its own.
  for (let task = 0; task < 3; task++) await nextTask();
  return browser.hasFinished;
}

test('with the extension, programs are ready when the browser says so', async () => {
  const browser = new Browser();
  browser.wait();
  browser.fence = SIGNALED;
  expect(await hasFinished(browser)).toBe(false);
  expect(browser.read).toBe(0);
  browser.isReady = true;
  expect(await hasFinished(browser)).toBe(true);
  expect(browser.read).toBe(2);
});

test('without the extension, they are ready when the GPU has passed the fence', async () => {
  const browser = new Browser();
  browser.isReady = true;
  browser.wait();
  expect(await hasFinished(browser)).toBe(false);
  browser.fence = SIGNALED;
  expect(await hasFinished(browser)).toBe(true);
});

test('a lost context ends the wait', async () => {
  const [before, during] = [new Browser(), new Browser()];
  before.isLost = true;
  before.wait();
  during.wait();
  expect(await hasFinished(before)).toBe(true);
  expect(await hasFinished(during)).toBe(false);
  during.isLost = true;
  expect(await hasFinished(during)).toBe(true);
});

test('a browser that never finishes delays the start by ten seconds at most', async () => {
  const browser = new Browser();
  browser.wait();
  expect(await hasFinished(browser, 9_900)).toBe(false);
  expect(await hasFinished(browser, 200)).toBe(true);
});

test('a pass draws with the materials of its fields and of what it draws', () => {
  const material = (fragmentShader: string) => new RawShaderMaterial({ fragmentShader });
  const pass = {
    size: 1,
    missing: undefined,
    drawn: { material: material('drawn') },
    own: material('own'),
    several: [{ material: material('first') }, { material: material('second') }],
  };
  expect(shadersOf(pass).map(({ fragmentShader }) => fragmentShader)).toEqual(['drawn', 'own', 'first', 'second']);
});
