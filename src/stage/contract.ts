import type { Device, DeviceOptions } from '../renderer/gpu/device.ts';
import type { Fault } from '../renderer/gpu/faults.ts';
import type { DebugView, Quality } from '../parameters/quality.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import type { LoadProgress } from '../simulator/load.ts';
import type { Turns } from './frameLoop.ts';

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

/** A blow at a position in the picture, or a sweep across it. Lengths are in CSS pixels, y points down. */
export interface BlowInput {
  x: number;
  y: number;
  /** Pointer movement since the last blow, 1/60 s earlier; 0 blows away from the camera. */
  dx?: number;
  dy?: number;
  /** Radius of the gust around the pointer. Default: 56. */
  radius?: number;
  /** Duration of the gust, 1/60 to 10 s. Default: 0.4. */
  seconds?: number;
}

/** Statistics of the latest frame. */
export interface StageStats {
  /** Simulated seconds. */
  time: number;
  steps: number;
  alive: number;
  /** Particles that cannot be emitted until others die. */
  waiting: number;
  /** Number of inputs since the take started, and whether they exceed what a take can record. */
  inputs: number;
  isTruncated: boolean;
  /** Bytes of the states saved for seeking backwards. */
  historyBytes: number;
  bodiesDrawn: number;
  castersDrawn: number;
  bodiesTotal: number;
  castersTotal: number;
  simMs: number;
  arrangeMs: number;
  renderMs: number;
  drawCalls: number;
  /**
   * False where the GPU does not store the depth that fragments write. Puffs are then flat and intersect in straight
   * lines.
   */
  writesDepth: boolean;
  /** Fraction of the pixel ratio that the latest frame was drawn with. */
  scale: number;
  /**
   * Milliseconds that the GPU took for a recent frame. Missing until it is measured (see `Stage.timeGpu`), and
   * where the browser lacks EXT_disjoint_timer_query_webgl2.
   */
  gpuMs?: number;
}

export interface StatsOptions {
  /** Whether to measure `gpuMs` in the frames until the next call. Default: false. */
  gpu?: boolean;
}

export interface StageEvents {
  /** Playback started or stopped, or values or the view changed. */
  statechange: { playing: boolean };
  /** An error stopped the stage. A LoadError does not stop it: the stage continues without the missing code. */
  error: Error;
  /** A frame was drawn. */
  frame: StageStats;
}
