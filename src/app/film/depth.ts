import { NearestFilter, WebGLRenderTarget, type IUniform } from 'three';
import { FullScreen, type DrawnDepth } from '../../internal.ts';

// The bits of a float as four bytes, because not every GPU can draw to float targets.
const SHADER = /* glsl */ `
precision highp float;
precision highp int;
uniform highp sampler2D depth;
out vec4 pixel;
void main() {
  uint bits = floatBitsToUint(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r);
  pixel = vec4((uvec4(bits) >> uvec4(0u, 8u, 16u, 24u)) & 0xffu) / 255.0;
}`;

/** Reads the depth buffer of pictures of one size, as distances along the view axis. */
export class DepthReader {
  private readonly uniforms: Record<'depth', IUniform> = { depth: { value: null } };
  private readonly pass = new FullScreen(SHADER, this.uniforms);
  private readonly target: WebGLRenderTarget;

  /** @param width, height in pixels */
  constructor(width: number, height: number) {
    this.target = new WebGLRenderTarget(width, height, {
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthBuffer: false,
    });
  }

  /**
   * Metres, rows from the bottom up; Infinity where the picture is empty. Must be called in the task that drew the
   * picture.
   */
  read({ renderer, depth, camera }: DrawnDepth): Float32Array<ArrayBuffer> {
    const { width, height } = this.target;
    this.uniforms.depth.value = depth;
    renderer.setRenderTarget(this.target);
    this.pass.draw(renderer);
    const bytes = new Uint8Array(4 * width * height);
    renderer.readRenderTargetPixels(this.target, 0, 0, width, height, bytes);
    renderer.setRenderTarget(null);
    const { near, far } = camera;
    return new Float32Array(bytes.buffer).map((found) =>
      found < 1 ? (near * far) / (far - found * (far - near)) : Infinity,
    );
  }

  dispose(): void {
    this.pass.dispose();
    this.target.dispose();
  }
}
