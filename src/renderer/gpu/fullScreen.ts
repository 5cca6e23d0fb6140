import {
  AddEquation,
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  GLSL3,
  NoBlending,
  OneFactor,
  RawShaderMaterial,
  type IUniform,
  type ShaderMaterialParameters,
  Object3D,
  Scene,
  type WebGLRenderer,
} from 'three';
import coveringShader from '../../../shaders/lib/fullScreen.vert';
import { DrawnMesh, PassCamera } from './drawnMesh.ts';

/** Additive blending. */
export const ADDS = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: OneFactor,
  blendDst: OneFactor,
} as const satisfies ShaderMaterialParameters;

/**
 * Draws a fragment shader over the whole viewport with one triangle, and owns its geometry and material. By default it
 * replaces the destination colour, and neither tests nor writes depth and stencil.
 */
export class FullScreen extends DrawnMesh {
  constructor(
    fragmentShader: string,
    uniforms: Record<string, IUniform>,
    parameters: Omit<ShaderMaterialParameters, 'vertexShader' | 'fragmentShader' | 'uniforms'> = {},
  ) {
    super(pictureMaterial({ vertexShader: coveringShader, fragmentShader, uniforms, ...parameters }), triangle());
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}

/** A material that replaces the destination colour, and neither tests nor writes depth and stencil by default. */
export function pictureMaterial(parameters: ShaderMaterialParameters): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    depthTest: false,
    depthWrite: false,
    blending: NoBlending,
    ...parameters,
  });
}

/** A triangle that covers the whole viewport. */
export function triangle(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
  geometry.setDrawRange(0, 3);
  return geometry;
}

/** Pictures of at most so many tiles are drawn in all of them: finding those that need it takes more draw calls. */
export const FEW_TILES = 64;

/** What three.js draws as points. Its class for them would bring another material into the package. */
class PointsWithoutAttributes extends Object3D {
  readonly isPoints = true;
  readonly geometry: BufferGeometry = new BufferGeometry();
  material: RawShaderMaterial;

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
    defines: Record<string, string> = {},
  ) {
    this.points = new PointsWithoutAttributes(pictureMaterial({ vertexShader, fragmentShader, uniforms, defines }));
    this.scene.add(this.points);
  }

  get material(): RawShaderMaterial {
    return this.points.material;
  }

  set material(material: RawShaderMaterial) {
    this.points.material = material;
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
