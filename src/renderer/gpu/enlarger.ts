import { LinearFilter, NoColorSpace, UnsignedByteType, Vector2, WebGLRenderTarget, type WebGLRenderer } from 'three';
import fragmentShader from '../../../shaders/enlarger/enlarger.frag';
import { FullScreen } from './fullScreen.ts';

/**
 * Renders at a lower resolution and scales the picture up to the canvas. The canvas keeps its size, so the page layout
 * does not change.
 */
export class Enlarger {
  private readonly picture = new WebGLRenderTarget(1, 1, {
    type: UnsignedByteType,
    colorSpace: NoColorSpace,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });
  private readonly canvas = { value: new Vector2(1, 1) };
  private readonly triangle = new FullScreen(fragmentShader, {
    picture: { value: this.picture.texture },
    canvas: this.canvas,
  });

  /**
   * Returns the render target for the picture.
   * @param width pixels, at least 1
   * @param height pixels, at least 1
   */
  prepare(width: number, height: number): WebGLRenderTarget {
    this.picture.setSize(width, height);
    return this.picture;
  }

  /** Draws the picture scaled to the whole canvas. */
  draw(renderer: WebGLRenderer): void {
    renderer.setRenderTarget(null);
    renderer.getDrawingBufferSize(this.canvas.value);
    this.triangle.draw(renderer);
  }

  dispose(): void {
    this.picture.dispose();
    this.triangle.dispose();
  }
}
