import { BufferAttribute, BufferGeometry, Mesh, Scene, type RawShaderMaterial, type WebGLRenderer } from 'three';
import { PassCamera } from './passCamera.ts';

/** One triangle that covers the viewport; its vertex shader is shaders/lib/fullScreen.vert. */
export function fullScreenMesh(material: RawShaderMaterial): Mesh<BufferGeometry, RawShaderMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
  geometry.setDrawRange(0, 3);
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

/** Draws one material over the whole viewport, and owns it. */
export class FullScreen {
  private readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();

  constructor(material: RawShaderMaterial) {
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
