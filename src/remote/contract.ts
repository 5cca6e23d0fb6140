import type { Values } from '../preset/parameter.ts';
import type { BlowInput } from '../stage/blow.ts';
import type { PointerInput, StageEvents, StageOptions, StageStats } from '../stage/contract.ts';
import type { ScenePlane } from '../stage/sight.ts';
import type { Take } from '../stage/take.ts';

/** Where a stage runs: on the page's own thread, in a worker, or in a page inside a frame. */
export type Thread = 'main' | 'worker' | 'frame';

/**
 * What can be asked of a stage from elsewhere: the names of `Stage`, all promises. Each rejects with the error that the
 * stage itself would throw, as the same class, and with a SimulatorError after disposal. What is out of the ranges that stand
 * here is refused with a ParameterError where a message asks for it: by a stage in a worker or in a frame.
 */
export interface RemoteMethods {
  play(): Promise<void>;
  pause(): Promise<void>;
  /** @param n a whole number of steps from 0, 1 when left out; at most 36,000 in a worker or a frame */
  step(n?: number): Promise<void>;
  /** @param seconds of simulated time from 0; at most 600 in a worker or a frame */
  seek(seconds: number): Promise<void>;
  /** @param seconds of simulated time from 0; at most 600 in a worker or a frame */
  advance(seconds: number): Promise<void>;
  restart(): Promise<void>;
  /** Goes to another scene, or begins anew in this one; what is left out gets the defaults of the table. */
  enter(values: Values): Promise<void>;
  set(values: Values): Promise<void>;
  unset(keys: readonly string[]): Promise<void>;
  get(): Promise<Values>;
  /** A PNG of all pixels, also while nobody can see the stage. */
  picture(): Promise<Blob>;
  save(): Promise<Uint8Array>;
  restore(bytes: Uint8Array): Promise<void>;
  take(): Promise<Take>;
  /** What a take says of itself, without playing it. */
  readTake(bytes: Uint8Array): Promise<Take>;
  /** @param take as `take()` gave it, or its bytes */
  playTake(take: Take | Uint8Array): Promise<void>;
  /** 16 hexadecimal digits. */
  hash(): Promise<string>;
  stats(): Promise<StageStats>;
  /** @param width, height in CSS pixels, at most 65,536 */
  resize(width: number, height: number, pixelRatio?: number): Promise<void>;
  pointer(input: PointerInput): Promise<'rigid' | null>;
  blow(input: BlowInput): Promise<void>;
  steer(channel: number, value: number): Promise<void>;
  /** Drops a ball or a crate at a place of the picture, CSS pixels; whether there was one. */
  drop(x: number, y: number): Promise<boolean>;
  /** Moves the rigid that people can move, by metres. */
  nudge(by: { dx?: number; dy?: number; dz?: number }): Promise<void>;
  /** Turns the eye about what it looks at, by radians. */
  orbit(azimuth: number, elevation: number): Promise<void>;
  /** Comes nearer by a factor above 1. */
  zoom(factor: number): Promise<void>;
  /** @param x, y in CSS pixels */
  pan(x: number, y: number): Promise<void>;
  resetView(): Promise<void>;
  /** Where places of the picture are in the scene: for things of the page that smoke shall meet. */
  plane(): Promise<ScenePlane>;
  /** Whether pictures show what lies behind everything; they are transparent there if not. */
  setBackground(isShown: boolean): Promise<void>;
  /** Whether anybody can see the canvas: while nobody can, nothing is drawn. What is paused stays paused. */
  setVisible(isVisible: boolean): Promise<void>;
}

/** A stage that may run elsewhere. */
export interface RemoteStage extends RemoteMethods {
  /** Settled when the first picture stands. */
  readonly ready: Promise<void>;
  readonly thread: Thread;
  /**
   * Calls back on an event; returns the function that ends it. What nobody listens to is not sent: only who listens to
   * 'frame' has a message a frame.
   */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void;
  /** Gives everything back. May be called again, and while something else is still on its way. */
  dispose(): Promise<void>;
}

export interface RemoteStageOptions extends Omit<StageOptions, 'device' | 'failsSelfTest' | 'frameRate' | 'onStep'> {
  /** Where it shall run: in a worker where the browser can and the page allows it, else on this thread, by default. */
  thread?: 'auto' | 'main' | 'worker';
  /** Most frames a second while playing; 60 when left out. */
  frameRate?: number;
  /** Aborting ends the start; the promise then rejects with the signal's reason, and everything is given back. */
  signal?: AbortSignal;
}
