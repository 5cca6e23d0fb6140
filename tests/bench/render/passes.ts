/** render.*: milliseconds of each pass and of the whole frame, with and without the culling of `arrange`, in turns. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { HEIGHT, PARTICLES, RenderBench, WIDTH, type FrameTimes } from './bench.ts';
import type { Fragments } from './fragments.ts';

const PASSES = ['bodies', 'volumes', 'resolve', 'frame'] as const;

/** Results of one variant. */
interface Side {
  cull: boolean;
  times: FrameTimes[];
  bodiesDrawn: number;
  castersDrawn: number;
  bodies: Fragments;
  volumes: Fragments;
  picture: Uint8Array;
}

export async function measurePasses(quick: boolean): Promise<Figure[]> {
  const bench = await RenderBench.create();
  const culled = look(bench, true);
  const whole = look(bench, false);
  compare(culled, whole);
  const rounds = quick ? 5 : 11;
  for (let round = 0; round < rounds; round++) {
    await say(`render, round ${round + 1} of ${rounds}`);
    for (const side of round % 2 === 0 ? [culled, whole] : [whole, culled]) {
      side.times.push(bench.timeFrame(side.cull));
    }
  }
  bench.dispose();
  return [
    ...figuresOf(culled, ''),
    ...figuresOf(whole, '.unculled'),
    figure(
      'render.culling',
      'x',
      whole.times.map(({ frame }, round) => frame / culled.times[round].frame),
      'frame without culling / frame with it; both pictures are the same to the bit',
    ),
    figure(
      'render.volumesPerPixel',
      '',
      [culled.volumes.rasterised / (WIDTH * HEIGHT)],
      'tests of a caster against a pixel, over pixels; goal <= 2',
    ),
    ...fragmentFigures(culled, ''),
    ...fragmentFigures(whole, '.unculled'),
  ];
}

/** Draws once, which also compiles the programs, and checks the result. */
function look(bench: RenderBench, cull: boolean): Side {
  const { bodiesDrawn, castersDrawn } = bench.draw(cull);
  const picture = bench.picture();
  return {
    cull,
    times: [],
    bodiesDrawn,
    castersDrawn,
    ...bench.countFragments(),
    picture,
  };
}

function compare(culled: Side, whole: Side): void {
  demand(whole.bodiesDrawn === PARTICLES, `${whole.bodiesDrawn} bodies were drawn without culling`);
  demand(culled.bodiesDrawn < whole.bodiesDrawn, 'culling left nothing out');
  demand(culled.castersDrawn < whole.castersDrawn, 'culling left no caster out');
  demand(culled.bodies.kept < whole.bodies.kept, 'culling left out nothing that is hidden');
  const colors = new Set(new Uint32Array(whole.picture.buffer));
  demand(colors.size > 10, `the picture has ${colors.size} colours`);
  const different = whole.picture.findIndex((value, index) => value !== culled.picture[index]);
  demand(different < 0, `culling changed pixel ${different >> 2}`);
}

function figuresOf({ times, bodiesDrawn, castersDrawn, cull }: Side, suffix: string): Figure[] {
  const notes: Record<keyof FrameTimes, string> = {
    bodies: `${bodiesDrawn} of ${PARTICLES} bodies`,
    volumes: `${castersDrawn} of ${PARTICLES} casters`,
    resolve: `${WIDTH} x ${HEIGHT}`,
    frame: `all of it, arrange included, ${cull ? 'with' : 'without'} culling`,
  };
  return PASSES.map((pass) =>
    figure(
      `render.${pass}${suffix}`,
      'ms',
      times.map((one) => one[pass]),
      `${notes[pass]}; SwiftShader, information`,
    ),
  );
}

function fragmentFigures({ bodies, volumes }: Side, suffix: string): Figure[] {
  return Object.entries({ bodies, volumes }).map(([pass, { kept, rasterised }]) =>
    figure(`render.${pass}.fragments${suffix}`, '', [kept], `covered; the shader runs for ${rasterised}`),
  );
}
