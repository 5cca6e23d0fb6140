import {
  CustomBlending,
  EqualStencilFunc,
  NotEqualStencilFunc,
  OneFactor,
  OneMinusSrcAlphaFactor,
  type Mesh,
  type ShaderMaterialParameters,
  type Texture,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/insert/insert.frag';
import type { Eye } from '../device/eye.ts';
import { FullScreen } from '../device/fullScreen.ts';

/** What is inserted: both pictures of the smoke, smoothed and premultiplied, and its depth. */
export interface InsertedSmoke {
  lit: Texture;
  unlit: Texture;
  depth: Texture;
}

/**
 * Puts smoke that was drawn by itself into a picture that others draw, which has depth and stencil of its own: first the
 * depth, so that volumes count on smoke and on all else; then lit where the stencil is zero, and unlit elsewhere.
 */
export class InsertPass {
  private readonly depthTriangle: FullScreen;
  private readonly litTriangle: FullScreen;
  private readonly unlitTriangle: FullScreen;
  private readonly common = {
    smokeDepth: { value: null as Texture | null },
    isLinear: { value: false },
  };
  private readonly lit = { value: null as Texture | null };
  private readonly unlit = { value: null as Texture | null };

  constructor(eye: Eye) {
    const uniforms = { ...this.common, viewportOrigin: eye.uniforms.viewportOrigin };
    const onlyDepth = { depthTest: true, depthWrite: true, colorWrite: false };
    const [lit, unlit] = [this.lit, this.unlit].map((picture) => ({ ...uniforms, picture }));
    this.depthTriangle = new FullScreen(fragmentShader, unlit, onlyDepth);
    this.litTriangle = new FullScreen(fragmentShader, lit, shownWhere(EqualStencilFunc));
    this.unlitTriangle = new FullScreen(fragmentShader, unlit, shownWhere(NotEqualStencilFunc));
    // A scene that is drawn with one material for everything shall not replace this one.
    this.unlitTriangle.material.allowOverride = false;
  }

  /** Draws unlit smoke where the stencil counts: the part that can wait for its turn in a stranger's list. */
  get unlitMesh(): Mesh {
    return this.unlitTriangle.mesh;
  }

  /** @param isLinear whether the picture holds linear colour instead of display-encoded */
  setSmoke({ lit, unlit, depth }: InsertedSmoke, isLinear: boolean): void {
    this.lit.value = lit;
    this.unlit.value = unlit;
    this.common.smokeDepth.value = depth;
    this.common.isLinear.value = isLinear;
  }

  drawDepth(renderer: WebGLRenderer): void {
    this.depthTriangle.draw(renderer);
  }

  drawLit(renderer: WebGLRenderer): void {
    this.litTriangle.draw(renderer);
  }

  dispose(): void {
    for (const triangle of [this.depthTriangle, this.litTriangle, this.unlitTriangle]) triangle.dispose();
  }
}

/** Colour over what is there, and nearest: the depth that was inserted before stands there. */
function shownWhere(stencilFunc: ShaderMaterialParameters['stencilFunc']): ShaderMaterialParameters {
  return {
    depthTest: true,
    transparent: true,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    stencilWrite: true,
    stencilWriteMask: 0,
    stencilFunc,
  };
}
