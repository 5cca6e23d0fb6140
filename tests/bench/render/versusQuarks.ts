/** render.vsQuarks: a full cartoon frame compared with blended quads of three.quarks, with the same puffs, in turns. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { HEIGHT, RenderBench, SURROUNDINGS, WIDTH } from './bench.ts';
import { countFragments } from './fragments.ts';
import { QuarksScene } from './quarks.ts';

const PUFFS = 10_000;

export async function measureAgainstQuarks(quick: boolean): Promise<Figure[]> {
  const bench = await RenderBench.create(1, PUFFS);
  const quarks = new QuarksScene(bench.places(), SURROUNDINGS.surfaces);
  const note = check(bench, quarks);
  const [ours, theirs]: number[][] = [[], []];
  const rounds = quick ? 5 : 9;
  for (let round = 0; round < rounds; round++) {
    await say(`render.vsQuarks, round ${round + 1} of ${rounds}`);
    const runs = [
      () => ours.push(bench.timeDrawing(() => bench.draw(true))),
      () => theirs.push(bench.timeDrawing(() => quarks.draw(bench.device.renderer, bench.camera))),
    ];
    for (const run of round % 2 === 0 ? runs : runs.toReversed()) run();
  }
  quarks.dispose();
  bench.dispose();
  return [
    figure('render.vsQuarks.ours', 'ms', ours, `${note.ours}; SwiftShader, information`),
    figure('render.vsQuarks.theirs', 'ms', theirs, `${note.theirs}; SwiftShader, information`),
    figure(
      'render.vsQuarks',
      'x',
      ours.map((milliseconds, round) => milliseconds / theirs[round]),
      `cartoon frame / ${PUFFS} blended quads of the same places and sizes, ${WIDTH} x ${HEIGHT}; goal <= 1.25`,
    ),
  ];
}

/** Draws each side once, which also compiles its programs, and checks the result. */
function check(bench: RenderBench, quarks: QuarksScene): { ours: string; theirs: string } {
  const { renderer } = bench.device;
  const { bodiesDrawn, castersDrawn } = bench.draw(true);
  const { bodies, casters, body, volumes } = bench.smoke.passes;
  const [bodyFragments, volumeFragments] = [
    countFragments(renderer, bodies.geometry, body.material, WIDTH, HEIGHT).kept,
    countFragments(renderer, casters.geometry, volumes.material, WIDTH, HEIGHT).kept,
  ];
  const quads = Math.round(quarks.countFragments(renderer, bench.camera, WIDTH, HEIGHT));
  quarks.draw(renderer, bench.camera);
  const colors = new Set(new Uint32Array(bench.picture().buffer)).size;
  demand(quarks.alive === PUFFS, `three.quarks draws ${quarks.alive} particles`);
  demand(colors > 100, `the picture of three.quarks has ${colors} colours`);
  demand(quads > WIDTH * HEIGHT, `the quads of three.quarks cover ${quads} fragments`);
  return {
    ours: `${bodiesDrawn} bodies and ${castersDrawn} casters, ${bodyFragments} and ${volumeFragments} fragments covered`,
    theirs: `${quarks.alive} quads, ${quads} fragments covered`,
  };
}
