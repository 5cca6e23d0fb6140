import { Box3, Vector3, type Camera, type Matrix4, type WebGLRenderTarget } from 'three';
import type { DebugView } from '../preset/quality.ts';
import type { Rows } from '../sim/rows.ts';
import type { Bounds } from '../sim/simulator.ts';
import type { CoverageGrid, View } from '../sim/view.ts';
import { homogeneous, type Light } from './light.ts';
import type { SmokePasses } from './smoke.ts';
import { THROWS_SHADOW, type Style } from './style.ts';
import { eyeView, lightView, shownWithin, smokeBox } from './views.ts';

/** Film is drawn on twos: lines boil at half of 24 frames a second. */
const DRAWINGS_PER_SECOND = 12;

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

/**
 * The whole frame, in order:
 * arrange(eye) and arrange(light) -> instance buffers -> backdrop, surfaces, bodies into unlit, lit and depth
 * -> volumes into the stencil -> mask into the alpha of lit -> resolve to the picture.
 */
export function drawFrame(passes: SmokePasses, input: FrameInput): FrameReport {
  const { renderer, targets } = passes;
  const report = arrangeFrame(passes, input);

  targets.begin(renderer);
  if (passes.hasBackdrop && !input.isTransparent) passes.backdrop.draw(renderer);
  passes.surfaces.draw(renderer);
  passes.creases.draw(renderer);
  passes.surfaceDepth.draw(renderer, targets, input.style.outlines);
  if (input.style.renderer !== 'nailboards') passes.extras.comparisons!.draw(input.style.renderer, passes, input);
  else if (input.view) passes.extras.debugViews!.draw(input.view, passes, input);
  else drawNailboards(passes, input);
  return report;
}

/** Bodies, volumes, mask, resolve. */
function drawNailboards(passes: SmokePasses, { style, output }: FrameInput): void {
  const { renderer, targets } = passes;
  passes.body.draw(renderer);
  if (style.shadows) {
    passes.meshVolumes.draw(renderer);
    passes.mask.countOnce(renderer);
    (passes.prismVolumes ?? passes.volumes).draw(renderer);
    passes.mask.draw(renderer);
  }
  passes.resolve.draw(renderer, targets, output);
}

/** The first half of a frame, which draws nothing: arrange(eye) and arrange(light) -> instance buffers. */
export function arrangeFrame(passes: SmokePasses, input: FrameInput): FrameReport {
  const { eye, targets, bodies, casters } = passes;
  const { style } = input;
  targets.resize(input.width, input.height);
  const reversedDepth = passes.renderer.state.buffers.depth.getReversed();
  eye.look(input.camera, homogeneous(input.light), input.width, input.height, reversedDepth);
  passes.placeSurfaces(input.rigids, input.parts ?? []);
  passes.body.setBoil(style.boil, Math.floor((input.time ?? 0) * DRAWINGS_PER_SECOND));

  const started = performance.now();
  bodies.fill(input.simulator.arrange(eyeView(passes, input)));
  if (input.view === 'coverage') passes.extras.debugViews!.setGrid(input.simulator.coverageGrid);
  const receivers = receiversOf(passes, input);
  eye.receive(receivers);
  const throwsShadow = style.shadows && THROWS_SHADOW[style.renderer];
  if (throwsShadow) {
    casters.fill(input.simulator.arrange(lightView(passes, input, receivers)));
    if (eye.isLitBySun) casters.shorten((ends) => endShadows(passes, input, ends));
  }
  const arrangeMs = performance.now() - started;
  return { bodiesDrawn: bodies.count, castersDrawn: throwsShadow ? casters.count : 0, arrangeMs };
}

/** Where each shadow of the sun has all behind it that it could fall on. Those of a lamp end at the box of all receivers. */
function endShadows({ eye, casters, bodies, surfaces, ...passes }: SmokePasses, input: FrameInput, ends: Float32Array) {
  const { reach } = passes.extentsOf(input.style.form);
  const boxes = surfaces.worldBoxes();
  if (input.receivers) boxes.push(input.receivers);
  const receivers = { bodies: bodies.places, reach: shownWithin(reach, eye), boxes };
  passes.shadowEnds.find(casters.places, reach, receivers, eye.travelAt(new Vector3()), ends);
}

/** Everything that can receive a shadow: the surfaces, and the smoke as arrange(eye) has just measured it. */
function receiversOf(passes: SmokePasses, { simulator, receivers }: FrameInput): Box3 {
  const box = passes.surfaces.bounds(new Box3());
  if (receivers) box.union(receivers);
  box.union(smokeBox(passes, simulator.bounds));
  return box;
}
