import {
  Color as ThreeColor,
  ColorManagement,
  CustomBlending,
  LessEqualStencilFunc,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SRGBColorSpace,
  SrcColorFactor,
  Vector2,
  ZeroFactor,
  Matrix4,
  type Camera,
  type Fog,
  type FogExp2,
  type RawShaderMaterial,
  type ShaderMaterialParameters,
  type Texture,
  type ToneMapping,
  type WebGLRenderer,
} from 'three';
import darkenFragmentShader from '../../../shaders/insert/darken.frag';
import fragmentShader from '../../../shaders/insert/insert.frag';
import vertexShader from '../../../shaders/lib/fullScreen.vert';
import type { FrameView } from '../gpu/frameView.ts';
import { FullScreen, pictureMaterial } from '../gpu/fullScreen.ts';
import { writeColor, type Color } from '../gpu/ramps.ts';

/** Values of `fogKind` in shaders/insert/insert.frag. */
const NO_FOG = 0;
const LINEAR_FOG = 1;
const EXPONENTIAL_FOG = 2;

/**
 * Composites the picture of the smoke into the host's framebuffer, with its depth, and darkens the deep shadow on the host's
 * objects there.
 */
export class InsertPass {
  private readonly darkenTriangle: FullScreen;
  private readonly uniforms = {
    picture: { value: null as Texture | null },
    smokeDepth: { value: null as Texture | null },
    isLinear: { value: false },
    toneMapping: { value: 0 as ToneMapping },
    toneMappingExposure: { value: 1 },
    isOblique: { value: false },
    isMirrored: { value: false },
    smokeProjection: { value: new Matrix4() },
    fogKind: { value: NO_FOG },
    fogColor: { value: new ThreeColor() },
    fogRange: { value: new Vector2() },
  };
  private readonly factor = { value: new ThreeColor() };
  private readonly pictureTriangle: FullScreen;
  /** Draws nothing: the material of the smoke object, at whose place in the host's render list smoke is drawn. */
  readonly placeholder: RawShaderMaterial;

  constructor(eye: FrameView) {
    const { viewportOrigin, clipFromView } = eye.uniforms;
    this.darkenTriangle = new FullScreen(darkenFragmentShader, { factor: this.factor }, DARKENS);
    const uniforms = { ...this.uniforms, viewportOrigin, clipFromView };
    this.pictureTriangle = new FullScreen(fragmentShader, uniforms, BLENDED);
    // The same program, so that `compile` of three.js compiles it.
    this.placeholder = pictureMaterial({ vertexShader, fragmentShader, uniforms, transparent: true });
    // A scene.overrideMaterial must not replace this material.
    this.placeholder.allowOverride = false;
  }

  /** @param camera the host's, whose clipping planes three.js then has for what it draws next */
  draw(renderer: WebGLRenderer, camera: Camera): void {
    this.pictureTriangle.draw(renderer, undefined, camera);
  }

  /**
   * @param picture premultiplied, display-encoded colours
   * @param depth depth texture of the smoke
   * @param isLinear whether the framebuffer holds linear colours instead of display-encoded ones
   */
  setSmoke(picture: Texture, depth: Texture, isLinear: boolean): void {
    this.uniforms.picture.value = picture;
    this.uniforms.smokeDepth.value = depth;
    this.uniforms.isLinear.value = isLinear;
  }

  /**
   * Undoes the tone mapping of a later pass, so that it shows smoke in its own colours.
   * @param operator of three.js; those without an inverse change the colours
   */
  setToneMapping(operator: ToneMapping, exposure: number): void {
    this.uniforms.toneMapping.value = operator;
    this.uniforms.toneMappingExposure.value = exposure;
  }

  /**
   * @param fog fog of the host's scene, which acts on what is drawn after this call; call `setSmoke` before
   * @param scale metres of the scene in a metre of the smoke
   */
  setFog(fog: Fog | FogExp2 | null, scale = 1): void {
    const { fogKind, fogColor, fogRange, isLinear } = this.uniforms;
    fogKind.value = fog ? ('density' in fog ? EXPONENTIAL_FOG : LINEAR_FOG) : NO_FOG;
    if (!fog) return;
    // three.js, too, adds fog to display-encoded colours if the framebuffer holds them.
    fog.color.getRGB(fogColor.value, isLinear.value ? ColorManagement.workingColorSpace : SRGBColorSpace);
    if ('density' in fog) fogRange.value.set(fog.density * scale, 0);
    else fogRange.value.set(fog.near / scale, fog.far / scale);
  }

  /**
   * @param projection projection of the smoke's depth, if that of the view may have an oblique near plane
   * @param isMirrored whether the picture is inserted from right to left
   */
  setHost(projection: Matrix4 | undefined, isMirrored: boolean): void {
    this.uniforms.isMirrored.value = isMirrored;
    this.uniforms.isOblique.value = projection !== undefined;
    if (projection) this.uniforms.smokeProjection.value.copy(projection);
  }

  /**
   * Darkens the scene where at least `depth` volumes contain it.
   * @param depth number of volumes that make deep shadow, 2..255
   * @param color factor on the colour of shadow where shadow is deep
   * @param isLinear as in {@link setSmoke}
   */
  darken(renderer: WebGLRenderer, depth: number, color: Color, isLinear: boolean): void {
    writeColor(color, this.factor);
    if (isLinear) this.factor.value.convertSRGBToLinear();
    this.darkenTriangle.material.stencilRef = Math.min(depth, 255);
    this.darkenTriangle.draw(renderer);
  }

  dispose(): void {
    this.darkenTriangle.dispose();
    this.pictureTriangle.dispose();
    this.placeholder.dispose();
  }
}

/** Premultiplied alpha blending, with depth. */
const BLENDED: ShaderMaterialParameters = {
  depthTest: true,
  depthWrite: true,
  transparent: true,
  blending: CustomBlending,
  blendSrc: OneFactor,
  blendDst: OneMinusSrcAlphaFactor,
};

/** Multiplies the destination colour and keeps its alpha. */
const DARKENS: ShaderMaterialParameters = {
  blending: CustomBlending,
  blendSrc: ZeroFactor,
  blendDst: SrcColorFactor,
  stencilWrite: true,
  stencilWriteMask: 0,
  stencilFunc: LessEqualStencilFunc,
};
