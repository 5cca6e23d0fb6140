import { Camera, Mesh, Scene, type BufferGeometry, type RawShaderMaterial, type WebGLRenderer } from 'three';

/** The camera argument of `WebGLRenderer.render` for a pass. The shaders take their matrices from the view uniforms. */
export class PassCamera extends Camera {
  /** three.js calls this with a reversed depth buffer; there is nothing to update. */
  updateProjectionMatrix(): void {}
}

/**
 * A mesh that a pass draws on its own. Its shaders place it, so it is not culled. It does not dispose of its geometry
 * or material. Without a geometry of its own, each draw call takes one.
 */
export class DrawnMesh<Geometry extends BufferGeometry = BufferGeometry> {
  readonly mesh: Mesh<Geometry, RawShaderMaterial>;
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();

  constructor(material: RawShaderMaterial, geometry?: Geometry) {
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.layers.enableAll();
    this.scene.add(this.mesh);
  }

  get material(): RawShaderMaterial {
    return this.mesh.material;
  }

  set material(material: RawShaderMaterial) {
    this.mesh.material = material;
  }

  /** Compiles the program without waiting for the result. */
  compile(renderer: WebGLRenderer): void {
    renderer.compile(this.scene, this.camera);
  }

  draw(renderer: WebGLRenderer, geometry: Geometry = this.mesh.geometry, camera: Camera = this.camera): void {
    this.mesh.geometry = geometry;
    renderer.render(this.scene, camera);
  }

  /** Draws once with another material. */
  drawAs(renderer: WebGLRenderer, other: RawShaderMaterial, geometry?: Geometry): void {
    const { material } = this;
    this.material = other;
    this.draw(renderer, geometry);
    this.material = material;
  }
}
