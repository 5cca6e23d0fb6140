/** Stages that change to a renderer before its code is loaded. */
import { createStage } from '../../../src/stage/stage.ts';
import { differing, HEIGHT, lampStage, shown, SMALL, visibleCanvas, WIDTH } from './stage.cases.ts';
import type { Values } from '../../../src/parameters/parameter.ts';

/**
 * Pixels that change immediately when the renderer changes, pixels that change after its code is loaded, and pixels
 * that differ then from a stage created with that renderer.
 */
export async function lateRenderer(): Promise<{ atOnce: number; later: number; fromStart: number }> {
  const canvas = visibleCanvas();
  const stage = await lampStage(canvas);
  stage.step(90);
  const before = shown(canvas);
  stage.set({ 'style.renderer': 'selle' });
  const atOnce = differing(before, shown(canvas));
  await stage.complete();
  const after = shown(canvas);
  const values: Values = { ...SMALL, 'style.renderer': 'selle' };
  const other = await createStage(visibleCanvas(), { values, width: WIDTH, height: HEIGHT, pixelRatio: 1 });
  other.step(90);
  const fromStart = differing(after, shown(other.canvas as HTMLCanvasElement));
  for (const each of [stage, other]) each.dispose();
  return { atOnce, later: differing(before, after), fromStart };
}

/**
 * Notices and errors of a stage for a renderer and a view whose code cannot be loaded, and whether the stage goes on.
 */
export async function lostRenderer(): Promise<{ notified: string[]; thrown: string; steps: number; drawn: number }> {
  const stage = await lampStage(visibleCanvas());
  const notified: string[] = [];
  stage.on('error', (error) => notified.push(`${error.name}: ${error.message}`));
  stage.set({ 'style.renderer': 'selle' });
  const thrown = await stage.picture().then(
    () => 'nothing',
    (error: Error) => error.name,
  );
  await stage.seek(1);
  const { steps, bodiesDrawn } = stage.stats;
  stage.dispose();
  return { notified, thrown, steps, drawn: bodiesDrawn };
}
