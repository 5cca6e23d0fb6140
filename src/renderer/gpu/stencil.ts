import {
  DoubleSide,
  GLSL3,
  LessDepth,
  RawShaderMaterial,
  type Mesh,
  type ShaderMaterialParameters,
  type WebGLRenderer,
} from 'three';

/** Stencil operations of a face for fragments that fail and that pass the depth test, as WebGL enums. */
export interface FaceCount {
  depthFail: number;
  depthPass: number;
}

/** A material that only counts in the stencil: double-sided, depth-tested, without colour and depth writes. */
export function countingMaterial(
  shaders: Pick<ShaderMaterialParameters, 'vertexShader' | 'fragmentShader' | 'uniforms' | 'defines'>,
): RawShaderMaterial {
  return new RawShaderMaterial({
    ...shaders,
    glslVersion: GLSL3,
    side: DoubleSide,
    colorWrite: false,
    depthWrite: false,
    depthFunc: LessDepth,
    stencilWrite: true,
  });
}

/**
 * Gives the front and the back faces of a mesh different stencil operations. three.js sets one operation for both. Here
 * its state cache is set to the operations of the material (all Keep), so that its own call before the draw call is
 * skipped. After the draw call the context state is reset to match the cache.
 */
export function countFaces(mesh: Mesh, front: FaceCount, back: FaceCount): void {
  mesh.onBeforeRender = (renderer: WebGLRenderer) => {
    const gl = renderer.getContext();
    renderer.state.buffers.stencil.setOp(gl.KEEP, gl.KEEP, gl.KEEP);
    gl.stencilOpSeparate(gl.FRONT, gl.KEEP, front.depthFail, front.depthPass);
    gl.stencilOpSeparate(gl.BACK, gl.KEEP, back.depthFail, back.depthPass);
  };
  mesh.onAfterRender = (renderer: WebGLRenderer) => {
    const gl = renderer.getContext();
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
  };
}
