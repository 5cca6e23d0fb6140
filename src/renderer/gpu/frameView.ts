import {
  Matrix4,
  Vector2,
  Vector3,
  Vector4,
  type Box3,
  type Camera,
  type Color as ThreeColor,
  type IUniform,
  type Plane,
  type RawShaderMaterial,
} from 'three';
import { rowUniforms, type RowUniforms } from './drawnRows.ts';

/** Maximum number of planes that cut off puffs. */
export const MAX_PLANES = 8;

/** Uniforms of the parameters of the style, by their names. */
export interface StyleUniforms extends Record<string, IUniform> {
  /** Width of the outlines in pixels of the target; 0 draws no lines. */
  inkPixels: IUniform<number>;
  /** Linear colour of the rim in the light of the style. */
  rimGlow: IUniform<ThreeColor>;
  /** Factor on display-encoded colours at the low end of the gradient; at its high end it is 1. */
  gradientFactor: IUniform<ThreeColor>;
}

/** Uniforms of the style, the camera, the light, the target and the drawn rows. All passes of a smoke share one object. */
export interface ViewUniforms extends StyleUniforms, RowUniforms {
  viewFromWorld: IUniform<Matrix4>;
  clipFromView: IUniform<Matrix4>;
  /** Size of the target in pixels. */
  viewport: IUniform<Vector2>;
  /** Lower left corner of the viewport in the target where volumes are counted, pixels. */
  viewportOrigin: IUniform<Vector2>;
  /** View depth of the near plane. */
  near: IUniform<number>;
  /** (unit vector towards the light, 0) or (position of the light, 1), see shaders/lib/light.glsl. */
  lightInWorld: IUniform<Vector4>;
  lightInView: IUniform<Vector4>;
  /** World-space box of everything that receives shadow. Shadow volumes end where they leave it. */
  receiversMin: IUniform<Vector3>;
  receiversMax: IUniform<Vector3>;
  /** Planes in view space that cut off puffs, and how many there are. */
  clippingPlanes: IUniform<Float32Array>;
  planeCount: IUniform<number>;
}

/** Variants of materials for the light of a frame. */
interface MaterialVariants {
  on(material: RawShaderMaterial): RawShaderMaterial;
}

/** The style, the camera and the light of one frame, as the passes use them. */
export class FrameView {
  /** The part of the uniforms that the style sets. */
  readonly style: StyleUniforms;
  readonly uniforms: ViewUniforms;
  readonly clipFromWorld = new Matrix4();
  /** What the light needs besides the code of a sun. */
  variants: readonly MaterialVariants[] = [];
  /** Unit vector in world space along which the camera looks. */
  readonly forward = new Vector3();
  /** Depth of the camera along `forward`, measured from the world origin. */
  private depth = 0;

  constructor(style: StyleUniforms) {
    this.style = style;
    this.uniforms = {
      ...style,
      ...rowUniforms(),
      viewFromWorld: { value: new Matrix4() },
      clipFromView: { value: new Matrix4() },
      viewport: { value: new Vector2(1, 1) },
      viewportOrigin: { value: new Vector2() },
      near: { value: 0.1 },
      lightInWorld: { value: new Vector4(0, 1, 0, 0) },
      lightInView: { value: new Vector4(0, 1, 0, 0) },
      receiversMin: { value: new Vector3() },
      receiversMax: { value: new Vector3() },
      clippingPlanes: { value: new Float32Array(4 * MAX_PLANES) },
      planeCount: { value: 0 },
    };
  }

  /**
   * Sets the camera, the light and the size of the target.
   * @param light (unit vector towards the light, 0) or (position of the light, 1), world space
   * @param width, height of the target in pixels
   * @param reversedDepth whether the renderer maps the near plane to window depth 1 and the far plane to 0
   */
  look(camera: Camera, light: Vector4, width: number, height: number, reversedDepth = false): void {
    const { uniforms } = this;
    camera.updateMatrixWorld();
    uniforms.viewFromWorld.value.copy(camera.matrixWorldInverse);
    const clipFromView = uniforms.clipFromView.value.copy(camera.projectionMatrix);
    if (reversedDepth && !camera.reversedDepth) reverseDepth(clipFromView);
    uniforms.viewport.value.set(width, height);
    uniforms.near.value = nearOf(clipFromView);
    uniforms.lightInWorld.value.copy(light);
    uniforms.lightInView.value.copy(light).applyMatrix4(camera.matrixWorldInverse);
    this.clipFromWorld.multiplyMatrices(clipFromView, camera.matrixWorldInverse);
    this.forward.set(0, 0, -1).transformDirection(camera.matrixWorld);
    this.depth = new Vector3().setFromMatrixPosition(camera.matrixWorld).dot(this.forward);
  }

