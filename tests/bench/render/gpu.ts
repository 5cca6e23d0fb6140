/** gpu.*: time of each pass on the GPU, from EXT_disjoint_timer_query_webgl2. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { RenderBench, WIDTH } from './bench.ts';

/** Widths of the picture with the aspect ratio of the suite. */
const WIDTHS = [1920, 3840];
const PARTICLES = [1_000, 3_000, 10_000, 30_000, 100_000];
/** What a software renderer draws in a few seconds. */
const SMALL = { widths: [640], particles: [1_000] };

/** The passes of a frame, and the method of each that draws. */
const PASSES = {
  backdrop: 'draw',
  surfaces: 'draw',
  creases: 'draw',
  surfaceDepth: 'take',
  body: 'draw',
  meshVolumes: 'draw',
  volumes: 'draw',
  mask: 'draw',
  resolve: 'draw',
} as const;

type PassName = keyof typeof PASSES;
/** Milliseconds of each pass in each round. */
export type PassTimes = Record<PassName, number[]>;

export async function measure(quick: boolean): Promise<Figure[]> {
  const figures: Figure[] = [];
  const renderer = rendererOf(new OffscreenCanvas(1, 1).getContext('webgl2')!);
  const { widths, particles } = /SwiftShader|llvmpipe/.test(renderer)
    ? SMALL
    : { widths: WIDTHS, particles: PARTICLES };
  for (const width of widths) {
    for (const count of particles) {
      const bench = await RenderBench.create(width / WIDTH, count);
      const size = `${width}x${(width / WIDTH) * 360}`;
      await say(`gpu, ${size}, ${count} particles`);
      const times = await timePasses(bench, quick ? 5 : 15);
      const note = `${count} particles at ${size}; ${renderer}`;
      const rounds = times.body.map((_, round) => Object.values(times).reduce((sum, each) => sum + each[round], 0));
      for (const [pass, each] of Object.entries(times))
        figures.push(figure(`gpu.${size}.${count}.${pass}`, 'ms', each, note));
      figures.push(figure(`gpu.${size}.${count}.frame`, 'ms', rounds, `all passes, ${note}`));
      bench.dispose();
    }
  }
  return figures;
}

/** Times every pass of the same frame. Rounds in which the GPU changed its clock are repeated. */
export async function timePasses(bench: RenderBench, rounds: number): Promise<PassTimes> {
  const gl = bench.context;
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
  if (!timer) throw new Error('This browser has no EXT_disjoint_timer_query_webgl2, so passes cannot be timed.');
  const times = Object.fromEntries(Object.keys(PASSES).map((name) => [name, [] as number[]])) as PassTimes;
  // Compiles the programs.
  bench.draw(true);
  for (let tries = 0; times.body.length < rounds; tries++) {
    demand(tries < 4 * rounds, 'the GPU changed its clock in most rounds');
    const queries = drawTimed(bench, timer);
    const nanoseconds = await Promise.all([...queries.values()].map((query) => resultOf(gl, query)));
    const isDisjoint = gl.getParameter(timer.GPU_DISJOINT_EXT) as boolean;
    for (const query of queries.values()) gl.deleteQuery(query);
    if (isDisjoint) continue;
    [...queries.keys()].forEach((name, index) => times[name].push(nanoseconds[index] / 1e6));
  }
  return times;
}

/** Draws a frame with a query around each pass. */
function drawTimed(bench: RenderBench, { TIME_ELAPSED_EXT }: TimerExtension): Map<PassName, WebGLQuery> {
  const gl = bench.context;
  const queries = new Map<PassName, WebGLQuery>();
  const passes = bench.smoke.passes as unknown as Record<PassName, Record<string, (...all: unknown[]) => unknown>>;
  for (const [name, method] of Object.entries(PASSES) as [PassName, string][]) {
    const pass = passes[name];
    const draw = pass[method].bind(pass);
    pass[method] = (...all) => {
      const query = gl.createQuery();
      gl.beginQuery(TIME_ELAPSED_EXT, query);
      const result = draw(...all);
      gl.endQuery(TIME_ELAPSED_EXT);
      queries.set(name, query);
      return result;
    };
  }
  bench.draw(true);
  // The instance properties hid the methods of the passes' classes.
  for (const [name, method] of Object.entries(PASSES) as [PassName, string][])
    Reflect.deleteProperty(passes[name], method);
  gl.flush();
  return queries;
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
