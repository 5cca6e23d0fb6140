import { Vector3, type Texture } from 'three';
import type { ChooseTones } from './passes/resolve.ts';
import type { SurfaceDepth } from './passes/surfaceDepth.ts';
import type { PuffRows } from './gpu/puffRows.ts';
import { STEP_SECONDS } from '../simulator/clock.ts';
import { ALL_PARTICLES } from '../simulator/view.ts';
import { countVolumes, limitOf, type ArrangedFrame, type SmokePasses } from './smokePasses.ts';
import { hasPattern, hasStrokes, isSimplified } from './extraPasses.ts';
import { homogeneous } from './light.ts';
import type { SmokeRenderer } from './smoke.ts';
import type { Style } from './style.ts';
import { eyeView, lightView, shownWithin, smokeBox, viewSources } from './views.ts';
import type { FrameInput, FrameReport } from './frameInput.ts';

/** Animation on twos: lines change at half of 24 frames a second. */
export const DRAWINGS_PER_SECOND = 12;

/**
 * Draws a frame. Until the code that it needs is loaded, it is drawn with lobe nailboards. What the steps write:
 *
 *     arrangeFrame                   bodies, casters: row textures
 *     backdrop, surfaces, creases    unlit, lit, depth
 *     surfaceDepth                   a copy of the depth
 *     body                           unlit, lit, depth
 *     strokes                        opacity of ink, for resolve
 *     meshVolumes, volumes           stencil
 *     mask                           alpha of lit
 *     resolve                        the picture
 * @throws ContextError if the device has lost its context
 */
export function drawFrame(smoke: SmokeRenderer, asked: FrameInput): FrameReport {
  const { passes } = smoke;
  const { renderer, targets } = passes;
  const input = smoke.prepare(asked);
  const { style, view } = input;
  renderer.info.reset();
  const arranged = arrangeFrame(passes, input);

  targets.begin(renderer, passes.scene?.surfaces.isNumbered, isSimplified(style) && !view, hasPattern(style));
  if (passes.hasBackdrop && !input.isTransparent) passes.backdrop.draw(renderer);
  passes.scene?.surfaces.draw(renderer, targets);
  passes.scene?.creases.draw(renderer);
  const surfaceDepth = passes.surfaceDepth.copy(renderer, targets, style.outlines);
  if (style.renderer === 'selle') passes.extras.selle!.draw(renderer, targets, arranged.bodies, style, input.output);
  else if (view) passes.extras.debugViews!.draw(passes, input, arranged, surfaceDepth);
  else drawSmoke(passes, input, arranged, surfaceDepth);
  return reportOf(arranged);
}

/**
 * Draws nailboards with their shadow into the targets, and resolves them.
 * @param drawCasters counts the volumes of other casters in the stencil
 */
export function drawSmoke(
  passes: SmokePasses,
  input: FrameInput,
  { bodies, casters }: ArrangedFrame,
  surfaceDepth: SurfaceDepth | undefined,
  drawCasters?: () => void,
): void {
  const { renderer, targets, mask } = passes;
  const { style, output } = input;
  const shading = drawBodies(passes, style, bodies, surfaceDepth);
  drawStrokes(passes, style, bodies, surfaceDepth);
  if (casters) {
    drawCasters?.();
    countVolumes(passes, style, casters.geometry, limitOf(style));
    mask.draw(renderer);
  }
  passes.resolve.draw(renderer, targets, output, shading && simplifying(passes, input, shading));
}

/** Draws puffs into the targets, and returns their shading if the light of the style is simplified. */
function drawBodies(
  { renderer, targets, body }: SmokePasses,
  style: Style,
  { geometry }: PuffRows,
  surfaceDepth?: SurfaceDepth,
): Texture | undefined {
  const isShaded = isSimplified(style);
  if (isShaded) targets.beginShading(renderer);
  body.draw(renderer, geometry, surfaceDepth, isShaded);
  return isShaded ? targets.endShading(renderer) : undefined;
}

/** Chooses tones by simplified light, after the mask is drawn. */
function simplifying(
  { renderer, targets, extras }: SmokePasses,
  { simulator, blend, style }: FrameInput,
  shading: Texture,
): ChooseTones {
  const all = style.plumeForm > 0 ? simulator.arrange({ ...ALL_PARTICLES, blend }).rows : undefined;
  return (output) => extras.simplify!.draw(renderer, targets, shading, output, all);
}

/** Draws the strokes of the drawn bodies, if the style has any. */
function drawStrokes(passes: SmokePasses, style: Style, bodies: PuffRows, surfaceDepth?: SurfaceDepth): void {
  if (!hasStrokes(style)) return;
  const { renderer, targets, body, extras } = passes;
  extras.strokes!.draw(renderer, targets, bodies.geometry.rows, body.drawing, surfaceDepth);
}

/**
 * The first half of a frame, without draw calls: arrange(eye) and arrange(light) -> row textures.
 * @param input as `SmokeRenderer.prepare` returns it
 */
export function arrangeFrame(passes: SmokePasses, input: FrameInput): ArrangedFrame {
  const { eye, bodies, casters } = passes;
  const { simulator, style } = input;
  setUpView(passes, input);
  const sources = viewSources(passes, input);

  const started = performance.now();
  const seen = simulator.arrange(eyeView(sources, input));
  bodies.fill(seen.rows);
  // Copied, because the next call of arrange replaces it.
  const grid = input.view === 'coverage' && seen.grid ? { ...seen.grid, depths: seen.grid.depths.slice() } : undefined;
  const smoke = smokeBox(eye, sources.extents.spread, seen.bounds);
  passes.additionalLights?.look(input, smoke, eye.uniforms.viewFromWorld.value);
  const travel = eye.travelAt(smoke.getCenter(new Vector3()));
  const receivers = sources.boxes.reduce((all, box) => all.union(box), smoke.clone());
  eye.receive(input.others ? smoke : receivers);
  const throwsShadow = style.shadows && style.renderer === 'nailboards';
  if (throwsShadow) {
    const { rows } = simulator.arrange(lightView(sources, input, receivers, travel));
    input.others?.captureCasters(rows);
    const { reach } = sources.extents;
    const shown = { bodies: bodies.places, reach: shownWithin(reach, eye), boxes: input.others ? [] : sources.boxes };
    casters.fill(rows, passes.findShadowEnds(rows, reach, shown, travel, eye.lamp));
  }
  const arrangeMs = performance.now() - started;
  return { bodies, casters: throwsShadow ? casters : undefined, grid, arrangeMs };
}

/** Statistics of an arranged frame. */
export function reportOf({ bodies, casters, arrangeMs }: ArrangedFrame): FrameReport {
  return { bodiesDrawn: bodies.count, castersDrawn: casters?.count ?? 0, arrangeMs };
}

/** Sets what the arrangement and all passes read of the frame: size, camera, light, places of the surfaces and time. */
function setUpView(passes: SmokePasses, input: FrameInput) {
  const { camera, light, width, height, rigids, parts, blend, time = 0, deviation } = input;
  passes.targets.resize(width, height);
  const reversedDepth = passes.renderer.state.buffers.depth.getReversed();
  passes.eye.look(camera, homogeneous(light), width, height, reversedDepth);
  if (light.kind === 'lamp') passes.lampLight?.look(light.place, light.falloff);
  passes.scene?.place(rigids, parts ?? [], Math.max(0, time + (blend - 1) * STEP_SECONDS));
  passes.scene?.refine(deviation ?? 0);
  passes.body.setDrawing(Math.floor(time * DRAWINGS_PER_SECOND));
}