  /** The variant of a material that shades in the light of the frame. */
  variantOf(material: RawShaderMaterial): RawShaderMaterial {
    return this.variants.reduce((variant, each) => each.on(variant), material);
  }

  /** Draws with the variant of a pass's material. */
  asVariant(pass: { material: RawShaderMaterial }, draw: () => void): void {
    const { material } = pass;
    pass.material = this.variantOf(material);
    draw();
    pass.material = material;
  }

  /** Unit vector along which the light travels at a point, world space; downwards at the place of a lamp. */
  travelAt(place: Vector3): Vector3 {
    const { x, y, z, w } = this.uniforms.lightInWorld.value;
    const towards = new Vector3(x, y, z).addScaledVector(place, -w);
    if (towards.lengthSq() === 0) towards.y = 1;
    return towards.normalize().negate();
  }

  /** Place of a lamp, world space; undefined if the light is a sun, with parallel rays. */
  get lamp(): Vector3 | undefined {
    const { x, y, z, w } = this.uniforms.lightInWorld.value;
    return w === 0 ? undefined : new Vector3(x, y, z);
  }

  /** @param box box of everything that can receive a shadow, world space */
  receive(box: Box3): void {
    this.uniforms.receiversMin.value.copy(box.min);
    this.uniforms.receiversMax.value.copy(box.max);
  }

  /** @param planes planes in world space that cut off puffs, at most {@link MAX_PLANES} */
  clip(planes: readonly Plane[]): void {
    const { clippingPlanes, planeCount, viewFromWorld } = this.uniforms;
    planeCount.value = planes.length;
    planes.forEach((plane, index) => {
      const { normal, constant } = plane.clone().applyMatrix4(viewFromWorld.value);
      clippingPlanes.value.set([...normal.toArray(), constant], 4 * index);
    });
  }

  /** Depths of the near and the far plane along {@link forward}, measured from the world origin. */
  get range(): [number, number] {
    return [this.depth + this.uniforms.near.value, this.depth + farOf(this.uniforms.clipFromView.value)];
  }

  /** Tangent of the largest angle between a view ray and the view axis; 0 for an orthographic camera. */
  get steepestSlope(): number {
    const e = this.uniforms.clipFromView.value.elements;
    if (e[11] === 0) return 0;
    return Math.hypot((1 + Math.abs(e[8])) / e[0], (1 + Math.abs(e[9])) / e[5]);
  }

  /** World units that one pixel spans, per unit of clip w. */
  get unitsPerPixel(): number {
    return 2 / (this.uniforms.clipFromView.value.elements[5] * this.uniforms.viewport.value.y);
  }
}

/** Converts a projection matrix to reversed depth. three.js does this only when it first draws with the camera. */
function reverseDepth({ elements }: Matrix4): void {
  for (const column of [0, 4, 8, 12]) elements[column + 2] = 0.5 * (elements[column + 3] - elements[column + 2]);
}

/** View depth of the near plane of a projection. */
function nearOf(clipFromView: Matrix4): number {
  const e = clipFromView.elements;
  // Reversed, see shaders/lib/depth.glsl: clip z = clip w at the near plane.
  if (e[14] > 0) return (e[14] - e[15]) / (e[10] - e[11]);
  // At the near plane clip z = -clip w: e10 z + e14 = -(e11 z + e15), solved for z = -near.
  return (e[14] + e[15]) / (e[10] + e[11]);
}

/** View depth of the far plane of a projection; a large number if the far plane is at infinity. */
function farOf(clipFromView: Matrix4): number {
  const BOUNDLESS = 1e9;
  const e = clipFromView.elements;
  const far = e[14] > 0 ? e[14] / e[10] : (e[14] - e[15]) / (e[10] - e[11]);
  return far > 0 && far < BOUNDLESS ? far : BOUNDLESS;
}
