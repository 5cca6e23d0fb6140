import type { Page, Worker } from '@playwright/test';

type Shared = typeof import('../../../../src/stage/remote/openHere.ts');

/** A page or a worker. */
type Thread = Pick<Worker, 'evaluate' | 'evaluateHandle'>;

/** Loses or restores the context of a thread, and waits for the event. */
export async function changeContext(thread: Thread, way: 'loseContext' | 'restoreContext'): Promise<void> {
  const shared = await thread.evaluateHandle(`import('/src/stage/remote/openHere.ts')`);
  await thread.evaluate(
    async ([module, method]) => {
      const { threadDevice } = module as Shared;
      const device = threadDevice.acquire()!;
      threadDevice.release(device);
      const event = method === 'loseContext' ? 'webglcontextlost' : 'webglcontextrestored';
      const happens = new Promise((resolve) => device.canvas.addEventListener(event, resolve, { once: true }));
      const kept = globalThis as { losing?: WEBGL_lose_context | null };
      // A lost context returns no extensions.
      if (method === 'loseContext') kept.losing = device.renderer.getContext().getExtension('WEBGL_lose_context');
      kept.losing![method]();
      await happens;
      // The browser decides about restoring only after the event's last listener.
      await new Promise((resolve) => setTimeout(resolve));
    },
    [shared, way] as const,
  );
}

/**
 * Sets a thread's timeouts of ten seconds or more, such as the one for a lost context, to infinity or zero. Tests
 * cannot control the clock of a worker.
 */
export async function setTimeouts(thread: Thread, timeout: 'endless' | 'none'): Promise<void> {
  await thread.evaluate((given) => {
    const kept = globalThis as { original?: typeof setTimeout };
    const original = (kept.original ??= globalThis.setTimeout);
    const wait = (act: () => void, milliseconds = 0) => {
      if (milliseconds < 10_000) return original(act, milliseconds);
      return given === 'none' ? original(act) : 0;
    };
    Object.assign(globalThis, { setTimeout: wait });
  }, timeout);
}

/** Keeps the latest context of each document of a page, for pages whose modules cannot be imported. */
export async function keepContexts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
      const native = prototype.getContext as (...given: unknown[]) => RenderingContext | null;
      prototype.getContext = function (this: unknown, kind: string, ...rest: unknown[]) {
        const context = native.call(this, kind, ...rest);
        const losing = kind === 'webgl2' && (context as WebGL2RenderingContext | null);
        if (losing) Object.assign(globalThis, { losing: losing.getExtension('WEBGL_lose_context') });
        return context;
      } as never;
    }
  });
}

/** Loses the latest context that was kept, for good. */
export async function loseForGood(thread: Thread): Promise<void> {
  await setTimeouts(thread, 'none');
  await thread.evaluate(() => (globalThis as { losing?: WEBGL_lose_context | null }).losing!.loseContext());
}

/** Restores a context that its device has given up. */
export async function restoreLate(thread: Thread): Promise<void> {
  await thread.evaluate(() => (globalThis as { losing?: WEBGL_lose_context | null }).losing!.restoreContext());
}
