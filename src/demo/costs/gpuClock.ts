/** Times of the GPU, from EXT_disjoint_timer_query_webgl2. */

interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

const TRIES = 4;

/** Times a part of the work of {@link timeQueries}. Parts do not overlap. */
export type Query = <Result>(draw: () => Result) => Result;

/**
 * Milliseconds of each query of the work. Repeats the work when the GPU changed its clock.
 * @throws Error without the extension, and when the GPU changed its clock each time
 */
export async function timeQueries(gl: WebGL2RenderingContext, work: (query: Query) => void): Promise<number[]> {
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
  if (!timer) throw new Error('This browser has no EXT_disjoint_timer_query_webgl2, so the GPU cannot be timed.');
  for (let tries = 0; tries < TRIES; tries++) {
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
  while (!gl.isContextLost() && !gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE))
    await new Promise((resolve) => setTimeout(resolve, 1));
  return gl.getQueryParameter(query, gl.QUERY_RESULT) as number;
}

/** The name of the GPU, as far as the browser tells it. */
export function rendererName(gl: WebGL2RenderingContext): string {
  const debug = gl.getExtension('WEBGL_debug_renderer_info');
  return gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER) as string;
}
