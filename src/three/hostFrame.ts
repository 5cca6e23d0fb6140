import { Vector2, type Camera, type Scene, type WebGLRenderer, NoBlending, type Mesh } from 'three';
import { arrangeFrame, drawStrokes, reportOf } from '../smoke/frame.ts';
import type { FrameInput, FrameReport } from '../smoke/frameInput.ts';
import type { HostPasses } from './hostPasses.ts';
import type { KeyLight } from './keyLight.ts';
import { relight } from './relight.ts';
import { isLinearPicture } from './requirements.ts';
import { RendererState } from './rendererState.ts';

/** The host's view that smoke is drawn into. */
export interface HostView {
  renderer: WebGLRenderer;
  scene: Scene;
  camera: Camera;
  keyLight: KeyLight;
  /** Origin of the viewport in its render target, in pixels. */
  origin: Vector2;
  /** Called before and after the scene is drawn again in shadow. */
  onRelight: (isInShadow: boolean) => void;
}

/**
 * Draws smoke in the middle of the host's frame, between its opaque and its blended objects:
 * arrange -> read the host's depth (if ink needs it) -> draw bodies into unlit, lit and depth targets -> resolve (antialiasing)
 * -> write their depth to the host's depth buffer -> volumes into the stencil -> lit smoke where the stencil is 0
 * -> elsewhere, the scene without its key light -> deep shadow where the stencil count is high enough.
 * Unlit smoke follows, as the first blended object.
 */
export function drawIntoHost(passes: HostPasses, view: HostView, input: FrameInput): FrameReport {
  const { smoke, pictures, insert, depth } = passes;
  const { renderer } = view;
  const { body, eye, mask, resolve, targets, extras } = smoke.passes;
  const { style } = input;
  const hasDeep = style.shadows && style.shadowSteps === 2;
  const isLinear = isLinearPicture(renderer);
  const state = new RendererState(renderer);
  state.hold();
  try {
    const arranged = arrangeFrame(smoke.passes, smoke.prepare(input));
    const { bodies, casters } = arranged;
    const size = new Vector2(input.width, input.height);
    eye.uniforms.viewportOrigin.value.copy(view.origin);
    const hostDepth = depth.take(renderer, view.origin, size, style.outlines);
    targets.begin(renderer);
    body.draw(renderer, bodies.geometry, hostDepth);
    drawStrokes(smoke.passes, style, bodies, hostDepth);
    pictures.take(renderer, targets, resolve, hasDeep);

    state.returnToTarget();
    renderer.clearStencil();
    insert.setSmoke(pictures, targets.depth, isLinear);
    insert.drawDepth(renderer);
    if (casters) {
      passes.casters.draw(renderer, view.scene);
      mask.countOnce(renderer);
      extras.countedVolumes?.draw(renderer, casters.geometry);
    }
    insert.drawLit(renderer);
    if (casters) {
      view.onRelight(true);
      relight(renderer, view.scene, view.camera, view.keyLight);
      view.onRelight(false);
    }
    if (hasDeep) insert.drawDeep(renderer, style.shadowDepth, style.deepShadow);
    return reportOf(arranged);
  } finally {
    state.restore();
  }
}

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
