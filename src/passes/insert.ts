import {
  Color as ThreeColor,
  ColorManagement,
  CustomBlending,
  EqualStencilFunc,
  LessEqualStencilFunc,
  NotEqualStencilFunc,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SRGBColorSpace,
  SrcColorFactor,
  Vector2,
  ZeroFactor,
  ZeroStencilOp,
  Matrix4,
  Mesh,
  type Fog,
  type FogExp2,
  type ShaderMaterialParameters,
  type Texture,
  type WebGLRenderer,
} from 'three';
import darkenFragmentShader from '../../shaders/insert/darken.frag';
import fragmentShader from '../../shaders/insert/insert.frag';
import type { FrameView } from '../device/frameView.ts';
import { FullScreen, triangle } from '../device/fullScreen.ts';
import { writeColor, type Color } from '../device/ramps.ts';
import type { SmokePictures } from './pictures.ts';

/** Values of `fogKind` in shaders/insert/insert.frag. */
const NO_FOG = 0;
const LINEAR_FOG = 1;
const EXPONENTIAL_FOG = 2;

/**
 * Composites smoke from its own targets into the host's framebuffer, which has depth and stencil. The depth comes
 * first, so that shadow volumes count on smoke and scene alike. Then the lit picture is drawn where the stencil is
 * zero, and the unlit picture elsewhere. With two steps of shadow, the deep picture precedes the unlit one and clears
 * the stencil where it drew.
 */
export class InsertPass {
  private readonly depthTriangle: FullScreen;
  private readonly litTriangle: FullScreen;
  private readonly unlitTriangle: FullScreen;
  private readonly deepTriangle: FullScreen;
  private readonly darkenTriangle: FullScreen;
  private readonly common = {
    smokeDepth: { value: null as Texture | null },
    isLinear: { value: false },
    isOblique: { value: false },
    smokeProjection: { value: new Matrix4() },
    fogKind: { value: NO_FOG },
    fogColor: { value: new ThreeColor() },
    fogRange: { value: new Vector2() },
  };
  private readonly lit = { value: null as Texture | null };
  private readonly unlit = { value: null as Texture | null };
  private readonly deep = { value: null as Texture | null };
  private readonly factor = { value: new ThreeColor() };
  /** A mesh that draws unlit smoke where the stencil is not zero, for the host's render list. */
  readonly marker: Mesh;

  constructor(eye: FrameView) {
    const { viewportOrigin, clipFromView } = eye.uniforms;
    const onlyDepth = { depthTest: true, depthWrite: true, colorWrite: false };
    const [lit, unlit, deep] = [this.lit, this.unlit, this.deep].map((picture) => {
      return { ...this.common, viewportOrigin, clipFromView, picture };
    });
    this.depthTriangle = new FullScreen(fragmentShader, unlit, onlyDepth);
    this.litTriangle = new FullScreen(fragmentShader, lit, shownWhere(EqualStencilFunc));
    this.unlitTriangle = new FullScreen(fragmentShader, unlit, shownWhere(NotEqualStencilFunc));
    this.deepTriangle = new FullScreen(fragmentShader, deep, {
      ...shownWhere(LessEqualStencilFunc),
      stencilWriteMask: 0xff,
      stencilZPass: ZeroStencilOp,
    });
    this.darkenTriangle = new FullScreen(darkenFragmentShader, { factor: this.factor }, DARKENS);
    // A scene.overrideMaterial must not replace this material.
    this.unlitTriangle.material.allowOverride = false;
    this.marker = new Mesh(triangle(), this.unlitTriangle.material);
    this.marker.frustumCulled = false;
  }

  /**
   * @param depth depth texture of the smoke
   * @param isLinear whether the framebuffer holds linear colours instead of display-encoded ones
   */
  setSmoke(
    { lit, unlit, deep }: Pick<SmokePictures, 'lit' | 'unlit' | 'deep'>,
    depth: Texture,
    isLinear: boolean,
  ): void {
    this.lit.value = lit;
    this.unlit.value = unlit;
    this.deep.value = deep;
    this.common.smokeDepth.value = depth;
    this.common.isLinear.value = isLinear;
  }

  /**
   * @param fog fog of the host's scene, which acts on what is drawn after this call; call `setSmoke` before
   * @param scale metres of the scene in a metre of the smoke
   */
  setFog(fog: Fog | FogExp2 | null, scale = 1): void {
    const { fogKind, fogColor, fogRange, isLinear } = this.common;
    fogKind.value = fog ? ('density' in fog ? EXPONENTIAL_FOG : LINEAR_FOG) : NO_FOG;
    if (!fog) return;
    // three.js, too, adds fog to display-encoded colours if the framebuffer holds them.
    fog.color.getRGB(fogColor.value, isLinear.value ? ColorManagement.workingColorSpace : SRGBColorSpace);
    if ('density' in fog) fogRange.value.set(fog.density * scale, 0);
    else fogRange.value.set(fog.near / scale, fog.far / scale);
  }

  /** @param projection projection of the smoke's depth, if that of the view has an oblique near plane */
  setOblique(projection: Matrix4 | undefined): void {
    this.common.isOblique.value = projection !== undefined;
    if (projection) this.common.smokeProjection.value.copy(projection);
  }

  drawDepth(renderer: WebGLRenderer): void {
    this.depthTriangle.draw(renderer);
  }

  drawLit(renderer: WebGLRenderer): void {
    this.litTriangle.draw(renderer);
  }

  drawUnlit(renderer: WebGLRenderer): void {
    this.unlitTriangle.draw(renderer);
  }

  /**
   * Darkens the scene where at least `depth` volumes contain it, and prepares `drawDeep`.
   * @param depth number of volumes that make deep shadow, 2..255
   * @param color factor on the colour of shadow where shadow is deep
   */
  darken(renderer: WebGLRenderer, depth: number, color: Color): void {
    writeColor(color, this.factor);
    if (this.common.isLinear.value) this.factor.value.convertSRGBToLinear();
    for (const { material } of [this.darkenTriangle, this.deepTriangle]) material.stencilRef = Math.min(depth, 255);
    this.darkenTriangle.draw(renderer);
  }

  /** Draws the smoke in deep shadow, and clears the stencil there. */
  drawDeep(renderer: WebGLRenderer): void {
    this.deepTriangle.draw(renderer);
  }

  dispose(): void {
    for (const each of [this.depthTriangle, this.litTriangle, this.unlitTriangle]) each.dispose();
    for (const each of [this.deepTriangle, this.darkenTriangle]) each.dispose();
    this.marker.geometry.dispose();
  }
}

/** Premultiplied alpha blending. The depth test passes where the depth of the smoke was drawn and is nearest. */
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

/** Multiplies the destination colour and keeps its alpha. */
const DARKENS: ShaderMaterialParameters = {
  blending: CustomBlending,
  blendSrc: ZeroFactor,
  blendDst: SrcColorFactor,
  stencilWrite: true,
  stencilWriteMask: 0,
  stencilFunc: LessEqualStencilFunc,
};
