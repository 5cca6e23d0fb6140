import type { Box3, Camera, Matrix4, WebGLRenderTarget } from 'three';
import type { DebugView } from '../parameters/quality.ts';
import type { Arranged } from '../simulator/arranged.ts';
import type { Rows } from '../simulator/rows.ts';
import type { View } from '../simulator/view.ts';
import type { FrameView } from './gpu/frameView.ts';
import type { PuffTextures } from './gpu/puffTextures.ts';
import type { RampTexture } from './gpu/ramps.ts';
import type { AdditionalLight, Light } from './light.ts';
import type { Style } from './style.ts';

/** The part of a simulator that a frame needs. The result may be reused by the next call. */
export interface Arranger {
  /** Number of particles; unknown if absent. */
  readonly alive?: number;
  arrange(view: View): Arranged;
  /** Lamps at the glowing parts of smoke, see `Simulator.glow`; smoke without it has none. */
  glow?(blend: number, colors: Float32Array): Float32Array;
  /** Displacement in the latest step of each row of the last `arrange`, metres: x, y, z. */
  moves(): Float32Array;
}

/** What all passes of one smoke share. */
export interface PassSources {
  readonly eye: FrameView;
  readonly puffs: PuffTextures;
  readonly ramps: RampTexture;
}

/** Everything that one frame is drawn from. */
export interface FrameInput {
  simulator: Arranger;
  camera: Camera;
  light: Light;
  /** Lights of a scene besides it, for a style with `hasAdditionalLights`. The strongest three shade smoke. */
  lights?: readonly AdditionalLight[];
  style: Style;
  /** Interpolation between the previous step (0) and the current one (1). */
  blend: number;
  /** Simulated time in seconds, for boiling lines; defaults to 0. */
  time?: number;
  /** Size of the picture in pixels. `pixelRatio` is the number of pixels per CSS pixel. */
  width: number;
  height: number;
  pixelRatio: number;
  /** World transforms of the rigids, by their index. */
  rigids: readonly Matrix4[];
  /** World transforms of the scene parts, attached to a rigid or not, by their index. */
  parts?: readonly Matrix4[];
  /** How far the triangles of models may deviate from the finest ones, metres; see `deviationFor`. Default: 0. */
  deviation?: number;
  /** What else receives shadow, which is drawn after the frame. */
  others?: OtherReceivers;
  /** Whether to cull puffs and casters that cannot be visible. The picture is the same with and without. */
  cull: boolean;
  /** A debug view instead of the picture. Only the renderer 'nailboards' has views. */
  view?: DebugView;
  /** Whether to omit the backdrop. */
  isTransparent?: boolean;
  /** Render target of the picture, or null for the canvas. */
  output: WebGLRenderTarget | null;
}

/** Receivers of shadow that a frame does not draw. */
export interface OtherReceivers {
  /** World-space boxes that contain them. */
  readonly boxes: readonly Box3[];
  /** Receives all casters, valid until the next call of arrange. */
  captureCasters(casters: Rows): void;
}

/** Statistics of a frame. */
export interface FrameReport {
  bodiesDrawn: number;
  castersDrawn: number;
  /** Time spent in the simulator's arrange, milliseconds. */
  arrangeMs: number;
}
