import { Vector2, type Camera, type Scene, type WebGLRenderer, NoBlending, type Mesh } from 'three';
import { isSimplified } from '../smoke/extraPasses.ts';
import { arrangeFrame, drawBodies, drawStrokes, reportOf, simplifying } from '../smoke/frame.ts';
import type { FrameInput, FrameReport } from '../smoke/frameInput.ts';
import type { ArrangedFrame } from '../smoke/smokePasses.ts';
import type { HostPasses } from './hostPasses.ts';
import { hasStencilBuffer } from './requirements.ts';
import { RendererState } from './rendererState.ts';
import { straightened } from './target/straightCamera.ts';
import { hasDeep, insertLit, insertSmoke, type HostView } from './target/insertion.ts';

/**
 * Draws smoke in the middle of the host's frame, between its opaque and its blended objects:
 * arrange -> read the host's depth (if ink needs it) -> draw bodies into unlit, lit and depth targets -> resolve (antialiasing)
 * -> write their depth to the host's depth buffer -> volumes into the stencil -> lit smoke where the stencil is 0
 * -> elsewhere, the scene without its key light -> deep shadow where the stencil count is high enough.
 * Unlit smoke follows, as the first blended object.
 *
 * Where light is simplified, smoke is resolved once, with its own shadow, and stands for lit and unlit smoke.
 *
 * Without a stencil buffer, the steps after the resolve draw into a target with one; see {@link OwnStencil}. Until its code
 * is loaded, smoke is drawn without shadow.
 */
export function drawIntoHost(passes: HostPasses, view: HostView, asked: FrameInput): FrameReport {
  const { smoke, pictures, depth } = passes;
  const { renderer, scene, camera } = view;
  const { eye, resolve, targets } = smoke.passes;
  const target = renderer.getRenderTarget();
  const hasStencil = hasStencilBuffer(target);
  const own = hasStencil ? undefined : passes.ownStencil.take();
  const state = new RendererState(renderer);
  state.hold();
  try {
    const { camera: straight, oblique } = straightened(asked.camera);
    const input = smoke.prepare({ ...asked, camera: straight });
    const { style } = input;
    const { casters, ...arranged } = arrangeFrame(smoke.passes, input);
    const size = new Vector2(input.width, input.height);
    const origin = own ? new Vector2() : view.origin;
    eye.uniforms.viewportOrigin.value.copy(origin);
    own?.begin(renderer, scene, camera, size, target!.samples);
    const surface = depth.take(renderer, origin, size, own !== undefined || (hasStencil && style.outlines));
    // The depth of an oblique projection is not that of the smoke.
    const touched = style.outlines && !oblique ? surface : undefined;
    targets.begin(renderer, false, isSimplified(style));
    const shading = drawBodies(smoke.passes, style, arranged.bodies, touched);
    drawStrokes(smoke.passes, style, arranged.bodies, touched);
    if (shading) {
      if (casters) drawMask(passes, view, casters);
      pictures.takeShadowed(renderer, targets, resolve, simplifying(smoke.passes, input, shading));
    } else pictures.take(renderer, targets, resolve, hasDeep(style));

    passes.insert.setOblique(oblique && straight.projectionMatrix);
    if (oblique) eye.uniforms.clipFromView.value.copy(oblique);
    const returnToTarget = () => state.returnToTarget();
    if (own) own.insert(passes, { ...view, returnToTarget }, style, casters, surface?.depth);
    else returnToTarget();
    if (hasStencil) insertSmoke(passes, view, style, casters);
    else if (!own) insertLit(passes, view);
    return reportOf({ ...arranged, casters });
  } finally {
    state.restore();
  }
}

/** Draws the shadow on smoke into its targets. */
function drawMask({ smoke, casters }: HostPasses, { renderer, scene }: HostView, { geometry }: Casters): void {
  const { eye, mask, extras } = smoke.passes;
  const { value: origin } = eye.uniforms.viewportOrigin;
  const { x, y } = origin;
  origin.set(0, 0);
  casters.draw(renderer, scene);
  mask.countOnce(renderer);
  extras.countedVolumes!.draw(renderer, geometry);
  mask.draw(renderer);
  origin.set(x, y);
}

type Casters = NonNullable<ArrangedFrame['casters']>;

/**
 * Uses a full-screen mesh to mark the point in the host's frame at which smoke is drawn: among the blended objects,
 * after all opaque ones.
 * @param draw draws everything except the mesh, before it; returns false where smoke cannot be drawn, which hides the
 * mesh
 */
export function markWith(mesh: Mesh, draw: (renderer: WebGLRenderer, scene: Scene, camera: Camera) => boolean): void {
  mesh.onBeforeRender = (renderer, scene, camera) => {
    const isDrawn = draw(renderer, scene, camera);
    mesh.geometry.setDrawRange(0, isDrawn ? 3 : 0);
  };
  mesh.onAfterRender = (renderer) => {
    renderer.clearStencil();
    renderer.state.buffers.stencil.setTest(false);
    renderer.state.setBlending(NoBlending);
  };
  // The marker must not be hit by raycasts.
  mesh.raycast = () => {};
}
