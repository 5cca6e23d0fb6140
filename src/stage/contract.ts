import type { Device, DeviceOptions } from '../renderer/gpu/device.ts';
import type { Fault } from '../renderer/gpu/faults.ts';
import type { DebugView, Quality } from '../parameters/quality.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import type { Vector } from '../scenes/scene.ts';
import type { VectorComponents } from '../simulator/emitterOptions.ts';
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

/** The place of a model and what it does. */
export interface ModelOptions {
  /** The middle of its underside, metres. Default: the middle of the model is at the target of the scene's camera. */
  position?: VectorComponents;
  /** Its longest side in its first pose, metres, 0.01 to 100. Default: 0.3 of the height of the picture. */
  size?: number;
  /** Rotation about the vertical axis, radians, -100 to 100. Default: 0. */
  turn?: number;
  /** Name of the animation that plays, one of `Model.animations`. Default: the first. An empty name: none. */
  animation?: string;
  /** Seconds of the animation per simulated second, 0 to 10. Default: 1. The animation repeats. */
  speed?: number;
  /** Whether smoke and objects collide with it. Default: true. */
  collides?: boolean;
  /** Whether it casts shadow. Default: true. */
  casts?: boolean;
  /** Whether it has outlines. Default: true. */
  inked?: boolean;
}

/** A part of a model that emitters and forces can ride on: nodes and bones that move together. */
export interface ModelNode {
  /** The name in the file of the first of its nodes, or `node` with its index. */
  readonly name: string;
  /** The index that `emitters.#.rigid` takes, 4096 or more. */
  readonly rigid: number;
  /** The index that `emitters.#.surface` takes, for emitters with the shape `surface`; -1 without a surface. */
  readonly surface: number;
}

/** What a model file contains. */
export interface Model {
  readonly triangles: number;
  readonly materials: number;
  /** Sides of its box in its first pose, metres. */
  readonly box: Vector;
  /** At most 64, with the parts of the scene. Deeper bones of larger skeletons belong to the bones that carry them. */
  readonly nodes: readonly ModelNode[];
  /** In the order of the file. Names are unique. */
  readonly animations: readonly { readonly name: string; readonly seconds: number }[];
  /** Sentences about what the file has and the model lacks, such as a texture of another file. */
  readonly notices: readonly string[];
}

/** A place on the surface of a model, in the space of one of its nodes. */
export interface ModelPoint {
  /** The node that carries the place; on a skin, the bone that moves it most. */
  readonly node: ModelNode;
  /** For `emitters.#.position.*`, metres. */
  readonly position: Vector;
  /** Unit vector away from the surface, for `emitters.#.direction.*`. */
  readonly direction: Vector;
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
