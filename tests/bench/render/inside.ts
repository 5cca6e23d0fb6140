/** render.inside: the frame with the camera inside the plume, where each near volume may cover the whole picture. */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { PARTICLES, RenderBench } from './bench.ts';

export async function measureInside(quick: boolean): Promise<Figure[]> {
  const bench = await RenderBench.create();
  const outside = lookFrom(bench, false);
  bench.camera.position.set(0.4, 1.6, 0.1);
  bench.camera.lookAt(0.4, 1.7, -1);
  const inside = lookFrom(bench, true);
  demand(inside.bodiesDrawn > 10, `only ${inside.bodiesDrawn} bodies are seen from inside`);
  const rounds = quick ? 5 : 9;
  for (let round = 0; round < rounds; round++) {
    await say(`render.inside, round ${round + 1} of ${rounds}`);
    for (const view of round % 2 === 0 ? [outside, inside] : [inside, outside]) {
      bench.camera.matrixWorld.copy(view.place);
      bench.camera.matrixWorld.decompose(bench.camera.position, bench.camera.quaternion, bench.camera.scale);
      view.times.push(bench.timeDrawing(() => bench.draw(true)));
    }
  }
  bench.dispose();
  return [
    figure(
      'render.inside',
      'x',
      inside.times.map((time, round) => time / outside.times[round]),
      `frame from inside the plume / from outside, ${PARTICLES} particles; ${inside.note}; outside ${outside.note}`,
    ),
  ];
}

/** Draws once with the current camera, which also compiles the programs. */
function lookFrom(bench: RenderBench, isTiled: boolean) {
  bench.camera.updateMatrixWorld();
  const { bodiesDrawn, castersDrawn } = bench.draw(true);
  const { bodies, volumes } = bench.countFragments(isTiled);
  const note = `${bodiesDrawn} bodies, ${castersDrawn} casters, shaders run for ${bodies.rasterised} and ${volumes.rasterised} fragments`;
  return { place: bench.camera.matrixWorld.clone(), bodiesDrawn, note, times: [] as number[] };
}
