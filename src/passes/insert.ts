import {
  CustomBlending,
  EqualStencilFunc,
  GLSL3,
  NotEqualStencilFunc,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
  Scene,
  type BufferGeometry,
  type IUniform,
  type Mesh,
  type ShaderMaterialParameters,
  type Texture,
  type WebGLRenderer,
} from 'three';
import { PassCamera } from '../device/passCamera.ts';
import fragmentShader from '../../shaders/insert/insert.frag';
import vertexShader from '../../shaders/lib/fullScreen.vert';
import type { Eye } from '../device/eye.ts';
import { fullScreenMesh } from '../device/fullScreen.ts';

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
  /** Draws unlit smoke where the stencil counts: the part that can wait for its turn in a stranger's list. */
  readonly unlitMesh: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly depthMesh: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly litMesh: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();
  private readonly common = {
    smokeDepth: { value: null as Texture | null },
    isLinear: { value: false },
  };
  private readonly lit = { value: null as Texture | null };
  private readonly unlit = { value: null as Texture | null };

  constructor(eye: Eye) {
    const uniforms = { ...this.common, viewportOrigin: eye.uniforms.viewportOrigin };
    this.depthMesh = insertMesh({ ...uniforms, picture: this.unlit }, { colorWrite: false, depthWrite: true });
    this.litMesh = insertMesh({ ...uniforms, picture: this.lit }, shownWhere(EqualStencilFunc));
    this.unlitMesh = insertMesh({ ...uniforms, picture: this.unlit }, shownWhere(NotEqualStencilFunc));
  }

  /** @param isLinear whether the picture holds linear colour instead of display-encoded */
  setSmoke({ lit, unlit, depth }: InsertedSmoke, isLinear: boolean): void {
    this.lit.value = lit;
    this.unlit.value = unlit;
    this.common.smokeDepth.value = depth;
    this.common.isLinear.value = isLinear;
  }

  drawDepth(renderer: WebGLRenderer): void {
    this.draw(renderer, this.depthMesh);
  }

  drawLit(renderer: WebGLRenderer): void {
    this.draw(renderer, this.litMesh);
  }

  dispose(): void {
    for (const { geometry, material } of [this.depthMesh, this.litMesh, this.unlitMesh]) {
      geometry.dispose();
      material.dispose();
    }
  }

  private draw(renderer: WebGLRenderer, mesh: Mesh): void {
    this.scene.children = [mesh];
    renderer.render(this.scene, this.camera);
  }
}

function insertMesh(
  uniforms: Record<string, IUniform>,
  parameters: ShaderMaterialParameters,
): Mesh<BufferGeometry, RawShaderMaterial> {
  const material = new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, ...parameters });
  // A scene that is drawn with one material for everything shall not replace this one.
  material.allowOverride = false;
  return fullScreenMesh(material);
}

/** Colour over what is there, and nearest: the depth that was inserted before stands there. */
function shownWhere(stencilFunc: ShaderMaterialParameters['stencilFunc']): ShaderMaterialParameters {
  return {
    transparent: true,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    depthWrite: false,
    stencilWrite: true,
    stencilWriteMask: 0,
    stencilFunc,
  };
}
