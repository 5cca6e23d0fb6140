import { BufferGeometry, Object3D, Scene, type IUniform, type RawShaderMaterial, type WebGLRenderer } from 'three';
import { pictureMaterial } from './fullScreen.ts';
import { PassCamera } from './drawnMesh.ts';
import type { Shaders } from './programsAhead.ts';

/** What three.js draws as points. Its class for them would bring another material into the package. */
class PointsWithoutAttributes extends Object3D {
  readonly isPoints = true;
  readonly geometry: BufferGeometry = new BufferGeometry();
  readonly material: RawShaderMaterial;

  constructor(material: RawShaderMaterial) {
    super();
    this.material = material;
    this.frustumCulled = false;
  }
}

/** Points without attributes: the vertex shader places each by `gl_VertexID`. They neither test nor write depth. */
export class DrawnPoints {
  private readonly points: PointsWithoutAttributes;
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();

  constructor(
    vertexShader: string,
    fragmentShader: string,
    uniforms: Record<string, IUniform>,
    defines: Shaders['defines'] = {},
  ) {
    this.points = new PointsWithoutAttributes(pictureMaterial({ vertexShader, fragmentShader, uniforms, defines }));
    this.scene.add(this.points);
  }

  get material(): RawShaderMaterial {
    return this.points.material;
  }

  draw(renderer: WebGLRenderer, count: number): void {
    this.points.geometry.setDrawRange(0, count);
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.points.geometry.dispose();
    this.points.material.dispose();
  }
}
