/** memory.upload: bytes that reach the GPU's buffers in a frame, for each body and caster drawn. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { PARTICLES, RenderBench } from './bench.ts';

const FRAMES = 5;

export async function measureUploads(): Promise<Figure[]> {
  await say('memory.upload');
  const bench = await RenderBench.create(0.1);
  // The first frame also makes the buffers, once, with room for all.
  bench.draw(true);
  const watch = watchUploads(bench.context);
  const rounds: number[] = [];
  for (let frame = 0; frame < FRAMES; frame++) {
    bench.simulator.step();
    watch.bytes = 0;
    const { bodiesDrawn, castersDrawn } = bench.draw(true);
    demand(bodiesDrawn + castersDrawn > PARTICLES / 10, `${bodiesDrawn} bodies and ${castersDrawn} casters were drawn`);
    demand(watch.bytes > 0, 'nothing was uploaded, though the smoke moved');
    rounds.push(watch.bytes / (bodiesDrawn + castersDrawn));
  }
  bench.dispose();
  const note = 'bytes of all bufferData and bufferSubData in a frame, a body or caster';
  return [
    figure('memory.upload', 'B', rounds, `${note}; target <= 32`),
    figure('render.upload', 'B', rounds, `${note}; goal <= 24`),
  ];
}

/** Adds up what a context is given for its buffers from here on; uniforms and textures are no buffers. */
export function watchUploads(gl: WebGL2RenderingContext): { bytes: number } {
  const watch = { bytes: 0 };
  const { bufferData, bufferSubData } = gl;
  gl.bufferData = (...parameters: unknown[]) => {
    watch.bytes += bytesOf(parameters[1], parameters[3], parameters[4]);
    Reflect.apply(bufferData, gl, parameters);
  };
  gl.bufferSubData = (...parameters: unknown[]) => {
    watch.bytes += bytesOf(parameters[2], parameters[3], parameters[4]);
    Reflect.apply(bufferSubData, gl, parameters);
  };
  return watch;
}

/** Bytes of a source as WebGL reads it: a size, a buffer, or a view of which `length` elements from `offset` on count. */
function bytesOf(source: unknown, offset: unknown, length: unknown): number {
  if (typeof source === 'number') return source;
  if (!ArrayBuffer.isView(source)) return source instanceof ArrayBuffer ? source.byteLength : 0;
  const element = 'BYTES_PER_ELEMENT' in source ? Number(source.BYTES_PER_ELEMENT) : 1;
  // WebGL takes 0 for the length, too, as everything that is left.
  return length ? Number(length) * element : source.byteLength - Number(offset ?? 0) * element;
}
