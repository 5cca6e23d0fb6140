/** Stages and their contexts: shared, lost, disposed, and with growing WASM memory. */
import { createDevice } from '../../../src/renderer/gpu/device.ts';
import { differing, HEIGHT, lampPicture, lampStage, pixelsOf, shown, visibleCanvas, WIDTH } from './stage.cases.ts';

/** Two stages on one device, one with another light: differences between the two, and from a stage alone. */
export async function shareDevice(): Promise<{ between: number; firstAlone: number; secondAlone: number }> {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const [first, second] = [await lampStage(visibleCanvas(), device), await lampStage(visibleCanvas(), device)];
  second.set({ 'light.azimuth': -60 });
  const alone = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  for (const stage of [first, second, alone]) stage.step(120);
  const pictures = [await first.picture(), await second.picture(), await alone.picture()];
  alone.set({ 'light.azimuth': -60 });
  pictures.push(await alone.picture());
  for (const stage of [first, second, alone]) stage.dispose();
  device.dispose();
  const [a, b, c, d] = await Promise.all(pictures.map(pixelsOf));
  return { between: differing(a, b), firstAlone: differing(a, c), secondAlone: differing(b, d) };
}

/** Pixels that differ on the two canvases of stages that share a device. */
export async function sharedCanvases(): Promise<number> {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const canvases = [visibleCanvas(), visibleCanvas()];
  const stages = await Promise.all(canvases.map((canvas) => lampStage(canvas, device)));
  stages[0].step(60);
  stages[1].step(180);
  const [a, b] = canvases.map((canvas) => shown(canvas));
  for (const stage of stages) stage.dispose();
  device.dispose();
  return differing(a, b);
}

/** Creates and disposes stages one by one: the number of lost contexts, and the size of the WASM memory. */
export async function comeAndGo(rounds: number): Promise<{ lost: number; wasmBytes: number }> {
  const contexts: WebGL2RenderingContext[] = [];
  for (let round = 0; round < rounds; ++round) {
    const canvas = new OffscreenCanvas(64, 48);
    const stage = await lampStage(canvas);
    stage.step(2);
    contexts.push(canvas.getContext('webgl2')!);
    stage.dispose();
    stage.dispose();
    await new Promise((resolve) => setTimeout(resolve));
  }
  const lost = contexts.filter((context) => context.isContextLost()).length;
  return { lost, wasmBytes: (await wasmMemory()).buffer.byteLength };
}

/** The error for a canvas whose stage was disposed. */
export async function useCanvasAgain(): Promise<string> {
  const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
  (await lampStage(canvas)).dispose();
  return lampStage(canvas).then(() => 'nothing', String);
}

/** Loses and restores the context in mid-run: pixels that differ from a run without the loss, and the hash. */
export async function loseContext(): Promise<{ changed: number; sameHash: boolean; rejected: boolean }> {
  const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
  const stage = await lampStage(canvas);
  stage.step(60);
  const extension = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
  const happens = (event: string) => new Promise((resolve) => canvas.addEventListener(event, resolve, { once: true }));
  const lost = happens('webglcontextlost');
  extension.loseContext();
  await lost;
  // The browser decides about restoring only after the event's last listener.
  await new Promise((resolve) => setTimeout(resolve));
  stage.step(30);
  const rejected = await stage.picture().then(
    () => false,
    (error: Error) => error.name === 'ContextError',
  );
  const restored = happens('webglcontextrestored');
  extension.restoreContext();
  await restored;
  stage.step(30);
  const twin = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  twin.step(120);
  const [a, b] = await Promise.all([stage, twin].map(async (each) => pixelsOf(await each.picture())));
  const sameHash = stage.hash() === twin.hash();
  for (const each of [stage, twin]) each.dispose();
  return { changed: differing(a, b), sameHash, rejected };
}

/** Steps before and after the WASM memory grows: changed pixels, and whether the buffer is a new one. */
export async function growMemory(): Promise<{ changed: number; grown: boolean; painted: number }> {
  const stage = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  const twin = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  const memory = await wasmMemory();
  for (const each of [stage, twin]) each.step(90);
  const before = memory.buffer;
  memory.grow(16);
  for (const each of [stage, twin]) each.step(30);
  const [a, b] = await Promise.all([stage, twin].map(async (each) => pixelsOf(await each.picture())));
  const reference = await pixelsOf(await lampPicture(2));
  for (const each of [stage, twin]) each.dispose();
  return {
    changed: differing(a, reference) + differing(b, reference),
    grown: memory.buffer !== before,
    painted: new Set(a).size,
  };
}

async function wasmMemory(): Promise<WebAssembly.Memory> {
  const { loadSimulators } = await import('../../../src/simulator/load.ts');
  return (await loadSimulators({ physics: true })).module.memory;
}
