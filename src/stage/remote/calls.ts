/**
 * The methods of a stage that can be called from another thread or page, in one list: what each calls. `methods.ts` has their
 * messages, which stages of this thread do not need.
 */
import type { GivenValues } from '../../parameters/timeline.ts';
import type { EmissionChange, EmissionOptions } from '../../simulator/emitterOptions.ts';
import type { BlowInput, ModelOptions, PointerInput, StatsOptions } from '../contract.ts';
import type { Stage } from '../stage.ts';
import type { Take } from '../take.ts';

/** A loading error was already reported; the call works without the missing code. */
function completed(stage: Stage): Promise<void> {
  return stage.complete().catch(() => undefined);
}

export const calls = {
  play: (stage: Stage) => stage.play(),
  pause: (stage: Stage) => stage.pause(),
  /** @param n an integer of at least 0. Default: 1. At most 36,000 in a worker or an iframe */
  step: async (stage: Stage, n?: number) => {
    await completed(stage);
    stage.step(n);
  },
  /** @param seconds simulated time, at least 0; at most 600 in a worker or an iframe */
  seek: (stage: Stage, seconds: number) => stage.seek(seconds),
  /** @param seconds simulated time, at least 0; at most 600 in a worker or an iframe */
  advance: async (stage: Stage, seconds: number) => {
    await completed(stage);
    stage.advance(seconds);
  },
  /** Removes all puffs; emitters and values stay. */
  clear: (stage: Stage) => stage.clear(),
  restart: (stage: Stage) => stage.restart(),
  /** Loads another scene, or restarts the current one. Omitted values get their defaults. */
  enter: (stage: Stage, values: GivenValues) => stage.enter(values),
  /** Rejects also if the timeline is invalid; it resolves when its code is loaded. */
  set: (stage: Stage, values: GivenValues) => stage.setChecked(values),
  unset: (stage: Stage, keys: readonly string[]) => stage.unset(keys),
  get: (stage: Stage) => stage.get(),
  /** A PNG at full resolution, also while the canvas is not visible. */
  picture: (stage: Stage) => stage.picture(),
  save: (stage: Stage) => stage.save(),
  restore: (stage: Stage, bytes: Uint8Array) => stage.restore(bytes),
  take: (stage: Stage) => stage.take(),
  /** Reads the metadata of a take without playing it. */
  readTake: (stage: Stage, bytes: Uint8Array) => stage.readTake(bytes),
  /** @param take the result of `take()`, or its bytes */
  playTake: (stage: Stage, take: Take | Uint8Array) => stage.playTake(take),
  /** 16 hexadecimal digits. */
  hash: (stage: Stage) => stage.hash(),
  stats: (stage: Stage, options?: StatsOptions) => {
    stage.timeGpu(options?.gpu ?? false);
    return stage.stats;
  },
  /** @param width, height in CSS pixels, at most 65,536 */
  resize: (stage: Stage, width: number, height: number, pixelRatio?: number) => stage.resize(width, height, pixelRatio),
  pointer: (stage: Stage, input: PointerInput) => stage.pointer(input),
  blow: (stage: Stage, input: BlowInput) => stage.blow(input),
  steer: (stage: Stage, channel: number, value: number) => stage.steer(channel, value),
  /** Resolves to the number of the emission. */
  emit: (stage: Stage, given: EmissionOptions) => stage.emit(given),
  /** @param emission the result of `emit` */
  changeEmission: (stage: Stage, emission: number, given: EmissionChange) => stage.changeEmission(emission, given),
  /**
   * Drops a ball or a crate at a position in the picture, in CSS pixels. Resolves to false if the scene has no objects
   * to drop.
   */
  drop: (stage: Stage, x: number, y: number) => stage.drop(x, y),
  /**
   * Stands a model in the scene, a GLB file, and restarts; null removes it. A worker or an iframe takes the bytes away if they
   * are a whole buffer. Resolves to what the file contains.
   */
  setModel: (stage: Stage, bytes: Uint8Array | null, options?: ModelOptions) => stage.setModel(bytes, options),
  /** The place of the model's surface at a position in the picture, in CSS pixels; null where it is not. */
  pickModel: (stage: Stage, x: number, y: number) => stage.pickModel(x, y),
  /** Moves the target of the movable rigid, in metres. */
  nudge: (stage: Stage, by: { dx?: number; dy?: number; dz?: number }) => stage.nudge(by),
  /** Rotates the camera about its target, in radians. */
  orbit: (stage: Stage, azimuth: number, elevation: number) => stage.camera.orbit(azimuth, elevation),
  /** A factor above 1 moves the camera closer. */
  zoom: (stage: Stage, factor: number) => stage.camera.zoom(factor),
  /** @param x, y in CSS pixels */
  pan: (stage: Stage, x: number, y: number) => stage.camera.pan(x, y),
  resetView: (stage: Stage) => stage.camera.reset(),
  /** The plane that maps picture positions to the scene, for page elements that the smoke collides with. */
  plane: (stage: Stage) => stage.sight.plane,
  /** Whether to draw the background; without it, pictures are transparent there. */
  setBackground: (stage: Stage, isShown: boolean) => {
    stage.background = isShown;
  },
  /** Whether the canvas is visible. While it is not, nothing is drawn. A paused stage stays paused. */
  setVisible: (stage: Stage, isVisible: boolean) => {
    stage.visible = isVisible;
  },
};

export type MethodName = keyof typeof calls;

/** A method as its callers see it. */
export type RemoteMethod<Call> = Call extends (stage: never, ...args: infer Given) => infer Result
  ? (...args: Given) => Promise<Awaited<Result>>
  : never;

/**
 * The asynchronous methods of a remote stage, named as in `Stage`. Each rejects with the error that `Stage` would
 * throw, as the same class, and with a SimulatorError after disposal. A stage in a worker or an iframe rejects values
 * outside the ranges given here with a ParameterError.
 */
export type RemoteMethods = { [Name in MethodName]: RemoteMethod<(typeof calls)[Name]> };
