import { NoBlending, type Camera, type Mesh, type Scene, type WebGLRenderer } from 'three';

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
