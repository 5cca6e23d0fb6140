import {
  LessEqualStencilFunc,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  type ShaderMaterialParameters,
  type StencilFunc,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/mask/mask.frag';
import { ADDS, FullScreen } from '../device/fullScreen.ts';

/**
 * Turns the stencil into the alpha of the lit colour: 1 where at least one volume holds the pixel. With two steps of
 * shadow it is 1/2 there, and 3/4 where as many volumes hold the pixel as make deep shadow. Ink is 1 whatever comes.
 */
export class MaskPass {
  private readonly any = maskWhere(NotEqualStencilFunc, 0);
  private readonly deep = maskWhere(LessEqualStencilFunc, 1);
  // Only counts of two and more differ from 1 in these bits.
  private readonly once = maskWhere(NotEqualStencilFunc, 1, {
    colorWrite: false,
    stencilFuncMask: 0xfe,
    stencilZPass: ReplaceStencilOp,
  });
  private isDeepDrawn = false;

  /** @param depth how many volumes make deep shadow, 2..255; Infinity for shadow of one step */
  setDepth(depth: number): void {
    this.isDeepDrawn = depth < Infinity;
    this.any.material.uniforms.share.value = this.isDeepDrawn ? 0.5 : 1;
    this.deep.material.uniforms.share.value = 0.25;
    this.deep.material.stencilRef = Math.min(depth, 255);
  }

  /** Where shadow has two steps, lets all volumes that the stencil has counted so far count as one. */
  countOnce(renderer: WebGLRenderer): void {
    if (this.isDeepDrawn) this.once.draw(renderer);
  }

  draw(renderer: WebGLRenderer): void {
    this.any.draw(renderer);
    if (this.isDeepDrawn) this.deep.draw(renderer);
  }

  dispose(): void {
    for (const each of [this.any, this.deep, this.once]) each.dispose();
  }
}

/** @param stencilRef what the function compares with the count: reference function count */
function maskWhere(stencilFunc: StencilFunc, stencilRef: number, more?: ShaderMaterialParameters): FullScreen {
  return new FullScreen(
    fragmentShader,
    { share: { value: 1 } },
    { ...ADDS, stencilWrite: true, stencilFunc, stencilRef, ...more },
  );
}
