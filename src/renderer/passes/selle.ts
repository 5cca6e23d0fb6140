import { GLSL3, RawShaderMaterial, type Texture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import linesFragmentShader from '../../../shaders/selle/lines.frag';
import fragmentShader from '../../../shaders/selle/selle.frag';
import vertexShader from '../../../shaders/selle/selle.vert';
import { DrawnRows, type RowGeometry } from '../gpu/drawnRows.ts';
import type { FrameView } from '../gpu/frameView.ts';
import { FullScreen } from '../gpu/fullScreen.ts';
import type { PuffTextures } from '../gpu/puffTextures.ts';
import type { RampTexture } from '../gpu/ramps.ts';
import type { Targets } from './targets.ts';

/**
 * Smoke as Selle, Mohr and Chenney drew it ('Cartoon Rendering of Smoke Animations', NPAR 2004), for comparison:
 * unshaded puffs of constant depth, and lines one pixel wide at discontinuities of the depth buffer. No shadows.
 */
export class SellePass {
  private readonly eye: FrameView;
  private readonly puffs: PuffTextures;
  private readonly common;
  private readonly lineUniforms;
  private readonly lines: FullScreen;
  private readonly rows: DrawnRows;

  constructor(eye: FrameView, puffs: PuffTextures, ramps: RampTexture) {
    this.eye = eye;
    this.puffs = puffs;
    this.common = {
      ...eye.uniforms,
      ramps: { value: ramps.texture },
      colorCoverage: { value: null as Texture | null },
      pad: { value: 1 },
    };
    this.lineUniforms = {
      clipFromView: eye.uniforms.clipFromView,
      unlit: { value: null as Texture | null },
      lit: { value: null as Texture | null },
      depth: { value: null as Texture | null },
      inkColor: eye.uniforms.inkColor,
      /** Depth gap beyond which a line is drawn, metres. */
      threshold: { value: 0 },
    };
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: this.common,
    });
    this.rows = new DrawnRows(material);
    this.lines = new FullScreen(linesFragmentShader, this.lineUniforms);
  }

  /** Draws the puffs into the targets and then the picture with lines, in place of the resolve pass. */
  draw(
    renderer: WebGLRenderer,
    targets: Targets,
    { geometry, places }: { geometry: RowGeometry; places: Float32Array },
    { outlines, innerLine }: { outlines: boolean; innerLine: number },
    output: WebGLRenderTarget | null,
  ): void {
    // Read on each draw: billboards are baked on first access, and the puffs may have changed.
    const { layers, colorCoverage } = this.puffs.billboards;
    this.common.colorCoverage.value = colorCoverage;
    this.common.pad.value = layers.pad;
    this.eye.asVariant(this.rows, () => this.rows.draw(renderer, geometry));
    this.lineUniforms.threshold.value = outlines ? innerLine * meanRadiusOf(places) : Infinity;
    this.lineUniforms.unlit.value = targets.unlit;
    this.lineUniforms.lit.value = targets.lit;
    this.lineUniforms.depth.value = targets.depth;
    renderer.setRenderTarget(output);
    this.lines.draw(renderer);
  }

  dispose(): void {
    this.lines.dispose();
    this.rows.material.dispose();
  }
}

/** Mean radius of rows in metres; 0 without rows. */
function meanRadiusOf(places: Float32Array): number {
  let sum = 0;
  for (let at = 3; at < places.length; at += 4) sum += places[at];
  return sum / Math.max(1, places.length / 4);
}
