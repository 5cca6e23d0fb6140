import type { Box3, Camera, Matrix4, WebGLRenderTarget } from 'three';
import type { DebugView } from '../preset/quality.ts';
import type { Rows } from '../sim/rows.ts';
import type { Bounds } from '../sim/simulator.ts';
import type { CoverageGrid, View } from '../sim/view.ts';
import type { Light } from './light.ts';
import type { Style } from './style.ts';

/** The part of a simulator that a frame needs: rows for a view, and the box of what lives. */
export interface Arranger {
  arrange(view: View): Rows;
  readonly bounds: Bounds;
  /** Of the last arrange. */
  readonly coverageGrid?: CoverageGrid;
}

/** What one frame is drawn from. */
export interface FrameInput {
  simulator: Arranger;
  camera: Camera;
  light: Light;
  style: Style;
  /** Where between the previous step (0) and now (1) the picture stands. */
  blend: number;
  /** Simulated seconds, by which lines boil; 0 where absent. */
  time?: number;
  /** Size of the picture in pixels, and how many of them make a CSS pixel. */
  width: number;
  height: number;
  pixelRatio: number;
  /** World transforms of the rigids, by their number. */
  rigids: readonly Matrix4[];
  /** World transforms of the parts that ride on them or on nothing, by their number. */
  parts?: readonly Matrix4[];
  /** What else can receive a shadow besides surfaces and smoke, world space. */
  receivers?: Box3;
  /** Leaves out bodies and casters that cannot show; the picture is the same either way. */
  cull: boolean;
  /** What is shown instead of the picture, if anything; other renderers than nailboards have no views. */
  view?: DebugView;
  /** Leaves out what lies behind everything. */
  isTransparent?: boolean;
  /** Where the picture goes; null is the canvas. */
  output: WebGLRenderTarget | null;
}

/** What a frame did. */
export interface FrameReport {
  bodiesDrawn: number;
  castersDrawn: number;
  /** Milliseconds spent in the simulator's arrange. */
  arrangeMs: number;
}
