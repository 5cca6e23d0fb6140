import { Vector2, type Camera, type Scene, type WebGLRenderer, NoBlending, type Mesh } from 'three';
import type { FrameInput, FrameReport } from '../smoke/frameInput.ts';
import type { HostPasses } from './hostPasses.ts';
import type { KeyLight } from './keyLight.ts';
import { relight } from './relight.ts';
import { isLinearPicture } from './requirements.ts';
import { RendererState } from './rendererState.ts';

/** Into whose picture smoke is drawn. */
export interface HostView {
  renderer: WebGLRenderer;
  scene: Scene;
  camera: Camera;
  keyLight: KeyLight;
  /** Where the picture begins in its target, pixels. */
  origin: Vector2;
  /** Called before and after the scene is drawn once more in shadow. */
  onRelight: (isInShadow: boolean) => void;
}

/**
 * Smoke in the middle of the host's frame, between the opaque objects and the blended ones:
 * arrange -> the host's depth, which ink asks for -> bodies alone into unlit, lit and depth -> pictures, smoothed
 * -> their depth into the host's -> volumes into the stencil -> lit smoke where that is zero
 * -> the scene without its key light elsewhere -> deep shadow where the stencil counts enough.
 * Unlit smoke follows, as the first of the blended objects.
 */
export function drawIntoHost(passes: HostPasses, view: HostView, input: FrameInput): FrameReport {
  const { smoke, pictures, insert, casters } = passes;
  const { renderer } = view;
  const { body, eye, mask, resolve, surfaceDepth, targets, volumes } = smoke.passes;
  const { style } = input;
  const hasDeep = style.shadows && style.shadowSteps === 2;
  const isLinear = isLinearPicture(renderer);
  const state = new RendererState(renderer);
  state.hold();
  try {
    const report = smoke.arrange(input);
    eye.uniforms.viewportOrigin.value.copy(view.origin);
    surfaceDepth.takeFromHost(renderer, view.origin, new Vector2(input.width, input.height), style.outlines);
    targets.begin(renderer);
    body.draw(renderer);
    pictures.take(renderer, targets, resolve, hasDeep);

    state.returnToTarget();
    renderer.clearStencil();
    insert.setSmoke(pictures, targets.depth, isLinear);
    insert.drawDepth(renderer);
    if (style.shadows) {
      casters.draw(renderer, view.scene);
      mask.countOnce(renderer);
      volumes.draw(renderer);
    }
    insert.drawLit(renderer);
    if (style.shadows) {
      view.onRelight(true);
      relight(renderer, view.scene, view.camera, view.keyLight);
      view.onRelight(false);
    }
    if (hasDeep) insert.drawDeep(renderer, style.shadowDepth, style.deepShadow);
    return report;
  } finally {
    state.restore();
  }
}

/**
 * Lets a mesh that covers the whole view mark where in the host's frame smoke is drawn: among the blended objects, when all
 * that is opaque stands.
 * @param draw draws all but the mesh itself, before it; false where smoke cannot be drawn, which hides the mesh
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
  // Nobody means it when pointing at something.
  mesh.raycast = () => {};
}
