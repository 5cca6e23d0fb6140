import { Camera } from 'three';

/** What three.js is given as the camera of a pass, whose shaders take theirs from the eye. */
export class PassCamera extends Camera {
  /** three.js asks for it when depth is reversed; there is nothing to update. */
  updateProjectionMatrix(): void {}
}
