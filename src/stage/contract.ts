import type { Device, DeviceOptions } from '../renderer/gpu/device.ts';
import type { Fault } from '../renderer/gpu/faults.ts';
import type { DebugView, Quality } from '../parameters/quality.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import type { LoadProgress } from '../simulator/load.ts';
import type { Turns } from './frameLoop.ts';
import type { StageStats } from './stats.ts';

export interface StageOptions extends DeviceOptions {
  /** Flat values that differ from the parameter defaults. */
  values?: GivenValues;
  /** A shared device. Default: the stage creates its own WebGL2 context on the canvas. */
  device?: Device;
  /**
   * Size of the canvas in CSS pixels, and device pixels per CSS pixel. Default: the canvas's own size, and a ratio of
   * 1.
   */
  width?: number;
  height?: number;
  pixelRatio?: number;
  /**
   * Fraction of the pixel ratio to draw with, 0.25 to 1, or 'auto' to draw fewer pixels while playing when frames
   * arrive late. Default: 1. `picture()` always uses 1.
   */
  quality?: Quality;
  /** Maximum frames per second while playing. Default: the display's refresh rate. */
  frameRate?: number;
  /** Whether the canvas is visible to the user, see `Stage.visible`. Default: true. */
  visible?: boolean;
  /** A debug view to show instead of the picture: the data of a render pass. */
  view?: DebugView;
  /** Whether to draw the background. Default: true. Without it, pictures are transparent there. */
  background?: boolean;
  /**
   * Memory budget in bytes for saved states, which make seeking backwards fast; one state per second. Default: 64 MiB.
   */
  historyBytes?: number;
  /** Called with the download progress. */
  onProgress?: (progress: LoadProgress) => void;
  /** Called after each simulator step, including each step of a batch. */
  onStep?: () => void;
  /** @internal Which frames are drawn while playing. Default: all. */
  turns?: Turns;
  /** @internal A fault to inject at startup, for testing error handling. Ignored in production builds. */
  fault?: Fault;
}

/** Names of the options that all kinds of stages have. */
export const STAGE_OPTIONS: readonly string[] =
  'values width height pixelRatio quality frameRate visible view background historyBytes onProgress fault'.split(' ');

export interface EnterOptions {
  /** Called with the download progress. */
  onProgress?: (progress: LoadProgress) => void;
}

export interface SeekOptions {
  /** Called with the fraction of the seek that is done, 0 to 1. */
  onProgress?: (share: number) => void;
  /** Aborts the seek at the step it has reached. The promise then rejects with the signal's reason. */
  signal?: AbortSignal;
}

/** A pointer event as plain data, in CSS pixels from the top left of the canvas. */
export interface PointerInput {
  type: 'down' | 'move' | 'up' | 'cancel';
  id: number;
  x: number;
  y: number;
}

export interface StageEvents {
  /** Playback started or stopped, or values or the view changed. */
  statechange: { playing: boolean };
  /** An error stopped the stage. A LoadError does not stop it: the stage continues without the missing code. */
  error: Error;
  /** A frame was drawn. */
  frame: StageStats;
}
