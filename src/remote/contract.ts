import type { Values } from '../preset/parameter.ts';
import type { BlowInput } from '../stage/blow.ts';
import type { PointerInput, StageEvents, StageOptions, StageStats, StatsOptions } from '../stage/contract.ts';
import type { ScenePlane } from '../stage/sight.ts';
import type { Take } from '../stage/take.ts';

/** Where a stage runs: on the main thread, in a worker, or in a page inside an iframe. */
export type Thread = 'main' | 'worker' | 'frame';

/**
 * The asynchronous methods of a remote stage, named as in `Stage`. Each rejects with the error that `Stage` would
 * throw, as the same class, and with a SimulatorError after disposal. A stage in a worker or an iframe rejects values
 * outside the ranges given here with a ParameterError.
 */
export interface RemoteMethods {
  play(): Promise<void>;
  pause(): Promise<void>;
  /** @param n an integer of at least 0. Default: 1. At most 36,000 in a worker or an iframe */
  step(n?: number): Promise<void>;
  /** @param seconds simulated time, at least 0; at most 600 in a worker or an iframe */
  seek(seconds: number): Promise<void>;
  /** @param seconds simulated time, at least 0; at most 600 in a worker or an iframe */
  advance(seconds: number): Promise<void>;
  /** Removes all puffs; emitters and values stay. */
  clear(): Promise<void>;
  restart(): Promise<void>;
  /** Loads another scene, or restarts the current one. Omitted values get their defaults. */
  enter(values: Values): Promise<void>;
  set(values: Values): Promise<void>;
  unset(keys: readonly string[]): Promise<void>;
  get(): Promise<Values>;
  /** A PNG at full resolution, also while the canvas is not visible. */
  picture(): Promise<Blob>;
  save(): Promise<Uint8Array>;
  restore(bytes: Uint8Array): Promise<void>;
  take(): Promise<Take>;
  /** Reads the metadata of a take without playing it. */
  readTake(bytes: Uint8Array): Promise<Take>;
  /** @param take the result of `take()`, or its bytes */
  playTake(take: Take | Uint8Array): Promise<void>;
  /** 16 hexadecimal digits. */
  hash(): Promise<string>;
  stats(options?: StatsOptions): Promise<StageStats>;
  /** @param width, height in CSS pixels, at most 65,536 */
  resize(width: number, height: number, pixelRatio?: number): Promise<void>;
  pointer(input: PointerInput): Promise<'rigid' | null>;
  blow(input: BlowInput): Promise<void>;
  steer(channel: number, value: number): Promise<void>;
  /**
   * Drops a ball or a crate at a position in the picture, in CSS pixels. Resolves to false if the scene has no objects
   * to drop.
   */
  drop(x: number, y: number): Promise<boolean>;
  /** Moves the target of the movable rigid, in metres. */
  nudge(by: { dx?: number; dy?: number; dz?: number }): Promise<void>;
  /** Rotates the camera about its target, in radians. */
  orbit(azimuth: number, elevation: number): Promise<void>;
  /** A factor above 1 moves the camera closer. */
  zoom(factor: number): Promise<void>;
  /** @param x, y in CSS pixels */
  pan(x: number, y: number): Promise<void>;
  resetView(): Promise<void>;
  /** The plane that maps picture positions to the scene, for page elements that the smoke collides with. */
  plane(): Promise<ScenePlane>;
  /** Whether to draw the background; without it, pictures are transparent there. */
  setBackground(isShown: boolean): Promise<void>;
  /** Whether the canvas is visible. While it is not, nothing is drawn. A paused stage stays paused. */
  setVisible(isVisible: boolean): Promise<void>;
}

/** A stage that may run on another thread or in another page. */
export interface RemoteStage extends RemoteMethods {
  /** Resolves when the first picture is drawn. */
  readonly ready: Promise<void>;
  readonly thread: Thread;
  /**
   * Adds an event listener. Events without a listener are not sent: only a 'frame' listener causes a message per frame.
   * @returns a function that removes the listener
   */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void;
  /** Releases all resources. Can be called more than once, and while calls are pending. */
  dispose(): Promise<void>;
}

export interface RemoteStageOptions extends Omit<StageOptions, 'device' | 'failsSelfTest' | 'frameRate' | 'onStep'> {
  /**
   * Where to run. Default: 'auto', a worker if the browser supports it and the page allows it, otherwise the main
   * thread.
   */
  thread?: 'auto' | 'main' | 'worker';
  /** Maximum frames per second while playing. Default: 60. */
  frameRate?: number;
  /** @internal Milliseconds that the worker stays after its last stage. */
  graceMs?: number;
  /** Aborts the start. The promise then rejects with the signal's reason, and all resources are released. */
  signal?: AbortSignal;
}
