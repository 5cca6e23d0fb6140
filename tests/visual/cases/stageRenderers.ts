/** Stages that are asked for a renderer whose code is not here yet. */
import { createStage } from '../../../src/stage/stage.ts';
import { differing, HEIGHT, lampStage, shown, SMALL, visibleCanvas, WIDTH } from './stage.ts';

/**
 * Pixels by which a picture changes at once when another renderer is asked for whose code is not here, when it has come, and
 * by which it differs then from that of a stage that began with it.
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
  const values = { ...SMALL, 'style.renderer': 'selle' };
  const other = await createStage(visibleCanvas(), { values, width: WIDTH, height: HEIGHT, pixelRatio: 1 });
  other.step(90);
  const fromStart = differing(after, shown(other.canvas as HTMLCanvasElement));
  for (const each of [stage, other]) each.dispose();
  return { atOnce, later: differing(before, after), fromStart };
}

/** What a stage says of a renderer and of a view whose code cannot be fetched, and whether it goes on. */
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
