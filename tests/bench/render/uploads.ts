/** memory.upload: bytes uploaded to GPU buffers in a frame, per drawn body and caster. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { PARTICLES, RenderBench } from './bench.ts';

const FRAMES = 5;

export async function measureUploads(): Promise<Figure[]> {
  await say('memory.upload');
  const bench = await RenderBench.create(0.1);
  // The first frame also creates the buffers once, for the full capacity.
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
  const note = 'bytes of all buffers and of textures with 16 bytes a texel in a frame, a body or caster';
  return [
    figure('memory.upload', 'B', rounds, `${note}; target <= 32`),
    figure('render.upload', 'B', rounds, `${note}; goal <= 24`),
  ];
}

/**
 * Counts the bytes of buffers and of textures with 16 bytes a texel that a context uploads from here on. Uniforms do not
 * count.
 */
export function watchUploads(gl: WebGL2RenderingContext): { bytes: number } {
  const watch = { bytes: 0 };
  const { bufferData, bufferSubData, texSubImage2D } = gl;
  gl.bufferData = (...parameters: unknown[]) => {
    watch.bytes += bytesOf(parameters[1], parameters[3], parameters[4]);
    Reflect.apply(bufferData, gl, parameters);
  };
  gl.bufferSubData = (...parameters: unknown[]) => {
    watch.bytes += bytesOf(parameters[2], parameters[3], parameters[4]);
    Reflect.apply(bufferSubData, gl, parameters);
  };
  gl.texSubImage2D = (...parameters: unknown[]) => {
    const [, , , , width, height, format, , source] = parameters;
    const isWide = source instanceof Float32Array || source instanceof Uint32Array;
    if (isWide && (format === gl.RGBA || format === gl.RGBA_INTEGER))
      watch.bytes += 16 * Number(width) * Number(height);
    Reflect.apply(texSubImage2D, gl, parameters);
  };
  return watch;
}

/** Bytes of a source as WebGL reads it: a size, a buffer, or `length` elements of a view from `offset` on. */
function bytesOf(source: unknown, offset: unknown, length: unknown): number {
  if (typeof source === 'number') return source;
  if (!ArrayBuffer.isView(source)) return source instanceof ArrayBuffer ? source.byteLength : 0;
  const element = 'BYTES_PER_ELEMENT' in source ? Number(source.BYTES_PER_ELEMENT) : 1;
  // For WebGL a length of 0 also means the rest of the view.
  return length ? Number(length) * element : source.byteLength - Number(offset ?? 0) * element;
}
