import {
  AddEquation,
  CustomBlending,
  GLSL3,
  KeepStencilOp,
  LessEqualStencilFunc,
  NotEqualStencilFunc,
  OneFactor,
  RawShaderMaterial,
  type StencilFunc,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/mask/mask.frag';
import vertexShader from '../../shaders/lib/fullScreen.vert';
import { FullScreen } from '../device/fullScreen.ts';

/**
 * Turns the stencil into the alpha of the lit colour: 1 where at least one volume holds the pixel. With two steps of
 * shadow it is 1/2 there, and 3/4 where as many volumes hold the pixel as make deep shadow. Ink is 1 whatever comes.
 */
export class MaskPass {
  private readonly any = maskMaterial(NotEqualStencilFunc, 0);
  private readonly deep = maskMaterial(LessEqualStencilFunc, 1);
  private readonly anyTriangle = new FullScreen(this.any);
  private readonly deepTriangle = new FullScreen(this.deep);
  private isDeepDrawn = false;

  /** @param depth how many volumes make deep shadow, 2..255; Infinity for shadow of one step */
  setDepth(depth: number): void {
    this.isDeepDrawn = depth < Infinity;
    this.any.uniforms.share.value = this.isDeepDrawn ? 0.5 : 1;
    this.deep.uniforms.share.value = 0.25;
    this.deep.stencilRef = Math.min(depth, 255);
  }

  draw(renderer: WebGLRenderer): void {
    this.anyTriangle.draw(renderer);
    if (this.isDeepDrawn) this.deepTriangle.draw(renderer);
  }

  dispose(): void {
    this.anyTriangle.dispose();
    this.deepTriangle.dispose();
  }
}

/** @param reference what the function compares with the count: reference function count */
function maskMaterial(stencilFunc: StencilFunc, reference: number): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: { share: { value: 1 } },
    depthTest: false,
    depthWrite: false,
    transparent: true,
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneFactor,
    stencilWrite: true,
    stencilFunc,
    stencilRef: reference,
    stencilFail: KeepStencilOp,
    stencilZFail: KeepStencilOp,
    stencilZPass: KeepStencilOp,
  });
}
