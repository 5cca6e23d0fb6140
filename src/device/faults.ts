import type { Device } from './device.ts';

/**
 * What no page can bring about on purpose, so that an application can try how it copes with it. Sources know these faults;
 * nothing that is built has them.
 *
 * - `outOfMemory`: the simulator's memory is full before its first particle.
 * - `contextLostInStart`: the graphics context goes before the first picture, and does not come back by itself.
 * - `workerSilent`: the worker ends without a word once it has its order.
 */
export type Fault = 'outOfMemory' | 'contextLostInStart' | 'workerSilent';

/** WASM on 32 bits has no more pages than this. */
const MAX_PAGES = 65_536;

/** Takes all the memory that a module may have, so that its next allocation fails. Browsers only note down what is empty. */
export function fill(memory: WebAssembly.Memory): void {
  const pages = memory.buffer.byteLength / 65_536;
  for (let step = MAX_PAGES - pages; step >= 1; step = Math.floor(step / 2)) growBy(memory, step);
}

export function loseContext({ renderer }: Device): void {
  renderer.getContext().getExtension('WEBGL_lose_context')?.loseContext();
}

/** As often as it goes: a browser refuses what is too much at once. */
function growBy(memory: WebAssembly.Memory, step: number): void {
  try {
    for (;;) memory.grow(step);
  } catch {
    // Less may still go.
  }
}
