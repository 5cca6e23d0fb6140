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
} from 'three';
import vertexShader from '../../../shaders/lib/fullScreen.vert';
import { DrawnMesh } from './drawnMesh.ts';

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
    super(pictureMaterial({ vertexShader, fragmentShader, uniforms, ...parameters }), triangle());
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
