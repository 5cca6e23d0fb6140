import { Mesh, Scene, type BufferGeometry, type RawShaderMaterial, type WebGLRenderer } from 'three';
import { PassCamera } from './passCamera.ts';

/** A mesh that a pass draws by itself, wherever its shaders put it. It owns neither geometry nor material. */
export class DrawnMesh<Geometry extends BufferGeometry = BufferGeometry> {
  readonly mesh: Mesh<Geometry, RawShaderMaterial>;
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();

  constructor(geometry: Geometry, material: RawShaderMaterial) {
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  /** What it is drawn with at present. */
  get material(): RawShaderMaterial {
    return this.mesh.material;
  }

  set material(material: RawShaderMaterial) {
    this.mesh.material = material;
  }

  /** Has its program compiled, and does not wait for it. */
  compile(renderer: WebGLRenderer): void {
    renderer.compile(this.scene, this.camera);
  }

  draw(renderer: WebGLRenderer): void {
    renderer.render(this.scene, this.camera);
  }

  /** Draws once in another material. */
  drawAs(renderer: WebGLRenderer, other: RawShaderMaterial): void {
    const { material } = this;
    this.material = other;
    this.draw(renderer);
    this.material = material;
  }
}
