import type { Device } from './device.ts';

/**
 * Faults that a page cannot cause on purpose, so that an application can test how it handles them. They are available
 * in the sources only; builds do not contain them.
 *
 * - `outOfMemory`: the simulator's memory is full before the first particle.
 * - `contextLostInStart`: the WebGL context is lost before the first frame and is not restored.
 * - `workerSilent`: the worker exits without a message after it has received its request.
 */
export type Fault = 'outOfMemory' | 'contextLostInStart' | 'workerSilent';

/** Most pages of a 32-bit WebAssembly memory. */
const MAX_PAGES = 65_536;

/**
 * Grows a memory to its limit, so that the next allocation fails. Browsers reserve these pages but do not commit them.
 */
export function fill(memory: WebAssembly.Memory): void {
  const pages = memory.buffer.byteLength / 65_536;
  for (let step = MAX_PAGES - pages; step >= 1; step = Math.floor(step / 2)) growBy(memory, step);
}

export function loseContext({ renderer }: Device): void {
  renderer.getContext().getExtension('WEBGL_lose_context')?.loseContext();
}

/** Grows by a step until it fails: browsers refuse steps that are too large. */
function growBy(memory: WebAssembly.Memory, step: number): void {
  try {
    for (;;) memory.grow(step);
  } catch {
    // A smaller step may still succeed.
  }
}
