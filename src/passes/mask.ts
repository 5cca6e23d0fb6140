import {
  AddEquation,
  Camera,
  CustomBlending,
  GLSL3,
  KeepStencilOp,
  NotEqualStencilFunc,
  OneFactor,
  RawShaderMaterial,
  Scene,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/mask/mask.frag';
import vertexShader from '../../shaders/lib/fullScreen.vert';
import { fullScreenMesh } from '../device/fullScreen.ts';

/** Turns the stencil into the alpha of the lit colour: 1 where at least one volume holds the pixel. */
export class MaskPass {
  private readonly scene = new Scene();
  private readonly camera = new Camera();
  private readonly mesh;

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
    this.mesh = fullScreenMesh(material);
    this.scene.add(this.mesh);
  }

  draw(renderer: WebGLRenderer): void {
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
