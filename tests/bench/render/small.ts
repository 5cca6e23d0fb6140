/**
 * render.small: a widget's frame, whose cost hardly depends on pixels. render.triangles and render.calls: the geometry of
 * the scene with the most models.
 */
import { SceneLab } from '../../visual/sceneLab.ts';
import { deviationFor } from '../../../src/smoke/detail.ts';
import { demand, figure, say, time, type Figure } from '../support/figures.ts';

const STEPS = 240;

export async function measureSmall(quick: boolean): Promise<Figure[]> {
  await say('render.small');
  const { lab: wisp, calls } = await drawn('wisp', 64, 48);
  const times: number[] = [];
  const frames = quick ? 20 : 60;
  for (let frame = 0; frame < frames; frame++) times.push(time(() => wisp.draw({ deviation: deviationIn(wisp) })));
  demand((wisp.report?.bodiesDrawn ?? 0) > 20, 'the wisp has no smoke');
  wisp.dispose();
  await say('render.triangles');
  const [large, little] = [await drawn('train', 1280, 720), await drawn('train', 160, 96)];
  for (const { lab } of [large, little]) lab.dispose();
  return [
    figure('render.small', 'ms', times, 'the wisp at 64 x 48, a frame; goal <= 6'),
    figure('render.small.calls', '', [calls], 'draw calls of that frame; goal <= 12'),
    figure('render.triangles', '', [large.triangles], 'the train at 1280 x 720; goal <= 120000'),
    figure('render.triangles.small', '', [little.triangles], 'the train at 160 x 96; goal <= 25000'),
    figure('render.triangles.calls', '', [large.calls], 'draw calls of the train; goal <= 20'),
  ];
}

/** A scene with smoke, drawn once, which compiles the programs; and its draw calls and triangles. */
async function drawn(preset: string, width: number, height: number) {
  const lab = await SceneLab.create(preset, { width, height, smoothEdges: true });
  lab.step(STEPS);
  lab.draw({ deviation: deviationIn(lab) });
  return { lab, ...lab.drawn() };
}

/** As a stage of this size has it. */
function deviationIn(lab: SceneLab): number {
  return deviationFor(1 / lab.pixelsPerMetre(lab.scene.camera.distance));
}
