import {
  DoubleSide,
  GLSL3,
  LessDepth,
  RawShaderMaterial,
  type Mesh,
  type ShaderMaterialParameters,
  type WebGLRenderer,
} from 'three';

/** What a face does to the stencil when its fragment fails the depth test, and when it passes. WebGL enums. */
export interface FaceCount {
  depthFail: number;
  depthPass: number;
}

/** A material that shows nothing and only counts: both faces, tested against the depth that stands. */
export function countingMaterial(
  shaders: Pick<ShaderMaterialParameters, 'vertexShader' | 'fragmentShader' | 'uniforms'>,
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
 * Lets the front and the back faces of a mesh count differently. three.js knows one set of stencil operations for both,
 * so its cache is filled with the values that the material holds (all Keep), which makes its own call, right before the
 * draw, do nothing; after the draw the context is put back to what the cache says.
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
