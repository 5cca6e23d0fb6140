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
  DataTexture,
  FloatType,
  NearestFilter,
  RedFormat,
} from 'three';
import addFragmentShader from '../../../shaders/debugViews/add.frag';
import colorsFragmentShader from '../../../shaders/debugViews/colors.frag';
import coverageFragmentShader from '../../../shaders/debugViews/coverage.frag';
import countsFragmentShader from '../../../shaders/debugViews/counts.frag';
import depthFragmentShader from '../../../shaders/debugViews/depth.frag';
import type { RowGeometry } from '../gpu/drawnRows.ts';
import type { FrameView } from '../gpu/frameView.ts';
import { ADDS, FullScreen } from '../gpu/fullScreen.ts';
import type { DebugView } from '../../parameters/quality.ts';
import type { BodiesPass } from './bodies.ts';
import type { SurfaceDepth } from './surfaceDepth.ts';
import type { Targets } from './targets.ts';
import type { VolumesPass } from './volumes.ts';

/** A draw call that can be repeated with another material. */
interface Redrawn {
  readonly pass: Pick<VolumesPass, 'material' | 'drawAs'>;
  readonly rows: RowGeometry;
}

/** Shows intermediate results of the passes instead of the picture. Shaders are compiled when a view is first drawn. */
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

  /** Draws puffs with their normals as colours into the targets. */
  drawNormals(renderer: WebGLRenderer, body: BodiesPass, rows: RowGeometry, surfaces: SurfaceDepth | undefined): void {
    body.drawAs(renderer, this.variantOf(body.material, 'NORMALS'), rows, surfaces);
  }

  /** Replaces the contents of the targets by the number of fragments drawn at each pixel, hidden ones included. */
  countOverdraw(renderer: WebGLRenderer, drawn: readonly Redrawn[]): void {
    renderer.clear(true, false, false);
    this.number.value = 1;
    for (const { pass, rows } of drawn) pass.drawAs(renderer, this.variantOf(pass.material, 'OVERDRAW'), rows);
  }

  /** Uploads the grid of the occlusion culling for the coverage view. */
  setGrid(grid: GridOfDepths | undefined): void {
    this.grid.write(this.eye, grid);
  }

  /** Replaces the contents of the targets by the stencil counts, one draw call for each bit. */
  copyCounts(renderer: WebGLRenderer): void {
    this.adding ??= this.makeAdding();
    renderer.clear(true, false, false);
    for (let bit = 1; bit < 256; bit *= 2) {
      this.number.value = bit;
      this.adding.material.stencilFuncMask = bit;
      this.adding.draw(renderer);
    }
  }

  /**
   * Draws a view of the contents of the targets.
   * @param output render target, or null for the canvas
   */
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

  /** Sets the depth range to that of the box of all receivers. */
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

  /** Returns a variant of a material that outputs normals as colours, or adds 1 for each fragment. */
  private variantOf(source: RawShaderMaterial, kind: 'NORMALS' | 'OVERDRAW'): RawShaderMaterial {
    const key = `${kind} ${source.uuid}`;
    const variant = this.variants.get(key) ?? this.makeVariant(source, kind);
    this.variants.set(key, variant);
    return variant;
  }

  private makeVariant(source: RawShaderMaterial, kind: 'NORMALS' | 'OVERDRAW'): RawShaderMaterial {
    const { vertexShader, defines, side, uniforms } = source;
    if (kind === 'NORMALS') {
      const fragmentShader = source.fragmentShader.replace(/}\s*$/, NORMALS_OUTPUT);
      return new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, defines, side, uniforms });
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

/** The end of the shader of bodies that outputs normals; an alpha of 1/2 marks them, see debugViews/colors.frag. */
const NORMALS_OUTPUT = 'unlit = vec4(0.5 + 0.5 * normalize(normal), 1.0); lit = vec4(unlit.rgb, 0.5); }';

/** Fragment shaders of the views; the default is the shader of the colour views. */
const SHOWING: Partial<Record<DebugView, string>> = {
  depth: depthFragmentShader,
  counts: countsFragmentShader,
  overdraw: countsFragmentShader,
  coverage: coverageFragmentShader,
};

/** The fields of the grid of src/simulator/view.ts that the debug view reads. */
interface GridOfDepths {
  readonly columns: number;
  readonly rows: number;
  /** Distance between rows, in cells. */
  readonly stride: number;
  /** Lower left corner on the image plane at unit depth, and cells for each unit of that plane. */
  readonly corner: readonly [number, number];
  readonly density: number;
  /** Depths along the camera's forward direction, measured from the world origin; Infinity for uncovered cells. */
  readonly depths: Float32Array;
}

/** Stands in for Infinity, because GLSL implementations need not support infinite values. */
const UNCOVERED = 1e30;

/** A grid as a texture of view depths, with its placement on the image plane. */
class GridTexture {
  readonly uniforms = {
    grid: { value: null as Texture | null },
    gridCells: { value: new Vector2() },
    gridPlace: { value: new Vector3() },
  };
  private texture: DataTexture | undefined;

  /** Uploads a grid. Without one, no cell is covered. */
  write(eye: FrameView, grid: GridOfDepths | undefined): void {
    this.dispose();
    const { columns, rows, stride, corner, density, depths } = grid ?? EMPTY;
    const eyeDepth = eye.range[0] - eye.uniforms.near.value;
    const values = depths.map((depth) => (depth < UNCOVERED ? depth - eyeDepth : UNCOVERED));
    this.texture = new DataTexture(values, stride, rows, RedFormat, FloatType);
    [this.texture.minFilter, this.texture.magFilter] = [NearestFilter, NearestFilter];
    this.texture.needsUpdate = true;
    this.uniforms.grid.value = this.texture;
    this.uniforms.gridCells.value.set(columns, rows);
    this.uniforms.gridPlace.value.set(...corner, density);
  }

  dispose(): void {
    this.texture?.dispose();
    this.texture = undefined;
  }
}

const EMPTY: GridOfDepths = {
  columns: 0,
  rows: 1,
  stride: 1,
  corner: [0, 0],
  density: 1,
  depths: new Float32Array([Infinity]),
};
