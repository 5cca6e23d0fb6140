import type { Device, DeviceOptions } from '../device/device.ts';
import type { Fault } from '../device/faults.ts';
import type { DebugView, Quality } from '../preset/quality.ts';
import type { Values } from '../preset/parameter.ts';
import type { LoadProgress } from '../sim/load.ts';

export interface StageOptions extends DeviceOptions {
  /** Flat values that differ from the defaults of the table. */
  values?: Values;
  /** A device to share; without it the stage takes a WebGL2 context of its own on the canvas. */
  device?: Device;
  /** Size of the canvas in CSS pixels and how many pixels make one; the canvas's own size where absent. */
  width?: number;
  height?: number;
  pixelRatio?: number;
  /**
   * Share of the pixel ratio that is drawn, 0.25 to 1, or 'auto': fewer pixels while playing where frames come late.
   * Always 1 when left out. A picture() is drawn with all pixels.
   */
  quality?: Quality;
  /** Most frames a second while playing; as many as the screen shows when left out. */
  frameRate?: number;
  /** Whether anybody can see the canvas, see `Stage.visible`; true when left out. */
  visible?: boolean;
  /** What is shown instead of the picture, to see what the passes work with. */
  view?: DebugView;
  /** Whether pictures show what lies behind everything; true when left out. Without it they are transparent there. */
  background?: boolean;
  /** Most bytes of states that are kept so that seeking backwards is quick, one a second; 64 MiB when left out. */
  historyBytes?: number;
  /** Called with how much of what must be fetched has come. */
  onProgress?: (progress: LoadProgress) => void;
  /** Called after each step of the simulator, also amid many that were asked for at once. */
  onStep?: () => void;
  /** What goes wrong in the start, to try how an application copes. What is built does not heed it. */
  fault?: Fault;
}

/** What a stage is doing; figures of the latest frame. */
export interface StageStats {
  /** Simulated seconds. */
  time: number;
  steps: number;
  alive: number;
  /** Particles that wait for room to be born. */
  waiting: number;
  /** What people did since the take began, and whether it was more than a take has room for. */
  inputs: number;
  isTruncated: boolean;
  /** Bytes of the states that are kept for going back. */
  historyBytes: number;
  bodiesDrawn: number;
  castersDrawn: number;
  bodiesTotal: number;
  castersTotal: number;
  simMs: number;
  arrangeMs: number;
  renderMs: number;
  drawCalls: number;
  /** False where the GPU does not keep the depth that fragments write: puffs are flat there and meet in straight lines. */
  writesDepth: boolean;
  /** Share of the pixel ratio that the latest frame was drawn with. */
  scale: number;
}

export interface EnterOptions {
  /** Called with how much of what must be fetched has come. */
  onProgress?: (progress: LoadProgress) => void;
}

export interface SeekOptions {
  /** Called with how far the seek has come, 0 to 1. */
  onProgress?: (share: number) => void;
  /** Aborting stops the seek where it is; the promise then rejects with the signal's reason. */
  signal?: AbortSignal;
}

/** A pointer as plain data, in CSS pixels from the top left of the canvas. */
export interface PointerInput {
  type: 'down' | 'move' | 'up' | 'cancel';
  id: number;
  x: number;
  y: number;
}

export interface StageEvents {
  /** Playing began or ended, or values or the view changed. */
  statechange: { playing: boolean };
  /** Something stopped the stage; it says what. A LoadError stops nothing: what could not be had is left out. */
  error: Error;
  /** A frame was drawn. */
  frame: StageStats;
}
