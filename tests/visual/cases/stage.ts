/** Stages as a page makes them: their pictures, their clocks and their ends. */
import { createDevice, type Device } from '../../../src/device/device.ts';
import type { Values } from '../../../src/preset/parameter.ts';
import { defaultPreset, findPreset, presetValues } from '../../../src/preset/presets.ts';
import type { Simulator } from '../../../src/sim/simulator.ts';
import { EVERYTHING } from '../../support/everything.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';

const [WIDTH, HEIGHT] = [320, 240];

/** Few enough particles for a software renderer. */
const SMALL: Values = { ...presetValues(defaultPreset), 'simulation.maxParticles': 800 };

export async function lampStage(canvas: OffscreenCanvas | HTMLCanvasElement, device?: Device): Promise<Stage> {
  return createStage(canvas, { values: SMALL, width: WIDTH, height: HEIGHT, pixelRatio: 1, device });
}

/** The picture of the lamp at a simulated time. */
export async function lampPicture(seconds: number): Promise<Blob> {
  const stage = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  await stage.seek(seconds);
  const picture = await stage.picture();
  stage.dispose();
  return picture;
}

/** Metres of the open air to a CSS pixel, on screens of different sharpness, before and after another scene. */
export async function airPerPixel(): Promise<number[]> {
  const values = { ...presetValues(findPreset('air')!), 'simulation.maxParticles': 100 };
  const metres: number[] = [];
  for (const pixelRatio of [0.5, 1, 2]) {
    const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), {
      values,
      width: WIDTH,
      height: HEIGHT,
      pixelRatio,
    });
    metres.push(stage.sight.plane.up[1]);
    await stage.enter({ ...values, scene: 'wisp' });
    await stage.enter(values);
    metres.push(stage.sight.plane.up[1]);
    stage.dispose();
  }
  return metres;
}

/** Colours in a picture, and the pixels of its commonest one: a blank picture has a single colour. */
export async function census(picture: Blob): Promise<{ colors: number; commonest: number; pixels: number }> {
  const data = await pixelsOf(picture);
  const counts = new Map<number, number>();
  for (const pixel of data) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
  return { colors: counts.size, commonest: Math.max(...counts.values()), pixels: data.length };
}

/** Two stages on one device, one with its own light: are they different from each other, and as they are alone? */
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

/** The pictures on the two canvases of stages that share a device, as the page shows them. */
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

/** Makes and ends stages one after the other; how many of their contexts are gone, and the size of the WASM memory. */
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

/** Steps on each side of a growth of the WASM memory: pixels that changed, and whether the buffer is another one. */
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

/** Takes the context away and gives it back in mid-run: pixels that differ from a run without the loss, and the hash. */
export async function loseContext(): Promise<{ changed: number; sameHash: boolean; refused: boolean }> {
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
  const refused = await stage.picture().then(
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
  return { changed: differing(a, b), sameHash, refused };
}

/** The centre of the smoke's rows on successive frames of a 60 Hz clock at a speed: mean movement in steps' movements. */
export async function movementAtSpeed(speed: number): Promise<number> {
  const { Clock } = await import('../../../src/sim/clock.ts');
  const { loadSimulators } = await import('../../../src/sim/load.ts');
  const simulator = (await loadSimulators({ physics: false })).create({ capacity: 64, seed: 3 });
  simulator.set({ 'emission.rate': 600, 'emission.lifetime': 50, 'emitters.0.share': 1, 'emitters.0.size': 0.1 });
  simulator.step(6);
  simulator.set({ 'emission.rate': 0, 'forces.wind.x': 2, 'emitters.0.speed': 0 });
  simulator.step(2);
  const clock = new Clock();
  clock.speed = speed;
  const centres: number[] = [];
  for (let frame = 0; frame < 40; ++frame) {
    const steps = clock.tick((frame * 1000) / 60);
    if (steps > 0) simulator.step(steps);
    centres.push(centreX(simulator, clock.blend));
  }
  simulator.dispose();
  const moves = centres.slice(1).map((centre, index) => centre - centres[index]);
  const wholeStep = 2 / 60;
  return Math.max(...moves.map((move) => Math.abs(move / wholeStep - speed)));
}

function centreX(simulator: Simulator, blend: number): number {
  const { count, place } = simulator.arrange({ ...EVERYTHING, blend });
  let sum = 0;
  for (let row = 0; row < count; ++row) sum += place[4 * row];
  return sum / count;
}

/**
 * A stage that draws half of the pixels beside one of half the size with all of them: pixels of the first that differ
 * though all neighbours of the same place are alike in the second, and how many there are, ink apart. Also whether its
 * picture() has all pixels, and what its canvas measures.
 */
export async function halfQuality(device?: Device): Promise<{
  flat: number;
  ink: number;
  differing: number;
  pictureChanged: number;
  canvas: number[];
}> {
  const canvas = visibleCanvas();
  const values = { ...SMALL, 'style.outlineWidth': 6, 'style.inkColor': '#123456' };
  const size = { values, width: WIDTH / 2, height: HEIGHT / 2 };
  const half = await createStage(canvas, { ...size, pixelRatio: 2, quality: 0.5, device });
  const small = await createStage(visibleCanvas(), { ...size, pixelRatio: 1 });
  const whole = await createStage(visibleCanvas(), { ...size, pixelRatio: 2 });
  for (const stage of [half, small, whole]) stage.step(150);
  const [large, reference] = [shown(canvas), shown(small.canvas as HTMLCanvasElement, WIDTH / 2, HEIGHT / 2)];
  const report = { flat: 0, ink: 0, differing: 0 };
  for (let y = 1; y < HEIGHT / 2 - 1; ++y) {
    for (let x = 1; x < WIDTH / 2 - 1; ++x) {
      const color = reference[(y * WIDTH) / 2 + x];
      const around = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => reference[((y + dy) * WIDTH) / 2 + x + dx]));
      if (around.some((other) => other !== color)) continue;
      const block = [0, 1, WIDTH, WIDTH + 1].map((offset) => large[2 * y * WIDTH + 2 * x + offset]);
      report.flat += 1;
      report.ink += color === 0xff563412 ? 1 : 0;
      report.differing += block.some((other) => other !== color) ? 1 : 0;
    }
  }
  const [a, b] = await Promise.all([half, whole].map(async (stage) => pixelsOf(await stage.picture())));
  for (const stage of [half, small, whole]) stage.dispose();
  return { ...report, pictureChanged: differing(a, b), canvas: [canvas.width, canvas.height] };
}

