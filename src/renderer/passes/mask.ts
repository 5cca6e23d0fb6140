import {
  LessEqualStencilFunc,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  type ShaderMaterialParameters,
  type StencilFunc,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../../shaders/mask/mask.frag';
import { ADDS, FullScreen } from '../gpu/fullScreen.ts';

/**
 * Copies the stencil to the alpha of the lit colour, the shadow mask: 1 where at least one volume contains the pixel.
 * With two steps of shadow it is 1/2 there, and 3/4 where enough volumes for deep shadow contain the pixel. Ink always
 * has 1.
 */
export class MaskPass {
  private readonly any = maskWhere(NotEqualStencilFunc, 0);
  private readonly deep = maskWhere(LessEqualStencilFunc, 1);
  // With these bits, a count of 0 or 1 reads as 0, and larger counts do not.
  private readonly once = maskWhere(NotEqualStencilFunc, 1, {
    colorWrite: false,
    stencilFuncMask: 0xfe,
    stencilZPass: ReplaceStencilOp,
  });
  private isDeepDrawn = false;

  /** @param depth number of volumes that make deep shadow, 2..255; Infinity for shadow of one step */
  setDepth(depth: number): void {
    this.isDeepDrawn = depth < Infinity;
    this.any.material.uniforms.share.value = this.isDeepDrawn ? 0.5 : 1;
    this.deep.material.uniforms.share.value = 0.25;
    this.deep.material.stencilRef = Math.min(depth, 255);
  }

  /** With two steps of shadow, replaces all counts above 1 by 1, so that the volumes counted so far count once. */
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

/** @param stencilRef reference value; the test is reference function count */
function maskWhere(stencilFunc: StencilFunc, stencilRef: number, more?: ShaderMaterialParameters): FullScreen {
  return new FullScreen(
    fragmentShader,
    { share: { value: 1 } },
    { ...ADDS, stencilWrite: true, stencilFunc, stencilRef, ...more },
  );
}
