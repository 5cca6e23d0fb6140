import { SimulatorError } from '../preset/errors.ts';
import type { Stage } from '../stage/stage.ts';
import type { RemoteMethods, RemoteStage, Thread } from './contract.ts';

/** A loading error was already reported; the call works without the missing code. */
function completed(stage: Stage): Promise<void> {
  return stage.complete().catch(() => undefined);
}

/** Implements each method on a stage of this thread. */
const methods = {
  play: (stage) => stage.play(),
  pause: (stage) => stage.pause(),
  step: async (stage, n) => {
    await completed(stage);
    stage.step(n);
  },
  seek: (stage, seconds) => stage.seek(seconds),
  advance: async (stage, seconds) => {
    await completed(stage);
    stage.advance(seconds);
  },
  clear: (stage) => stage.clear(),
  restart: (stage) => stage.restart(),
  enter: (stage, values) => stage.enter(values),
  set: (stage, values) => stage.set(values),
  unset: (stage, keys) => stage.unset(keys),
  get: (stage) => stage.get(),
  picture: (stage) => stage.picture(),
  save: (stage) => stage.save(),
  restore: (stage, bytes) => stage.restore(bytes),
  take: (stage) => stage.take(),
  readTake: (stage, bytes) => stage.readTake(bytes),
  playTake: (stage, take) => stage.playTake(take),
  hash: (stage) => stage.hash(),
  stats: (stage, { gpu = false } = {}) => {
    stage.timeGpu(gpu);
    return stage.stats;
  },
  resize: (stage, width, height, pixelRatio) => stage.resize(width, height, pixelRatio),
  pointer: (stage, input) => stage.pointer(input),
  blow: (stage, input) => stage.blow(input),
  drop: (stage, x, y) => stage.drop(x, y),
  steer: (stage, channel, value) => stage.steer(channel, value),
  nudge: (stage, by) => stage.nudge(by),
  orbit: (stage, azimuth, elevation) => stage.camera.orbit(azimuth, elevation),
  zoom: (stage, factor) => stage.camera.zoom(factor),
  pan: (stage, x, y) => stage.camera.pan(x, y),
  resetView: (stage) => stage.camera.reset(),
  plane: (stage) => stage.sight.plane,
  setBackground: (stage, isShown) => void (stage.background = isShown),
  setVisible: (stage, isVisible) => void (stage.visible = isVisible),
} satisfies {
  [Name in keyof RemoteMethods]: (
    stage: Stage,
    ...given: Parameters<RemoteMethods[Name]>
  ) => Awaited<ReturnType<RemoteMethods[Name]>> | ReturnType<RemoteMethods[Name]>;
};

/**
 * Wraps a stage of this thread as a RemoteStage.
 * @param release called once, after disposal
 */
export function localStage(stage: Stage, thread: Thread = 'main', release?: () => void): RemoteStage {
  let isDisposed = false;
  const called = Object.entries(methods).map(([name, method]) => [
    name,
    async (...given: unknown[]) => {
      if (isDisposed) throw new SimulatorError('This stage was disposed; create a new one.');
      return (method as (stage: Stage, ...given: unknown[]) => unknown)(stage, ...given);
    },
  ]);
  return {
    ...(Object.fromEntries(called) as RemoteMethods),
    ready: stage.ready,
    thread,
    on: (event, listener) => stage.on(event, listener),
    async dispose() {
      if (isDisposed) return;
      isDisposed = true;
      stage.dispose();
      release?.();
    },
  };
}