/** The same on a device that stages share. */
export async function halfQualityShared(): ReturnType<typeof halfQuality> {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const report = await halfQuality(device);
  device.dispose();
  return report;
}

/** Scales that a playing stage draws with when each frame takes longer than it should, and after a pause. */
export async function governedScales(quality: 'auto' | undefined): Promise<{ played: number[]; paused: number }> {
  let frame: FrameRequestCallback = () => {};
  const { requestAnimationFrame } = globalThis;
  globalThis.requestAnimationFrame = (callback) => {
    frame = callback;
    return 1;
  };
  const canvas = new OffscreenCanvas(64, 48);
  const stage = await createStage(canvas, { values: SMALL, width: 64, height: 48, pixelRatio: 1, quality });
  const played: number[] = [];
  stage.play();
  for (let now = 0, count = 0; count < 60; ++count) {
    frame((now += 50 * stage.stats.scale ** 2));
    if (played.at(-1) !== stage.stats.scale) played.push(stage.stats.scale);
  }
  stage.pause();
  const paused = stage.stats.scale;
  stage.dispose();
  globalThis.requestAnimationFrame = requestAnimationFrame;
  return { played, paused };
}

/**
 * Pixels by which a picture changes at once when another renderer is asked for whose code is not here, when it has come, and
 * by which it differs then from that of a stage that began with it.
 */
export async function lateRenderer(): Promise<{ atOnce: number; later: number; fromStart: number }> {
  const canvas = visibleCanvas();
  const stage = await lampStage(canvas);
  stage.step(90);
  const before = shown(canvas);
  stage.set({ 'style.renderer': 'selle' });
  const atOnce = differing(before, shown(canvas));
  await stage.complete();
  const after = shown(canvas);
  const values = { ...SMALL, 'style.renderer': 'selle' };
  const other = await createStage(visibleCanvas(), { values, width: WIDTH, height: HEIGHT, pixelRatio: 1 });
  other.step(90);
  const fromStart = differing(after, shown(other.canvas as HTMLCanvasElement));
  for (const each of [stage, other]) each.dispose();
  return { atOnce, later: differing(before, after), fromStart };
}

/** What a stage says of a renderer and of a view whose code cannot be fetched, and whether it goes on. */
export async function lostRenderer(): Promise<{ told: string[]; thrown: string; steps: number; drawn: number }> {
  const stage = await lampStage(visibleCanvas());
  const told: string[] = [];
  stage.on('error', (error) => told.push(`${error.name}: ${error.message}`));
  stage.set({ 'style.renderer': 'selle' });
  const thrown = await stage.picture().then(
    () => 'nothing',
    (error: Error) => error.name,
  );
  await stage.seek(1);
  const { steps, bodiesDrawn } = stage.stats;
  stage.dispose();
  return { told, thrown, steps, drawn: bodiesDrawn };
}

/** Pictures that a stage has drawn: made where nobody sees it, seen, given the same size again, given another. */
export async function picturesDrawn(): Promise<number[]> {
  const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
  const size = { width: WIDTH, height: HEIGHT, pixelRatio: 1 };
  const stage = await createStage(canvas, { ...size, values: SMALL, visible: false });
  let drawn = stage.stats.renderMs > 0 ? 1 : 0;
  stage.on('frame', () => (drawn += 1));
  const counts = [drawn];
  const act = (action: () => void) => {
    action();
    counts.push(drawn);
  };
  act(() => (stage.visible = true));
  act(() => stage.resize(WIDTH, HEIGHT, 1));
  act(() => stage.resize(WIDTH / 2, HEIGHT, 1));
  stage.dispose();
  return counts;
}

function visibleCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  document.body.append(canvas);
  return canvas;
}

function shown(canvas: HTMLCanvasElement, width = WIDTH, height = HEIGHT): Uint32Array {
  const copy = new OffscreenCanvas(width, height).getContext('2d')!;
  copy.drawImage(canvas, 0, 0);
  return new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer);
}

async function pixelsOf(picture: Blob): Promise<Uint32Array> {
  const bitmap = await createImageBitmap(picture);
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
}

function differing(a: Uint32Array, b: Uint32Array): number {
  return a.reduce((count, pixel, index) => count + (pixel === b[index] ? 0 : 1), 0);
}

async function wasmMemory(): Promise<WebAssembly.Memory> {
  const { loadSimulators } = await import('../../../src/sim/load.ts');
  return (await loadSimulators({ physics: true })).module.memory;
}

/** Lives a take on one stage and does it again on another: hashes, values and pictures of both. */
export async function replayTake(): Promise<Record<'hashes' | 'rates' | 'inputs', unknown[]> & { changed: number }> {
  const [first, second] = await Promise.all([1, 2].map(() => lampStage(new OffscreenCanvas(WIDTH, HEIGHT))));
  first.set({ 'style.tones': 3 });
  first.restart();
  first.step(50);
  first.set({ 'emission.rate': 60, 'light.azimuth': 20 });
  first.nudge({ dx: -0.9, dy: -0.2 });
  first.step(30);
  first.blow({ x: WIDTH / 2, y: HEIGHT / 3, dx: 6, dy: -2 });
  first.steer(2, 0.25);
  first.step(40);
  const hashes = [first.hash()];
  second.set({ 'emission.rate': 90, seed: 5 });
  second.step(33);
  second.playTake(first.take().toBytes());
  const rates = [SMALL['emission.rate'], second.get()['emission.rate']];
  for (const seconds of [2, 0.5, 2]) await second.seek(seconds);
  hashes.push(second.hash());
  rates.push(second.get()['emission.rate']);
  // The light was turned after the start and is no part of the simulation: it is the receiver's own.
  second.set({ 'light.azimuth': 20 });
  const inputs = [first.stats.inputs, second.take().inputs];
  const [a, b] = await Promise.all([first, second].map(async (stage) => pixelsOf(await stage.picture())));
  for (const stage of [first, second]) stage.dispose();
  return { hashes, rates, inputs, changed: differing(a, b) };
}

/** Going back in time: hashes on the way there and on the way again, and the memory that it takes. */
export async function seekBack(): Promise<{ straight: string[]; again: string[]; bytes: number; rates: unknown[] }> {
  const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), {
    values: SMALL,
    width: WIDTH,
    height: HEIGHT,
    historyBytes: 1_000_000,
  });
  const straight: string[] = [];
  for (let second = 1; second <= 4; ++second) {
    stage.step(60);
    straight.push(stage.hash());
    stage.set({ 'emission.rate': 40 * second });
    stage.nudge({ dx: -0.3 });
  }
  const again: string[] = [];
  const rates: unknown[] = [];
  for (const second of [3, 1, 4, 2]) {
    await stage.seek(second);
    again[second - 1] = stage.hash();
    rates[second - 1] = stage.get()['emission.rate'];
  }
  const bytes = stage.stats.historyBytes;
  stage.dispose();
  return { straight, again, bytes, rates };
}

/** A ball that a pointer drags while smoke rises, and the same again as a take: hashes, and what it is without the drag. */
export async function replayDrag(): Promise<Record<'lived' | 'again' | 'still', string> & { held: unknown[] }> {
  const [first, second, still] = await Promise.all([1, 2, 3].map(() => lampStage(new OffscreenCanvas(WIDTH, HEIGHT))));
  const [x, y] = ballOn(first);
  first.step(60);
  const held = [first.pointer({ type: 'down', id: 1, x, y })];
  for (let move = 1; move <= 12; ++move) {
    held.push(first.pointer({ type: 'move', id: 1, x: x - 9 * move, y: y - 3 * move }));
    first.step(2);
  }
  held.push(first.pointer({ type: 'up', id: 1, x, y }));
  first.step(60);
  second.playTake(first.take().toBytes());
  second.step(144);
  still.step(144);
  const hashes = { lived: first.hash(), again: second.hash(), still: still.hash() };
  for (const stage of [first, second, still]) stage.dispose();
  return { ...hashes, held };
}

/** Where the first pixel is, from the top left, by which the ball can be grabbed. */
function ballOn(stage: Stage): [x: number, y: number] {
  for (let y = 0; y < HEIGHT; y += 2) {
    for (let x = 0; x < WIDTH; x += 2) {
      const hit = stage.pointer({ type: 'down', id: 9, x, y });
      stage.pointer({ type: 'cancel', id: 9, x, y });
      if (hit) return [x, y];
    }
  }
  throw new Error('there is no ball in the picture');
}
