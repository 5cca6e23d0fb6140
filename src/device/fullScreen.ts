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
import vertexShader from '../../shaders/lib/fullScreen.vert';
import { DrawnMesh } from './drawnMesh.ts';

/** Blending that adds to what stands. */
export const ADDS = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: OneFactor,
  blendDst: OneFactor,
} as const satisfies ShaderMaterialParameters;

/**
 * Draws one fragment shader over the whole viewport, by one triangle, and owns its material.
 * Without further parameters it replaces what stands, and neither reads nor writes depth and stencil.
 */
export class FullScreen extends DrawnMesh {
  constructor(
    fragmentShader: string,
    uniforms: Record<string, IUniform>,
    parameters: Omit<ShaderMaterialParameters, 'vertexShader' | 'fragmentShader' | 'uniforms'> = {},
  ) {
    super(
      triangle(),
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader,
        uniforms,
        depthTest: false,
        depthWrite: false,
        blending: NoBlending,
        ...parameters,
      }),
    );
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}

/** One that covers the whole viewport. */
export function triangle(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
  geometry.setDrawRange(0, 3);
  return geometry;
}
