import { NearestFilter, WebGLRenderTarget, type IUniform } from 'three';
import { FullScreen, type DrawnDepth } from '../../internal.ts';

/** Depths in these steps; the depth buffer has 24 bits. */
const STEPS = 1 << 24;

// Four times six bits, because not every GPU can draw to float targets, and some browsers falsify the lowest bits of what
// is read.
const SHADER = /* glsl */ `
precision highp float;
precision highp int;
uniform highp sampler2D depth;
out vec4 pixel;
void main() {
  uint steps = min(uint(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r * 16777216.0), 0xffffffu);
  pixel = vec4((((uvec4(steps) >> uvec4(0u, 6u, 12u, 18u)) & 0x3fu) << 2u) | 2u) / 255.0;
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
    return Float32Array.from({ length: width * height }, (_, pixel) => {
      const [a, b, c, d] = bytes.subarray(4 * pixel, 4 * pixel + 4).map((byte) => byte >> 2);
      const steps = a | (b << 6) | (c << 12) | (d << 18);
      return steps < STEPS - 1 ? (near * far) / (far - (steps / STEPS) * (far - near)) : Infinity;
    });
  }

  dispose(): void {
    this.pass.dispose();
    this.target.dispose();
  }
}
