import { Camera } from 'three';

/** The camera argument of `WebGLRenderer.render` for a pass. The shaders take their matrices from the view uniforms. */
export class PassCamera extends Camera {
  /** three.js calls this with a reversed depth buffer; there is nothing to update. */
  updateProjectionMatrix(): void {}
}
