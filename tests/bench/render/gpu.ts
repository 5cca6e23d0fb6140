/** gpu.*: time of each pass and of the looks of presets on the GPU, from EXT_disjoint_timer_query_webgl2. */
import { rendererName, timeQueries } from '../../../src/demo/costs/gpuClock.ts';
import type { SmokePasses } from '../../../src/renderer/smokePasses.ts';
import { figure, say, type Figure } from '../support/figures.ts';
import { RenderBench, WIDTH } from './bench.ts';
import { measureLook, PRESETS } from './looks.ts';

/** Widths of the picture with the aspect ratio of the suite. */
const WIDTHS = [1920, 3840];
const PARTICLES = [1_000, 3_000, 10_000, 30_000, 100_000];
/** What a software renderer draws in a few seconds. */
const SMALL = { widths: [640], particles: [1_000], presets: ['wisp'] };

/** Milliseconds of each pass that a frame draws, in each round. */
type PassTimes = Map<string, number[]>;

export async function measure(quick: boolean): Promise<Figure[]> {
  const figures: Figure[] = [];
  const rounds = quick ? 5 : 15;
  const renderer = rendererName(new OffscreenCanvas(1, 1).getContext('webgl2')!);
  const { widths, particles, presets } = /SwiftShader|llvmpipe/.test(renderer)
    ? SMALL
    : { widths: WIDTHS, particles: PARTICLES, presets: PRESETS };
  for (const width of widths) {
    const height = (width / WIDTH) * 360;
    const size = `${width}x${height}`;
    for (const count of particles) {
      const bench = await RenderBench.create(width / WIDTH, count);
      const { context } = bench;
      await say(`gpu, ${size}, ${count} particles`);
      const draw = () => bench.draw(true);
      const note = `${count} particles at ${size}; ${renderer}`;
      for (const [pass, each] of await timePasses(context, bench.smoke.passes, draw, rounds))
        figures.push(figure(`gpu.${size}.${count}.${pass}`, 'ms', each, note));
      const frames: number[] = [];
      while (frames.length < rounds) frames.push(await timeOnGpu(context, draw));
      figures.push(figure(`gpu.${size}.${count}.frame`, 'ms', frames, `the whole frame, ${note}`));
      bench.dispose();
    }
    for (const preset of presets) {
      const picture = { name: `gpu.${size}.${preset}`, preset, width, height, renderer };
      figures.push(...(await measureLook(picture, rounds, timeOnGpu)));
    }
  }
  return figures;
}

/** Milliseconds of the commands of `draw`. Repeats it when the GPU changed its clock. */
async function timeOnGpu(gl: WebGL2RenderingContext, draw: () => void): Promise<number> {
  const [milliseconds] = await timeQueries(gl, (query) => query(draw));
  return milliseconds;
}

/** Times each pass of a frame. */
async function timePasses(gl: WebGL2RenderingContext, passes: SmokePasses, draw: () => void, rounds: number) {
  const times: PassTimes = new Map();
  // Compiles the programs.
  draw();
  const watched = watchedPasses(passes);
  for (let round = 0; round < rounds; round++) {
    let names: string[] = [];
    const milliseconds = await timeQueries(gl, (query) => {
      names = [];
      for (const [name, { pass, method }] of Object.entries(watched)) {
        const timed = pass[method].bind(pass);
        pass[method] = (...all) => {
          names.push(name);
          return query(() => timed(...all));
        };
      }
      draw();
      // The instance properties hid the methods of the passes' classes.
      for (const { pass, method } of Object.values(watched)) Reflect.deleteProperty(pass, method);
    });
    names.forEach((name, at) => times.set(name, [...(times.get(name) ?? []), milliseconds[at]]));
  }
  return times;
}

interface WatchedPass {
  readonly pass: Record<string, (...all: unknown[]) => unknown>;
  readonly method: string;
}

/** The passes of a frame, and the method of each that draws. `resolve` contains simplified light. */
function watchedPasses({ backdrop, scene, surfaceDepth, body, volumes, mask, resolve }: SmokePasses) {
  const watch = <Pass extends object>(pass: Pass, method: keyof Pass & string): WatchedPass => ({
    pass: pass as WatchedPass['pass'],
    method,
  });
  return {
    backdrop: watch(backdrop, 'draw'),
    surfaces: watch(scene!.surfaces, 'draw'),
    creases: watch(scene!.creases, 'draw'),
    surfaceDepth: watch(surfaceDepth, 'copy'),
    body: watch(body, 'draw'),
    meshVolumes: watch(scene!.volumes, 'draw'),
    volumes: watch(volumes, 'draw'),
    mask: watch(mask, 'draw'),
    resolve: watch(resolve, 'draw'),
  };
}
