import {
  Box3,
  DoubleSide,
  EqualStencilFunc,
  GLSL3,
  RawShaderMaterial,
  Vector2,
  Vector3,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import addFragmentShader from '../../shaders/debugViews/add.frag';
import colorsFragmentShader from '../../shaders/debugViews/colors.frag';
import coverageFragmentShader from '../../shaders/debugViews/coverage.frag';
import countsFragmentShader from '../../shaders/debugViews/counts.frag';
import depthFragmentShader from '../../shaders/debugViews/depth.frag';
import type { FrameView } from '../device/frameView.ts';
import { ADDS, FullScreen } from '../device/fullScreen.ts';
import type { DebugView } from '../preset/quality.ts';
import type { BodiesPass } from './bodies.ts';
import { GridTexture, type GridOfDepths } from './gridTexture.ts';
import type { Targets } from './targets.ts';
import type { VolumesPass } from './volumes.ts';

/** What is drawn again, in another material, to be looked at. */
type Redrawn = Pick<BodiesPass | VolumesPass, 'material' | 'drawAs'>;

/** Shows what the passes work with instead of the picture. Nothing of it is compiled before it is asked for. */
export class DebugViewsPass {
  private readonly eye: FrameView;
  private readonly grid = new GridTexture();
  private readonly uniforms = {
    ...this.grid.uniforms,
    unlit: { value: null as Texture | null },
    lit: { value: null as Texture | null },
    depth: { value: null as Texture | null },
    depthRange: { value: new Vector2() },
  };
  private readonly number = { value: 1 };
  private readonly shows = new Map<DebugView, FullScreen>();
  private readonly variants = new Map<string, RawShaderMaterial>();
  private adding: FullScreen | undefined;

  constructor(eye: FrameView) {
    this.eye = eye;
  }

  /** Draws bodies with their normals as colours, into the targets. */
  drawNormals(renderer: WebGLRenderer, body: Redrawn): void {
    body.drawAs(renderer, this.variantOf(body.material, 'NORMALS'));
  }

  /** Counts in the targets what is drawn at each pixel, hidden or not, instead of what is there. */
  countOverdraw(renderer: WebGLRenderer, drawn: readonly Redrawn[]): void {
    renderer.clear(true, false, false);
    this.number.value = 1;
    for (const each of drawn) each.drawAs(renderer, this.variantOf(each.material, 'OVERDRAW'));
  }

  /** Takes up the grid by which hidden bodies were found, for the view of it. */
  setGrid(grid: GridOfDepths | undefined): void {
    this.grid.write(this.eye, grid);
  }

  /** Writes the counts of the stencil into the targets, bit by bit, instead of what is there. */
  copyCounts(renderer: WebGLRenderer): void {
    this.adding ??= this.makeAdding();
    renderer.clear(true, false, false);
    for (let bit = 1; bit < 256; bit *= 2) {
      this.number.value = bit;
      this.adding.material.stencilFuncMask = bit;
      this.adding.draw(renderer);
    }
  }

  /** Shows a view of what stands in the targets. @param output the target to write, or null for the canvas */
  draw(renderer: WebGLRenderer, targets: Targets, view: DebugView, output: WebGLRenderTarget | null): void {
    this.uniforms.unlit.value = targets.unlit;
    this.uniforms.lit.value = targets.lit;
    this.uniforms.depth.value = targets.depth;
    this.measureDepths();
    const show = this.shows.get(view) ?? this.showing(view);
    this.shows.set(view, show);
    renderer.setRenderTarget(output);
    show.draw(renderer);
  }

  dispose(): void {
    for (const show of this.shows.values()) show.dispose();
    for (const variant of this.variants.values()) variant.dispose();
    this.adding?.dispose();
    this.grid.dispose();
    this.shows.clear();
    this.variants.clear();
    this.adding = undefined;
  }

  private showing(view: DebugView): FullScreen {
    return new FullScreen(
      SHOWING[view] ?? colorsFragmentShader,
      { ...this.uniforms, clipFromView: this.eye.uniforms.clipFromView },
      { defines: { VIEW: `${view}View`, RATE: view === 'counts' ? '0.25' : '0.06' } },
    );
  }

  /** The view depths of the box of everything that receives shadow. */
  private measureDepths(): void {
    const { receiversMin, receiversMax, viewFromWorld, near } = this.eye.uniforms;
    const box = new Box3(new Vector3().copy(receiversMin.value), new Vector3().copy(receiversMax.value));
    box.applyMatrix4(viewFromWorld.value);
    const nearest = Math.max(near.value, -box.max.z);
    this.uniforms.depthRange.value.set(nearest, Math.max(nearest + 1e-3, -box.min.z));
  }

  private makeAdding(): FullScreen {
    const stencil = { stencilWrite: true, stencilFunc: EqualStencilFunc, stencilRef: 255 } as const;
    return new FullScreen(addFragmentShader, { number: this.number }, { ...ADDS, ...stencil });
  }

  /** A material that stands where `source` does: with normals for its colours, or one more for each fragment. */
  private variantOf(source: RawShaderMaterial, kind: 'NORMALS' | 'OVERDRAW'): RawShaderMaterial {
    const key = `${kind} ${source.uuid}`;
    const variant = this.variants.get(key) ?? this.makeVariant(source, kind);
    this.variants.set(key, variant);
    return variant;
  }

  private makeVariant(source: RawShaderMaterial, kind: 'NORMALS' | 'OVERDRAW'): RawShaderMaterial {
    const { vertexShader, fragmentShader, defines, side, uniforms } = source;
    if (kind === 'NORMALS') {
      const parts = { vertexShader, fragmentShader, side, uniforms };
      return new RawShaderMaterial({ ...parts, glslVersion: GLSL3, defines: { ...defines, NORMALS: '' } });
    }
    return new RawShaderMaterial({
      ...ADDS,
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader: addFragmentShader,
      depthTest: false,
      depthWrite: false,
      side: DoubleSide,
      defines: { ...defines },
      uniforms: { ...uniforms, number: this.number },
    });
  }
}

/** What shows a view; colours show the others. */
const SHOWING: Partial<Record<DebugView, string>> = {
  depth: depthFragmentShader,
  counts: countsFragmentShader,
  overdraw: countsFragmentShader,
  coverage: coverageFragmentShader,
};
