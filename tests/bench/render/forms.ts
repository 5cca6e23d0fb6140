/**
 * render.lobes, render.stretching, render.eroding, render.strokes.*, render.simplify: cost of bodies as lobes, as baked
 * billboards, as stretched lobes and as lobes with bites, and of strokes and large shapes of light, of the same particles,
 * in turns.
 */
import { MAX_STRETCH } from '../../../src/base/constants.ts';
import { ATTRIBUTE_BITS, ATTRIBUTE_WORDS } from '../../../src/simulator/layout.ts';
import { readBits } from '../../../src/simulator/rows.ts';
import type { Arranger } from '../../../src/renderer/frameInput.ts';
import type { Style } from '../../../src/renderer/style.ts';
import { PLAIN_STYLE } from '../../visual/lab.ts';
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { RenderBench } from './bench.ts';
import type { Fragments } from './fragments.ts';

/** Ratio of the axes of stretched puffs: about the mean of the lamp and of the rocket. */
const RATIO = 2;

/** CSS px, as in most presets. */
const SIMPLIFY = 3;

/** As in presets with lines. */
const SOME_STROKES = 0.4;

/** Results of one form. */
interface Side {
  name: string;
  style: Style;
  arranger: Arranger;
  /** Milliseconds of the bodies and of the whole frame. */
  times: number[];
  frames: number[];
  bodiesDrawn: number;
  fragments: Fragments;
}

export async function measureForms(quick: boolean): Promise<Figure[]> {
  const bench = await RenderBench.create();
  const arranger = { plain: bench.simulator, stretched: stretched(bench.simulator), eroded: eroded(bench.simulator) };
  const lobes = look(bench, 'lobes', arranger.plain, {});
  const billboards = look(bench, 'billboards', arranger.plain, { form: 'billboards' });
  const deformed = { isDeformed: true, stretch: RATIO };
  const rotated = look(bench, 'rotated', arranger.plain, deformed);
  const longer = look(bench, 'stretched', arranger.stretched, deformed);
  const drawn = look(bench, 'strokes', arranger.plain, { strokes: 1 });
  const someDrawn = look(bench, 'some strokes', arranger.plain, { strokes: SOME_STROKES });
  const simplified = look(bench, 'simplified', arranger.plain, { simplify: SIMPLIFY });
  const bitten = look(bench, 'eroded', arranger.eroded, { isEroded: true });
  const sides = [lobes, billboards, rotated, longer, drawn, someDrawn, bitten, simplified];
  // Unculled, because the forms hide different numbers of bodies.
  const same = lobes.bodiesDrawn === billboards.bodiesDrawn;
  demand(same, `${lobes.bodiesDrawn} bodies of lobes and ${billboards.bodiesDrawn} billboards`);
  const rounds = quick ? 5 : 11;
  for (let round = 0; round < rounds; round++) {
    await say(`render.lobes, round ${round + 1} of ${rounds}`);
    for (const side of round % 2 === 0 ? sides : sides.toReversed()) {
      bench.style = side.style;
      bench.arranger = side.arranger;
      const times = bench.timeFrame(false);
      side.times.push(times.bodies);
      side.frames.push(times.frame);
    }
  }
  bench.dispose();
  return [
    ...sides
      .slice(0, 4)
      .map(({ name, times, bodiesDrawn, fragments: { kept, rasterised } }) =>
        figure(
          `render.bodies.${name}`,
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
    figure(
      'render.rotating',
      'x',
      rotated.times.map((time, round) => time / lobes.times[round]),
      'bodies with the shaders of puffs that turn and stretch / without, the same rows',
    ),
    figure(
      'render.stretching',
      'x',
      longer.times.map((time, round) => time / lobes.times[round]),
      `bodies stretched upwards by ${RATIO} / not stretched, the same particles`,
    ),
    figure(
      'render.eroding',
      'x',
      bitten.times.map((time, round) => time / lobes.times[round]),
      'bodies eroded by 0 to 1, evenly spread / whole, the same particles',
    ),
    figure(
      'render.strokes',
      'x',
      drawn.frames.map((time, round) => time / lobes.frames[round]),
      'frames with style.strokes=1 / with 0, the same particles',
    ),
    figure(
      'render.strokes.some',
      'x',
      someDrawn.frames.map((time, round) => time / lobes.frames[round]),
      `frames with style.strokes=${SOME_STROKES} / with 0, the same particles`,
    ),
    figure(
      'render.simplify',
      'x',
      simplified.frames.map((time, round) => time / lobes.frames[round]),
      `frames with style.simplify=${SIMPLIFY} / with 0, the same particles`,
    ),
  ];
}

/** Draws once, which also compiles the programs. */
function look(bench: RenderBench, name: string, arranger: Arranger, changed: Partial<Style>): Side {
  const style: Style = { ...PLAIN_STYLE, ...changed };
  bench.style = style;
  bench.arranger = arranger;
  const { bodiesDrawn } = bench.draw(false);
  return { name, style, arranger, times: [], frames: [], bodiesDrawn, fragments: bench.countFragments().bodies };
}

/** The same rows, stretched upwards. */
function stretched(simulator: Arranger): Arranger {
  const { stretchU, stretchV, stretch } = ATTRIBUTE_BITS;
  const steps = Math.round((stretch.max * (RATIO - 1)) / (MAX_STRETCH - 1));
  const word = ((127 << stretchU.shift) | (254 << stretchV.shift) | (steps << stretch.shift)) >>> 0;
  return withLastWord(simulator, () => word);
}

/** The same rows, each with another erosion above 0. */
function eroded(simulator: Arranger): Arranger {
  const { shift, max } = ATTRIBUTE_BITS.erosion;
  return withLastWord(simulator, (row) => ((1 + ((row * 97) % max)) << shift) >>> 0);
}

function withLastWord(simulator: Arranger, wordOf: (row: number) => number): Arranger {
  return {
    moves: () => simulator.moves(),
    arrange(view) {
      const { rows, bounds, grid } = simulator.arrange(view);
      const { count, attributes } = rows;
      for (let row = 0; row < count; row++)
        attributes[ATTRIBUTE_WORDS * row + ATTRIBUTE_BITS.erosion.word] = wordOf(row);
      const isEroded = readBits(attributes, 0, ATTRIBUTE_BITS.erosion) > 0;
      return { rows: { ...rows, whole: isEroded ? 0 : count }, bounds, grid };
    },
  };
}
