/** gpu.*: time of each pass and of the looks of presets on the GPU, from EXT_disjoint_timer_query_webgl2. */
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
  const renderer = rendererOf(new OffscreenCanvas(1, 1).getContext('webgl2')!);
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

/** Times a part of the work of {@link timeQueries}. Parts do not overlap. */
type Query = <Result>(draw: () => Result) => Result;

/** Milliseconds of each query of the work. Repeats the work when the GPU changed its clock. */
async function timeQueries(gl: WebGL2RenderingContext, work: (query: Query) => void): Promise<number[]> {
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
  if (!timer) throw new Error('This browser has no EXT_disjoint_timer_query_webgl2, so the GPU cannot be timed.');
  for (let tries = 0; tries < 4; tries++) {
    const queries: WebGLQuery[] = [];
    work((draw) => {
      const query = gl.createQuery();
      queries.push(query);
      gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
      const result = draw();
      gl.endQuery(timer.TIME_ELAPSED_EXT);
      return result;
    });
    gl.flush();
    const nanoseconds = await Promise.all(queries.map((query) => resultOf(gl, query)));
    for (const query of queries) gl.deleteQuery(query);
    if (!gl.getParameter(timer.GPU_DISJOINT_EXT)) return nanoseconds.map((each) => each / 1e6);
  }
  throw new Error('The GPU changed its clock in each measurement.');
}

/** Nanoseconds. Results are available after the task that asked for them. */
async function resultOf(gl: WebGL2RenderingContext, query: WebGLQuery): Promise<number> {
  while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE))
    await new Promise((resolve) => setTimeout(resolve, 1));
  return gl.getQueryParameter(query, gl.QUERY_RESULT) as number;
}

interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

function rendererOf(gl: WebGL2RenderingContext): string {
  const debug = gl.getExtension('WEBGL_debug_renderer_info');
  return gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER) as string;
}
