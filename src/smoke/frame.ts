import { Box3, Vector3 } from 'three';
import { homogeneous } from './light.ts';
import type { SmokePasses } from './smokePasses.ts';
import { THROWS_SHADOW, type Style } from './style.ts';
import { eyeView, lightView, shownWithin, smokeBox } from './views.ts';
import type { FrameInput, FrameReport } from './frameInput.ts';

/** Largest count of the stencil buffer. */
export const MAX_COUNT = 255;
/** Animation on twos: lines change at half of 24 frames a second. */
const DRAWINGS_PER_SECOND = 12;

/**
 * Draws a frame, in this order:
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

function drawNailboards(passes: SmokePasses, { style, output }: FrameInput): void {
  const { renderer, targets } = passes;
  passes.body.draw(renderer);
  if (style.shadows) {
    countVolumes(passes, style, style.shadowSteps === 2 ? Math.min(style.shadowDepth, MAX_COUNT) : 1);
    passes.mask.draw(renderer);
  }
  passes.resolve.draw(renderer, targets, output);
}

/**
 * Counts the shadow volumes that contain the place at each pixel, in the stencil buffer.
 * @param limit count from which on more volumes make no difference, 1..MAX_COUNT
 */
export function countVolumes(passes: SmokePasses, { volumes }: Style, limit: number): void {
  const { renderer, targets, extras } = passes;
  passes.meshVolumes.draw(renderer);
  passes.mask.countOnce(renderer);
  // Counting needs the depth that fragments write.
  if (volumes === 'counted' && !passes.isFlat) extras.countedVolumes!.draw(renderer);
  else passes.volumes.draw(renderer, targets.copyDepth(renderer), limit);
}

/** The first half of a frame, without draw calls: arrange(eye) and arrange(light) -> instance buffers. */
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

/**
 * Computes where each shadow of the sun is behind all receivers. The shadows of a lamp end at the box of all receivers.
 */
function endShadows({ eye, casters, bodies, surfaces, ...passes }: SmokePasses, input: FrameInput, ends: Float32Array) {
  const { reach } = passes.extentsOf(input.style.form);
  const boxes = surfaces.worldBoxes();
  if (input.receivers) boxes.push(input.receivers);
  const receivers = { bodies: bodies.places, reach: shownWithin(reach, eye), boxes };
  passes.shadowEnds.find(casters.places, reach, receivers, eye.travelAt(new Vector3()), ends);
}

/** The box of everything that can receive a shadow: the surfaces, and the smoke as measured by arrange(eye). */
function receiversOf(passes: SmokePasses, { simulator, receivers }: FrameInput): Box3 {
  const box = passes.surfaces.bounds(new Box3());
  if (receivers) box.union(receivers);
  box.union(smokeBox(passes, simulator.bounds));
  return box;
}
