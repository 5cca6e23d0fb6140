/** render.lobes: cost of bodies as lobes and as baked billboards, with the same rows, in turns. */
import type { PuffForm } from '../../../src/device/puffTextures.ts';
import type { Style } from '../../../src/smoke/style.ts';
import { PLAIN_STYLE } from '../../visual/lab.ts';
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { RenderBench } from './bench.ts';
import type { Fragments } from './fragments.ts';

/** Results of one form. */
interface Side {
  form: PuffForm;
  style: Style;
  times: number[];
  bodiesDrawn: number;
  fragments: Fragments;
}

export async function measureForms(quick: boolean): Promise<Figure[]> {
  const bench = await RenderBench.create();
  const [lobes, billboards] = [look(bench, 'lobes'), look(bench, 'billboards')];
  // Unculled, because the forms hide different numbers of bodies.
  const same = lobes.bodiesDrawn === billboards.bodiesDrawn;
  demand(same, `${lobes.bodiesDrawn} bodies of lobes and ${billboards.bodiesDrawn} billboards`);
  const rounds = quick ? 5 : 11;
  for (let round = 0; round < rounds; round++) {
    await say(`render.lobes, round ${round + 1} of ${rounds}`);
    for (const side of round % 2 === 0 ? [lobes, billboards] : [billboards, lobes]) {
      bench.style = side.style;
      side.times.push(bench.timeFrame(false).bodies);
    }
  }
  bench.dispose();
  return [
    ...[lobes, billboards].map(({ form, times, bodiesDrawn, fragments: { kept, rasterised } }) =>
      figure(
        `render.bodies.${form}`,
        'ms',
        times,
        `${bodiesDrawn} bodies, ${kept} fragments covered, the shader runs for ${rasterised}; SwiftShader, information`,
      ),
    ),
    figure(
      'render.lobes',
      'x',
      billboards.times.map((time, round) => time / lobes.times[round]),
      'bodies as baked billboards / as lobes met per pixel, the same particles',
    ),
  ];
}

/** Draws once, which also compiles the programs. */
function look(bench: RenderBench, form: PuffForm): Side {
  const style: Style = { ...PLAIN_STYLE, form };
  bench.style = style;
  const { bodiesDrawn } = bench.draw(false);
  return { form, style, times: [], bodiesDrawn, fragments: bench.countFragments().bodies };
}
