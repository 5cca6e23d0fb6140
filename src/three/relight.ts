import {
  KeepStencilOp,
  NotEqualStencilFunc,
  type Camera,
  type Light,
  type Material,
  type Mesh,
  type Scene,
  type WebGLRenderer,
} from 'three';
import { isBlended, materialsOf } from './materials.ts';
import { withoutBackground } from './rendererState.ts';

/**
 * Shades what smoke shadows: the scene's opaque objects are drawn once more where the stencil counts, with their own
 * materials and the key light at intensity 0, which compiles nothing anew. Their depth is the same again and passes.
 * After the ambient pass of Heidmann's shadow volumes ('Real shadows, real time', 1991), in the opposite order.
 */
export function relight(renderer: WebGLRenderer, scene: Scene, camera: Camera, keyLight: Light): void {
  const hidden = hideBlended(scene);
  const { intensity } = keyLight;
  keyLight.intensity = 0;
  lockStencil(renderer);
  try {
    withoutBackground(scene, () => renderer.render(scene, camera));
  } finally {
    renderer.state.buffers.stencil.setLocked(false);
    keyLight.intensity = intensity;
    for (const material of hidden) material.visible = true;
  }
}

/** Where the stencil is not zero: whatever the materials say of it, until the lock is taken away. */
function lockStencil(renderer: WebGLRenderer): void {
  const { stencil } = renderer.state.buffers;
  stencil.setTest(true);
  stencil.setMask(0);
  stencil.setFunc(NotEqualStencilFunc, 0, 0xff);
  stencil.setOp(KeepStencilOp, KeepStencilOp, KeepStencilOp);
  stencil.setLocked(true);
}

/** Hides what is blended or refracts, and returns which materials that are: they are drawn over smoke, and once. */
function hideBlended(scene: Scene): Set<Material> {
  const hidden = new Set<Material>();
  scene.traverseVisible((object) => {
    for (const material of materialsOf(object as Mesh)) {
      if (!material.visible || !isBlended(material)) continue;
      material.visible = false;
      hidden.add(material);
    }
  });
  return hidden;
}
