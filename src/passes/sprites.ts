import {
  CustomBlending,
  GLSL3,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import fragmentShader from '../../shaders/sprites/sprites.frag';
import vertexShader from '../../shaders/sprites/sprites.vert';
import { DrawnRows, type RowGeometry } from '../device/drawnRows.ts';
import type { FrameView } from '../device/frameView.ts';
import type { RampTexture } from '../device/ramps.ts';
import type { Targets } from './targets.ts';

/**
 * Smoke as particle libraries usually draw it, for comparison: soft quads blended over the finished picture. Rows must
 * be sorted back to front.
 */
export class SpritesPass {
  private readonly rows: DrawnRows;
  private readonly depth = { value: null as Texture | null };

  constructor(eye: FrameView, ramps: RampTexture) {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: {
        ...eye.uniforms,
        depth: this.depth,
        ramps: { value: ramps.texture },
      },
      depthTest: false,
      depthWrite: false,
      blending: CustomBlending,
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
    });
    this.rows = new DrawnRows(material);
  }

  /** Blends over the resolved picture in `output`, with the surface depth of the targets. */
  draw(
    renderer: WebGLRenderer,
    rows: RowGeometry,
    { depth }: Pick<Targets, 'depth'>,
    output: WebGLRenderTarget | null,
  ): void {
    this.depth.value = depth;
    renderer.setRenderTarget(output);
    this.rows.draw(renderer, rows);
  }

  dispose(): void {
    this.rows.material.dispose();
  }
}
