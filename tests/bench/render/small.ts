/**
 * render.small: a widget's frame, whose cost hardly depends on pixels, as it is drawn on a page and with the plain look of
 * the other figures. render.triangles and render.calls: the geometry of the scene with the most models.
 */
import { SceneLab } from '../../visual/sceneLab.ts';
import { fetchExtras } from '../../../src/renderer/extraPasses.ts';
import { demand, figure, say, timeDrawing, type Figure } from '../support/figures.ts';

const STEPS = 240;

export async function measureSmall(quick: boolean): Promise<Figure[]> {
  const frames = quick ? 20 : 60;
  const widget = await measureWidget(true, frames);
  const plain = await measureWidget(false, frames);
  await say('render.triangles');
  const [large, little] = [await drawn('train', 1280, 720, false), await drawn('train', 160, 96, false)];
  for (const { lab } of [large, little]) lab.dispose();
  return [
    figure('render.small', 'ms', widget.times, 'the wisp at 64 x 48, a frame; goal <= 6'),
    figure('render.small.calls', '', [widget.calls], 'draw calls of that frame; goal <= 12'),
    figure('render.small.plain', 'ms', plain.times, 'the same without simplified light; goal <= 6'),
    figure('render.small.plain.calls', '', [plain.calls], 'draw calls of that frame; goal <= 12'),
    figure('render.triangles', '', [large.triangles], 'the train at 1280 x 720; goal <= 120000'),
    figure('render.triangles.small', '', [little.triangles], 'the train at 160 x 96; goal <= 25000'),
    figure('render.triangles.calls', '', [large.calls], 'draw calls of the train; goal <= 20'),
  ];
}

/** @param frames are drawn before the measurement, until all code is compiled, and as many are measured */
async function measureWidget(ownLook: boolean, frames: number) {
  await say(`render.small, ${ownLook ? 'own' : 'plain'} look`);
  const { lab, calls } = await drawn('wisp', 64, 48, ownLook);
  const frame = () => timeDrawing(lab.context, () => lab.redraw());
  const times = Array.from({ length: 2 * frames }, frame).slice(frames);
  demand((lab.report?.bodiesDrawn ?? 0) > 20, 'the wisp has no smoke');
  lab.dispose();
  return { times, calls };
}

/** A scene with smoke, drawn once, which compiles the programs; and its draw calls and triangles. */
async function drawn(preset: string, width: number, height: number, ownLook: boolean) {
  const lab = await SceneLab.create(preset, { width, height, smoothEdges: true, ownLook });
  await fetchExtras(lab.style);
  lab.step(STEPS);
  lab.redraw();
  return { lab, ...lab.drawn() };
}
