import { Camera, Matrix4, type PerspectiveCamera } from 'three';

/** A rotation by 180 degrees about the view axis. */
const HALF_CIRCLE = new Matrix4().makeRotationZ(Math.PI);

/** A camera as smoke can draw with it. */
export interface StraightCamera {
  /** A camera with the same picture, whose projection is neither upside down nor oblique. */
  camera: Camera;
  /** Its projection with the oblique near plane, which the depth of the host has; undefined without one. */
  oblique: Matrix4 | undefined;
}

/**
 * CubeCamera draws its faces upside down, by a negative angle of view. Reflector clips what is behind the mirror, by an
 * oblique near plane (Lengyel, 'Oblique View Frustum Depth Projection and Clipping', 2005).
 */
export function straightened(camera: Camera): StraightCamera {
  const { elements } = camera.projectionMatrix;
  const isUpsideDown = elements[0] < 0 && elements[5] < 0;
  const isOblique = elements[2] !== 0 || elements[6] !== 0;
  if (!isUpsideDown && !isOblique) return { camera, oblique: undefined };
  const straight = new Camera();
  straight.matrixAutoUpdate = straight.matrixWorldAutoUpdate = false;
  straight.matrixWorld.copy(camera.matrixWorld);
  straight.projectionMatrix.copy(camera.projectionMatrix);
  if (isUpsideDown) {
    straight.matrixWorld.multiply(HALF_CIRCLE);
    straight.projectionMatrix.multiply(HALF_CIRCLE);
  }
  const oblique = isOblique ? straight.projectionMatrix.clone() : undefined;
  if (isOblique) setRange(straight.projectionMatrix, camera as PerspectiveCamera);
  return { camera: straight, oblique };
}

/** Gives a projection the near and far planes of a camera's properties. */
function setRange({ elements }: Matrix4, { near, far }: PerspectiveCamera): void {
  const isPerspective = elements[11] !== 0;
  elements[2] = elements[6] = 0;
  elements[10] = -(isPerspective ? far + near : 2) / (far - near);
  elements[14] = -(isPerspective ? 2 * far * near : far + near) / (far - near);
}
