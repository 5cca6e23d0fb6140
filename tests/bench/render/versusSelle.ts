/** render.vsSelle: the frame compared with the same smoke in the renderer `selle`. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import type { Renderer, Style } from '../../../src/renderer/style.ts';
import { PLAIN_STYLE } from '../../visual/lab.ts';
import { PARTICLES, RenderBench } from './bench.ts';

interface Side {
  style: Style;
  times: number[];
  drawn: string;
}

export async function measureAgainstSelle(quick: boolean): Promise<Figure[]> {
  const bench = await RenderBench.create();
  const ours = look(bench, 'nailboards');
  const theirs = look(bench, 'selle');
  const rounds = quick ? 5 : 9;
  for (let round = 0; round < rounds; round++) {
    await say(`render.vsSelle, round ${round + 1} of ${rounds}`);
    for (const side of round % 2 === 0 ? [ours, theirs] : [theirs, ours]) {
      bench.style = side.style;
      side.times.push(bench.timeDrawing(() => bench.draw(true)));
    }
  }
  bench.dispose();
  return [
    figure(
      'render.vsSelle',
      'x',
      ours.times.map((time, round) => time / theirs.times[round]),
      `frame / frame of selle; ${ours.drawn}, there ${theirs.drawn}, of ${PARTICLES} particles`,
    ),
  ];
}

/** Draws once, which also compiles the programs. */
function look(bench: RenderBench, renderer: Renderer): Side {
  const style: Style = { ...PLAIN_STYLE, renderer };
  bench.style = style;
  const { bodiesDrawn, castersDrawn } = bench.draw(true);
  const colors = new Set(new Uint32Array(bench.picture().buffer)).size;
  demand(colors > 4 && bodiesDrawn > 0, `${renderer} draws ${bodiesDrawn} bodies in ${colors} colours`);
  return { style, times: [], drawn: `${bodiesDrawn} bodies and ${castersDrawn} casters` };
}
