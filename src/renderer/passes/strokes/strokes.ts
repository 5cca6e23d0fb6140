import {
  BufferGeometry,
  CustomBlending,
  DstAlphaFactor,
  MaxEquation,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RedFormat,
  RGBAIntegerFormat,
  UnsignedShortType,
  Vector2,
  ZeroFactor,
  type RawShaderMaterial,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import candidatesShader from '../../../../shaders/strokes/candidates.vert';
import composeShader from '../../../../shaders/strokes/compose.frag';
import separationShader from '../../../../shaders/strokes/separation.frag';
import rangesFragmentShader from '../../../../shaders/strokes/strokeRanges.frag';
import rangesVertexShader from '../../../../shaders/strokes/strokeRanges.vert';
import fragmentShader from '../../../../shaders/strokes/strokes.frag';
import vertexShader from '../../../../shaders/strokes/strokes.vert';
import { DrawnMesh } from '../../gpu/drawnMesh.ts';
import { DrawnPoints, FullScreen, pictureMaterial } from '../../gpu/fullScreen.ts';
import type { RowTextures } from '../../gpu/drawnRows.ts';
import type { FrameView, ViewUniforms } from '../../gpu/frameView.ts';
import { pictureTarget, type Targets } from '../targets.ts';
import type { PuffTextures } from '../../gpu/puffTextures.ts';
import { DEFORMED } from '../../gpu/programsAhead.ts';
import type { SurfaceDepth } from '../surfaceDepth.ts';
import { StrokeArcs } from './strokeArcs.ts';

/** Side of the tile of an arc in the targets of samples, texels. */
const TILE = 5;
/** Tiles in a row: as many as the narrowest targets of WebGL 2 have room for. */
const TILES_PER_LINE = 400;

/** Blends ink over a premultiplied picture and keeps its alpha. */
const OVER_PICTURE = {
  blending: CustomBlending,
  blendSrc: DstAlphaFactor,
  blendDst: OneMinusSrcAlphaFactor,
  blendSrcAlpha: ZeroFactor,
  blendDstAlpha: OneFactor,
} as const;

/** The materials that strokes are drawn with, to compile them in advance. */
export function strokeMaterials({ uniforms }: FrameView, isDeformed: boolean): readonly RawShaderMaterial[] {
  const { candidates, ranges, strokes } = new StrokeShaders(uniforms, isDeformed ? DEFORMED : {});
  return [candidates, ranges, strokes, new FullScreen(composeShader, uniforms)].map(({ material }) => material);
}

/**
 * Draws strokes of ink inside the silhouette: arcs of the outlines of lobes that stand before other smoke. Few arcs do. A
 * vertex for each arc finds them by the depth of the picture, the samples of those are compared in a tile for each arc, and
 * the strokes that the samples make are drawn into a target of their own, where the greatest opacity counts, so that their
 * order does not matter.
 */
export class StrokesPass {
  private readonly eye: FrameView;
  private readonly puffs: PuffTextures;
  private readonly uniforms;
  readonly arcs = new StrokeArcs();
  /** The separation of the lobe from the smoke behind it at each sample of each arc. */
  readonly separations: WebGLRenderTarget = opacityTarget();
  /** The stroke at each sample of each arc: shaders/strokes/strokeRanges.frag. Valid where the arc has samples. */
  readonly ranges: WebGLRenderTarget = pictureTarget();
  private readonly coverage = opacityTarget();
  private readonly kinds: Readonly<Record<'plain' | 'deformed', StrokeShaders>>;
  private readonly ink: FullScreen;
  private strokes = 0;

  constructor(eye: FrameView, puffs: PuffTextures) {
    const { separations, ranges, coverage } = this;
    ranges.texture.format = RGBAIntegerFormat;
    ranges.texture.type = UnsignedShortType;
    this.eye = eye;
    this.puffs = puffs;
    this.uniforms = { ...eye.uniforms, ...strokeUniforms(separations.texture, ranges.texture) };
    this.kinds = {
      plain: new StrokeShaders(this.uniforms, {}),
      deformed: new StrokeShaders(this.uniforms, DEFORMED),
    };
    this.ink = new FullScreen(composeShader, { ...eye.uniforms, coverage: { value: coverage.texture } }, OVER_PICTURE);
  }

  /**
   * @param strokes `style.strokes`, 0..1
   * @param pixelRatio pixels of the target for each CSS pixel
   */
  setUniforms(strokes: number, pixelRatio: number): void {
    this.strokes = strokes;
    this.uniforms.pixelRatio.value = pixelRatio;
    this.uniforms.lobeTable.value = this.puffs.lobes.lobeTable;
  }

  /**
   * Draws the opacity of the strokes, after the bodies. Leaves the targets bound.
   * @param drawing index of the drawing, for the boil of lines
   */
  draw(renderer: WebGLRenderer, targets: Targets, bodies: RowTextures, drawing: number, surfaces?: SurfaceDepth): void {
    const { uniforms, coverage, arcs, puffs, eye } = this;
    uniforms.rowPlaces.value = bodies.places;
    uniforms.rowAttributes.value = bodies.attributes;
    uniforms.depth.value = targets.depth;
    uniforms.lit.value = targets.lit;
    uniforms.surfaceDepth.value = surfaces?.depth ?? null;
    uniforms.hasSurfaces.value = surfaces !== undefined;
    uniforms.drawing.value = drawing;
    arcs.find(bodies, puffs.lobes.puffs.lobeCount, this.strokes);
    uniforms.arcs.value = arcs.texture;
    coverage.setSize(targets.width, targets.height);
    const kind = this.kinds[puffs.isDeformed ? 'deformed' : 'plain'];
    if (arcs.count > 0) this.compare(renderer, kind);
    begin(renderer, coverage);
    if (arcs.count > 0) eye.asVariant(kind.strokes, () => kind.drawStrokes(renderer, arcs.count));
    renderer.setRenderTarget(targets.renderTarget);
  }

  /** Draws the ink of the strokes over the bound picture, which is premultiplied. */
  compose(renderer: WebGLRenderer): void {
    this.ink.draw(renderer);
  }

  /** Releases the render targets until the next draw. */
  releaseTargets(): void {
    for (const target of [this.separations, this.ranges, this.coverage]) target.dispose();
  }

  dispose(): void {
    for (const part of [...Object.values(this.kinds), this.arcs, this.ink]) part.dispose();
    this.releaseTargets();
  }

  /** Compares the depth at the samples of the arcs. */
  private compare(renderer: WebGLRenderer, kind: StrokeShaders): void {
    const { separations, ranges, uniforms, arcs } = this;
    const lines = TILE * Math.ceil(arcs.count / TILES_PER_LINE);
    const size = uniforms.tilesSize.value.set(TILE * TILES_PER_LINE, Math.max(lines, separations.height));
    separations.setSize(size.x, size.y);
    ranges.setSize(size.x, size.y);
    begin(renderer, separations);
    kind.candidates.draw(renderer, arcs.count);
    renderer.setRenderTarget(ranges);
    kind.ranges.draw(renderer, arcs.count);
  }
}

/** Binds and clears a target. */
function begin(renderer: WebGLRenderer, target: WebGLRenderTarget): void {
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear(true, false, false);
}

/** The programs for puffs that do not turn, stretch or unfold, or for those that do. */
class StrokeShaders {
  readonly candidates: DrawnPoints;
  readonly ranges: DrawnPoints;
  readonly strokes: DrawnMesh;

  constructor(uniforms: ViewUniforms, kind: Record<string, string>) {
    const defines = { TILE: String(TILE), ...kind };
    this.candidates = new DrawnPoints(candidatesShader, separationShader, uniforms, defines);
    this.ranges = new DrawnPoints(rangesVertexShader, rangesFragmentShader, uniforms, defines);
    const material = pictureMaterial({
      vertexShader,
      fragmentShader,
      uniforms,
      defines,
      blending: CustomBlending,
      blendEquation: MaxEquation,
      blendSrc: OneFactor,
      blendDst: OneFactor,
    });
    this.strokes = new DrawnMesh(material, new BufferGeometry());
  }

  drawStrokes(renderer: WebGLRenderer, arcs: number): void {
    this.strokes.mesh.geometry.setDrawRange(0, 3 * arcs);
    this.strokes.draw(renderer);
  }

  dispose(): void {
    const { candidates, ranges, strokes } = this;
    for (const part of [candidates, ranges, strokes.material, strokes.mesh.geometry]) part.dispose();
  }
}

function strokeUniforms(separations: Texture, ranges: Texture) {
  return {
    depth: { value: null as Texture | null },
    lit: { value: null as Texture | null },
    surfaceDepth: { value: null as Texture | null },
    hasSurfaces: { value: false },
    lobeTable: { value: null as Texture | null },
    arcs: { value: null as Texture | null },
    separations: { value: separations },
    strokes: { value: ranges },
    tilesSize: { value: new Vector2(1, 1) },
    pixelRatio: { value: 1 },
    drawing: { value: 0 },
  };
}

/** A render target with one channel. */
function opacityTarget() {
  const target = pictureTarget();
  target.texture.format = RedFormat;
  return target;
}
