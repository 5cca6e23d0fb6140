import { Camera, Color as ThreeColor, GLSL3, RawShaderMaterial, Scene, type WebGLRenderer } from 'three';
import fragmentShader from '../../shaders/backdrop/backdrop.frag';
import vertexShader from '../../shaders/lib/fullScreen.vert';
import type { Eye } from '../device/eye.ts';
import { fullScreenMesh } from '../device/fullScreen.ts';
import type { Color } from '../device/ramps.ts';

/** Paints what lies behind everything, if anything does. Reads nothing; writes both colours. */
export class BackdropPass {
  private readonly scene = new Scene();
  private readonly camera = new Camera();
  private readonly uniforms = { topColor: { value: new ThreeColor() }, bottomColor: { value: new ThreeColor() } };
  private readonly mesh;

  constructor(eye: Eye) {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: { ...this.uniforms, viewport: eye.uniforms.viewport },
      depthTest: false,
      depthWrite: false,
    });
    this.mesh = fullScreenMesh(material);
    this.scene.add(this.mesh);
  }

  setColors(top: Color, bottom: Color): void {
    this.uniforms.topColor.value.fromArray(top.map((channel) => channel / 255));
    this.uniforms.bottomColor.value.fromArray(bottom.map((channel) => channel / 255));
  }

  draw(renderer: WebGLRenderer): void {
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
