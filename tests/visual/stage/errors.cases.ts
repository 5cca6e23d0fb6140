/** Stages with invalid arguments: the error, and that the state is unchanged. */
import { ParameterError } from '../../../src/base/errors.ts';
import type { Stage } from '../../../src/stage/stage.ts';
import { HEIGHT, lampStage, WIDTH } from './stage.cases.ts';

const ASKED: Readonly<Record<string, (stage: Stage) => unknown>> = {
  n: (stage) => stage.step(NaN),
  seconds: (stage) => stage.advance(NaN),
  speed: (stage) => (stage.speed = NaN),
  'camera.azimuth': (stage) => stage.camera.orbit(NaN, 0),
  'camera.distance': (stage) => stage.camera.zoom(NaN),
  'camera.target.x': (stage) => stage.camera.pan(NaN, 0),
  y: (stage) => stage.pointer({ type: 'down', id: 1, x: 3, y: NaN }),
  dz: (stage) => stage.nudge({ dz: NaN }),
  pixelRatio: (stage) => stage.resize(WIDTH, HEIGHT, NaN),
};

/** The names in the errors for NaN, the expected names, and whether the visible state is unchanged. */
export async function rejectNaN() {
  const stage = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  const errors: unknown[] = [];
  stage.on('error', (error) => errors.push(error));
  stage.step(20);
  const before = JSON.stringify([stage.hash(), stage.get(), stage.speed, stage.sight.plane]);
  const notified = Object.values(ASKED).map((ask) => nameInError(() => ask(stage)));
  notified.push(await stage.seek(NaN).then(String, keyOf));
  const isSame = before === JSON.stringify([stage.hash(), stage.get(), stage.speed, stage.sight.plane]);
  stage.nudge({ dx: 0.1 });
  stage.advance(1 / 24);
  const { size } = await stage.picture();
  stage.dispose();
  return { notified, wanted: [...Object.keys(ASKED), 'seconds'], isSame, errors: errors.length, isDrawn: size > 1000 };
}

function nameInError(act: () => unknown): string {
  try {
    return `taken: ${String(act())}`;
  } catch (error) {
    return keyOf(error);
  }
}

function keyOf(error: unknown): string {
  return error instanceof ParameterError ? error.key : String(error);
}

/** The step of a stage after seeks that were cancelled before they began, and their rejection reasons. */
export async function seekCalledOff(): Promise<{ steps: number[]; reasons: unknown[] }> {
  const stage = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  stage.step(70);
  const reasons: unknown[] = [];
  const steps: number[] = [];
  for (const seconds of [0.5, stage.stats.time, 2]) {
    const signal = AbortSignal.abort(`not to ${seconds} s`);
    await stage.seek(seconds, { signal }).catch((reason) => reasons.push(reason));
    steps.push(stage.stats.steps);
  }
  stage.dispose();
  return { steps, reasons };
}
