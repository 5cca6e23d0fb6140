/**
 * memory.targets: bytes of the render targets of a phone's picture, counted as they are allocated. memory.bandwidth: bytes
 * that the passes over the whole picture read and write, counted from formats and sizes.
 */
import { SceneLab } from '../../visual/sceneLab.ts';
import { demand, figure, say, type Figure } from '../support/figures.ts';

const [WIDTH, HEIGHT] = [1170, 2532];
/** Bytes of a colour, and of depth with stencil. */
const [COLOR, DEPTH] = [4, 4];
/** Texels that the search for edges reads for each pixel: tiles of 8 x 8 with a border of one. */
const TILE_READS = 100 / 64;

/** Bytes that a pass over the whole picture reads and writes for each pixel. */
const PASSES: readonly { name: string; reads: number; writes: number }[] = [
  { name: 'clear', reads: 0, writes: 2 * COLOR + DEPTH },
  { name: 'backdrop', reads: 0, writes: 2 * COLOR },
  { name: 'copy of the depth of surfaces', reads: DEPTH, writes: DEPTH },
  { name: 'copy of the depth of receivers', reads: DEPTH, writes: DEPTH },
  { name: 'mask', reads: DEPTH + COLOR, writes: COLOR },
  { name: 'tones', reads: 2 * COLOR, writes: COLOR },
  { name: 'tiles with an edge', reads: TILE_READS * COLOR, writes: 0 },
  { name: 'copy of flat pixels', reads: COLOR, writes: COLOR },
];

export async function measureTargets(): Promise<Figure[]> {
  await say('memory.targets');
  const lab = await SceneLab.create('wisp', { width: WIDTH, height: HEIGHT, smoothEdges: true });
  const watch = watchTextures(lab.context);
  lab.step(1);
  lab.draw();
  lab.dispose();
  demand(watch.bytes >= 16 * WIDTH * HEIGHT, `only ${watch.bytes} bytes of targets were allocated`);
  const perPixel = PASSES.reduce((sum, { reads, writes }) => sum + reads + writes, 0);
  const megabytes = 1 / 2 ** 20;
  const note = `${WIDTH} x ${HEIGHT}`;
  return [
    figure('memory.targets', 'MiB', [watch.bytes * megabytes], `textures of the size of the picture, ${note}`),
    figure(
      'memory.bandwidth',
      'MiB',
      [perPixel * WIDTH * HEIGHT * megabytes],
      `read and written by passes over the whole picture, ${note}; puffs, surfaces and edges come on top`,
    ),
  ];
}

/** Adds up the textures of the size of the picture that a context allocates. */
function watchTextures(gl: WebGL2RenderingContext): { bytes: number } {
  const watch = { bytes: 0 };
  const bytesOf = new Map<number, number>([
    [gl.RGBA8, 4],
    [gl.DEPTH24_STENCIL8, 4],
    [gl.R8, 1],
  ]);
  for (const name of ['texStorage2D', 'texImage2D'] as const) {
    const allocate = gl[name].bind(gl) as (...parameters: unknown[]) => void;
    const watched = (...parameters: unknown[]) => {
      const [, , format, width, height] = parameters as number[];
      if (width === WIDTH && height === HEIGHT) {
        const bytes = bytesOf.get(format);
        demand(bytes !== undefined, `the size of format ${format} is unknown`);
        watch.bytes += bytes * width * height;
      }
      allocate(...parameters);
    };
    Object.assign(gl, { [name]: watched });
  }
  return watch;
}
