/** Stages over time: playback speed, seeks in both directions, replayed takes. */
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { differing, HEIGHT, lampStage, pixelsOf, SMALL, WIDTH } from './stage.cases.ts';

/**
 * Moves smoke with a 60 Hz clock at a playback speed.
 * @returns largest difference between a frame's movement, in movements of a step, and the speed
 */
export async function movementAtSpeed(speed: number): Promise<number> {
  const { Clock } = await import('../../../src/simulator/clock.ts');
  const { loadSimulators } = await import('../../../src/simulator/load.ts');
  const simulator = (await loadSimulators({ physics: false })).create({ capacity: 64, seed: 3 });
  simulator.set({ 'emission.rate': 600, 'emission.lifetime': 50, 'emitters.0.share': 1, 'emitters.0.size': 0.1 });
  simulator.set({ 'emission.growthTime': 0, 'turbulence.speed': 0 });
  simulator.step(6);
  simulator.set({ 'emission.rate': 0, 'forces.wind.x': 2, 'emitters.0.speed': 0 });
  simulator.step(2);
  const clock = new Clock();
  clock.speed = speed;
  const centres: number[] = [];
  for (let frame = 0; frame < 40; ++frame) {
    const steps = clock.tick((frame * 1000) / 60);
    if (steps > 0) simulator.step(steps);
    centres.push(centreX(simulator, clock.blend));
  }
  simulator.dispose();
  const moves = centres.slice(1).map((centre, index) => centre - centres[index]);
  const wholeStep = 2 / 60;
  return Math.max(...moves.map((move) => Math.abs(move / wholeStep - speed)));
}

function centreX(simulator: Simulator, blend: number): number {
  const { count, place } = simulator.arrange({ ...EVERYTHING, blend }).rows;
  let sum = 0;
  for (let row = 0; row < count; ++row) sum += place[4 * row];
  return sum / count;
}

/** Records a take on one stage and replays it on another: hashes, values and pictures of both. */
export async function replayTake(): Promise<Record<'hashes' | 'rates' | 'inputs', unknown[]> & { changed: number }> {
  const [first, second] = await Promise.all([1, 2].map(() => lampStage(new OffscreenCanvas(WIDTH, HEIGHT))));
  first.set({ 'style.tones': 3 });
  first.restart();
  first.step(50);
  first.set({ 'emission.rate': 60, 'light.azimuth': 20 });
  first.nudge({ dx: -0.9, dy: -0.2 });
  first.step(30);
  first.blow({ x: WIDTH / 2, y: HEIGHT / 3, dx: 6, dy: -2 });
  first.steer(2, 0.25);
  first.step(40);
  const hashes = [first.hash()];
  second.set({ 'emission.rate': 90, seed: 5 });
  second.step(33);
  second.playTake(first.take().toBytes());
  const rates = [SMALL['emission.rate'], second.get()['emission.rate']];
  for (const seconds of [2, 0.5, 2]) await second.seek(seconds);
  hashes.push(second.hash());
  rates.push(second.get()['emission.rate']);
  // The light changed after the start and is not part of the simulation, so the receiver sets it.
  second.set({ 'light.azimuth': 20 });
  const inputs = [first.stats.inputs, second.take().inputs];
  const [a, b] = await Promise.all([first, second].map(async (stage) => pixelsOf(await stage.picture())));
  for (const stage of [first, second]) stage.dispose();
  return { hashes, rates, inputs, changed: differing(a, b) };
}

/** Seeks back in time: hashes of the first run and of the repeated one, and the memory of the history. */
export async function seekBack(): Promise<{ straight: string[]; again: string[]; bytes: number; rates: unknown[] }> {
  const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), {
    values: SMALL,
    width: WIDTH,
    height: HEIGHT,
    historyBytes: 1_000_000,
  });
  const straight: string[] = [];
  for (let second = 1; second <= 4; ++second) {
    stage.step(60);
    straight.push(stage.hash());
    stage.set({ 'emission.rate': 40 * second });
    stage.nudge({ dx: -0.3 });
  }
  const again: string[] = [];
  const rates: unknown[] = [];
  for (const second of [3, 1, 4, 2]) {
    await stage.seek(second);
    again[second - 1] = stage.hash();
    rates[second - 1] = stage.get()['emission.rate'];
  }
  const bytes = stage.stats.historyBytes;
  stage.dispose();
  return { straight, again, bytes, rates };
}
