import {
  Color as ThreeColor,
  GLSL3,
  Mesh,
  NoBlending,
  RawShaderMaterial,
  Scene,
  type BufferGeometry,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { PassCamera } from '../device/passCamera.ts';
import fullScreenVertexShader from '../../shaders/lib/fullScreen.vert';
import linesFragmentShader from '../../shaders/selle/lines.frag';
import fragmentShader from '../../shaders/selle/selle.frag';
import vertexShader from '../../shaders/selle/selle.vert';
import type { Eye } from '../device/eye.ts';
import { FullScreen } from '../device/fullScreen.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import { writeColor, type Color, type RampTexture } from '../device/ramps.ts';
import type { Targets } from './targets.ts';

/**
 * Smoke as Selle, Mohr and Chenney drew it ('Cartoon Rendering of Smoke Animations', NPAR 2004), for comparison: unshaded
 * puffs of one depth each, and lines one pixel wide where the depth, read back as a texture, jumps. No shadows.
 */
export class SellePass {
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();
  private readonly puffs: PuffTextures;
  private readonly rows: BufferGeometry;
  private readonly common;
  private readonly lineUniforms;
  private readonly lines: FullScreen;
  private material: RawShaderMaterial | undefined;

  constructor(eye: Eye, puffs: PuffTextures, ramps: RampTexture, rows: BufferGeometry) {
    this.puffs = puffs;
    this.rows = rows;
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
      inkColor: { value: new ThreeColor() },
      threshold: { value: 0 },
    };
    this.lines = new FullScreen(
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: fullScreenVertexShader,
        fragmentShader: linesFragmentShader,
        uniforms: this.lineUniforms,
        depthTest: false,
        depthWrite: false,
        blending: NoBlending,
      }),
    );
  }

  /** @param threshold depth gap in metres beyond which there is a line */
  setLines(color: Color, threshold: number): void {
    writeColor(color, this.lineUniforms.inkColor);
    this.lineUniforms.threshold.value = threshold;
  }

  /** Draws the puffs into the targets. */
  draw(renderer: WebGLRenderer): void {
    this.material ??= this.show();
    // Late, because the flat puffs are baked when they are first asked for; each time, because they may be others.
    const { layers, colorCoverage } = this.puffs.billboards;
    this.common.colorCoverage.value = colorCoverage;
    this.common.pad.value = layers.pad;
    renderer.render(this.scene, this.camera);
  }

  /** Draws the picture with its lines: what the resolve pass does elsewhere. */
  drawLines(renderer: WebGLRenderer, targets: Targets, output: WebGLRenderTarget | null): void {
    this.lineUniforms.unlit.value = targets.unlit;
    this.lineUniforms.lit.value = targets.lit;
    this.lineUniforms.depth.value = targets.depth;
    renderer.setRenderTarget(output);
    this.lines.draw(renderer);
  }

  dispose(): void {
    this.lines.dispose();
    this.material?.dispose();
    this.material = undefined;
    this.scene.clear();
  }

  private show(): RawShaderMaterial {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: this.common,
    });
    const mesh = new Mesh(this.rows, material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    return material;
  }
}
