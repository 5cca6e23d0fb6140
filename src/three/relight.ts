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
import { withoutBackground } from './rendererState.ts';

/**
 * Shades the areas that smoke shadows. The scene's opaque objects are drawn again where the stencil is not zero, with
 * their own materials and the key light at intensity 0, which requires no shader compilation. Their depth is equal to
 * the stored depth and passes the test.
 * Based on the ambient pass of Heidmann's shadow volumes ('Real shadows, real time', 1991), in the opposite order.
 */
export function relight(renderer: WebGLRenderer, scene: Scene, camera: Camera, keyLight: Light): void {
  const { intensity } = keyLight;
  keyLight.intensity = 0;
  lockStencil(renderer);
  try {
    drawAgain(renderer, scene, camera);
  } finally {
    renderer.state.buffers.stencil.setLocked(false);
    keyLight.intensity = intensity;
  }
}

/**
 * Draws the scene's opaque objects again, without its background. Objects that draw pictures before they are drawn, such
 * as mirrors, keep their picture of this frame.
 */
export function drawAgain(renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
  const hidden = hideBlended(scene);
  const methods: DrawingMethods = renderer;
  const { render, clear } = methods;
  methods.render = methods.clear = () => {};
  try {
    withoutBackground(scene, () => render.call(renderer, scene, camera));
  } finally {
    Object.assign(methods, { render, clear });
    for (const material of hidden) material.visible = true;
  }
}

interface DrawingMethods {
  render: (scene: Scene, camera: Camera) => void;
  clear: () => void;
}

/** Locks the stencil test to 'not equal 0', regardless of the materials' settings. */
function lockStencil(renderer: WebGLRenderer): void {
  const { stencil } = renderer.state.buffers;
  stencil.setTest(true);
  stencil.setMask(0);
  stencil.setFunc(NotEqualStencilFunc, 0, 0xff);
  stencil.setOp(KeepStencilOp, KeepStencilOp, KeepStencilOp);
  stencil.setLocked(true);
}

/** Hides blended and transmissive materials and returns them. They are drawn over smoke, and only once. */
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

/** The materials of an object; empty for objects that are not drawn. */
export function materialsOf({ material }: Partial<Pick<Mesh, 'material'>>): readonly Material[] {
  if (!material) return [];
  return Array.isArray(material) ? material : [material];
}

/** Whether three.js draws a material after all opaque ones. */
export function isBlended(material: Material): boolean {
  return material.transparent || ('transmission' in material && (material.transmission as number) > 0);
}
