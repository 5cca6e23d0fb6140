import {
  AddEquation,
  CustomBlending,
  GLSL3,
  KeepStencilOp,
  NotEqualStencilFunc,
  OneFactor,
  RawShaderMaterial,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/mask/mask.frag';
import vertexShader from '../../shaders/lib/fullScreen.vert';
import { FullScreen } from '../device/fullScreen.ts';

/** Turns the stencil into the alpha of the lit colour: 1 where at least one volume holds the pixel. */
export class MaskPass {
  private readonly triangle: FullScreen;

  constructor() {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      depthTest: false,
      depthWrite: false,
      transparent: true,
      blending: CustomBlending,
      blendEquation: AddEquation,
      blendSrc: OneFactor,
      blendDst: OneFactor,
      stencilWrite: true,
      stencilFunc: NotEqualStencilFunc,
      stencilRef: 0,
      stencilFail: KeepStencilOp,
      stencilZFail: KeepStencilOp,
      stencilZPass: KeepStencilOp,
    });
    this.triangle = new FullScreen(material);
  }

  draw(renderer: WebGLRenderer): void {
    this.triangle.draw(renderer);
  }

  dispose(): void {
    this.triangle.dispose();
  }
}
