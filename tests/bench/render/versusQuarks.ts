/**
 * render.vsQuarks: a frame in the look of the lamp, and in the plain look, compared with blended quads of three.quarks, with
 * the same puffs, in turns.
 */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { HEIGHT, RenderBench, SURROUNDINGS, WIDTH } from './bench.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { seededPlume } from './plume.ts';
import { QuarksScene } from './quarks.ts';

const PUFFS = 10_000;

/** Scale of the suite's picture, 640 x 360, to 1920 x 1080. */
const HD = 3;

export async function measureAgainstQuarks(quick: boolean): Promise<Figure[]> {
  const rounds = quick ? 5 : 9;
  const lamp = presetValues(findPreset('lamp')!);
  return [
    ...(await measureAt(1, rounds, '', lamp)),
    ...(await measureAt(1, rounds, '.plain')),
    ...(await measureAt(HD, 5, '.hd', lamp)),
    ...(await measureAt(HD, 5, '.hd.plain')),
  ];
}

/** @param look the values of the style; the plain one if absent */
async function measureAt(scale: number, rounds: number, suffix: string, look?: Values): Promise<Figure[]> {
  const bench = await RenderBench.create(scale, PUFFS, seededPlume, look);
  const quarks = new QuarksScene(bench.places(), SURROUNDINGS.surfaces);
  const [width, height] = [scale * WIDTH, scale * HEIGHT];
  const note = check(bench, quarks, width, height);
  const [ours, theirs]: number[][] = [[], []];
  for (let round = 0; round < rounds; round++) {
    await say(`render.vsQuarks${suffix}, round ${round + 1} of ${rounds}`);
    const runs = [
      () => ours.push(bench.timeDrawing(() => bench.draw(true))),
      () => theirs.push(bench.timeDrawing(() => quarks.draw(bench.device.renderer, bench.camera))),
    ];
    for (const run of round % 2 === 0 ? runs : runs.toReversed()) run();
  }
  quarks.dispose();
  bench.dispose();
  return [
    figure(`render.vsQuarks${suffix}.ours`, 'ms', ours, `${note.ours}; SwiftShader, information`),
    figure(`render.vsQuarks${suffix}.theirs`, 'ms', theirs, `${note.theirs}; SwiftShader, information`),
    figure(
      `render.vsQuarks${suffix}`,
      'x',
      ours.map((milliseconds, round) => milliseconds / theirs[round]),
      `cartoon frame / ${PUFFS} blended quads of the same places and sizes, ${width} x ${height}${suffix ? '' : '; goal <= 1.8'}`,
    ),
  ];
}

/** Draws each side once, which also compiles its programs, and checks the result. */
function check(
  bench: RenderBench,
  quarks: QuarksScene,
  width: number,
  height: number,
): { ours: string; theirs: string } {
  const { renderer } = bench.device;
  const { bodiesDrawn, castersDrawn } = bench.draw(true);
  const fragments = bench.countFragments();
  const quads = Math.round(quarks.countFragments(renderer, bench.camera, width, height));
  quarks.draw(renderer, bench.camera);
  const colors = new Set(new Uint32Array(bench.picture().buffer)).size;
  demand(quarks.alive === PUFFS, `three.quarks draws ${quarks.alive} particles`);
  demand(colors > 100, `the picture of three.quarks has ${colors} colours`);
  demand(quads > width * height, `the quads of three.quarks cover ${quads} fragments`);
  return {
    ours: `${bodiesDrawn} bodies and ${castersDrawn} casters, ${fragments.bodies.rasterised} and ${fragments.volumes.rasterised} fragments shaded`,
    theirs: `${quarks.alive} quads, ${quads} fragments covered`,
  };
}
