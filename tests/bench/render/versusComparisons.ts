/** render.vsSelle and render.vsShadowMap: the frame compared with the same smoke in the comparison renderers. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import type { Renderer, Style } from '../../../src/smoke/style.ts';
import { PLAIN_STYLE } from '../../visual/lab.ts';
import { PARTICLES, RenderBench } from './bench.ts';

const CONTESTANTS = { nailboards: '', selle: 'vsSelle', shadowMap: 'vsShadowMap' } as const;

interface Side {
  renderer: keyof typeof CONTESTANTS;
  style: Style;
  times: number[];
  drawn: string;
}

export async function measureAgainstComparisons(quick: boolean): Promise<Figure[]> {
  const bench = await RenderBench.create();
  const sides = (Object.keys(CONTESTANTS) as Side['renderer'][]).map((renderer) => look(bench, renderer));
  const rounds = quick ? 5 : 9;
  for (let round = 0; round < rounds; round++) {
    await say(`render.vsSelle and render.vsShadowMap, round ${round + 1} of ${rounds}`);
    for (const side of round % 2 === 0 ? sides : sides.toReversed()) {
      bench.style = side.style;
      side.times.push(bench.timeDrawing(() => bench.draw(true)));
    }
  }
  bench.dispose();
  const [ours, ...theirs] = sides;
  return theirs.map(({ renderer, times, drawn }) =>
    figure(
      `render.${CONTESTANTS[renderer]}`,
      'x',
      ours.times.map((time, round) => time / times[round]),
      `frame / frame of ${renderer}; ${ours.drawn}, there ${drawn}, of ${PARTICLES} particles`,
    ),
  );
}

/** Draws once, which also compiles the programs. */
function look(bench: RenderBench, renderer: Side['renderer'] & Renderer): Side {
  const style: Style = { ...PLAIN_STYLE, renderer };
  bench.style = style;
  const { bodiesDrawn, castersDrawn } = bench.draw(true);
  const colors = new Set(new Uint32Array(bench.picture().buffer)).size;
  demand(colors > 4 && bodiesDrawn > 0, `${renderer} draws ${bodiesDrawn} bodies in ${colors} colours`);
  return { renderer, style, times: [], drawn: `${bodiesDrawn} bodies and ${castersDrawn} casters` };
}
