import {
  CustomBlending,
  MaxEquation,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RedFormat,
  SrcAlphaFactor,
  Vector2,
  ZeroFactor,
  type RawShaderMaterial,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import composeShader from '../../../shaders/strokes/compose.frag';
import standingFragmentShader from '../../../shaders/strokes/standing.frag';
import standingVertexShader from '../../../shaders/strokes/standing.vert';
import fragmentShader from '../../../shaders/strokes/strokes.frag';
import vertexShader from '../../../shaders/strokes/strokes.vert';
import { DrawnPoints } from '../../device/drawnPoints.ts';
import { DrawnRows, type RowGeometry } from '../../device/drawnRows.ts';
import type { FrameView, ViewUniforms } from '../../device/frameView.ts';
import { FullScreen, pictureMaterial } from '../../device/fullScreen.ts';
import { pictureTarget } from '../../device/pictureTarget.ts';
import type { PuffTextures } from '../../device/puffTextures.ts';
import { DEFORMED } from '../../device/unroll.ts';
import type { SurfaceDepth } from '../surfaceDepth.ts';
import type { Targets } from '../targets.ts';
import { SEGMENTS, StrokeRows } from './strokeRows.ts';

/** Samples of an arc, and arcs in a row of texels. */
const SAMPLES = SEGMENTS + 1;
const ARCS_PER_LINE = 32;
/** Arcs in a row of texels of the candidates. */
const CANDIDATES_PER_LINE = 1024;

/**
 * Draws strokes of ink inside the silhouette: arcs of the outlines of lobes that stand before other smoke. First the depth
 * of the picture is compared at some samples of all arcs, then at all samples of the few arcs that have any. Then the strokes are drawn into a target of their own, where the
 * greatest opacity counts, so that their order does not matter.
 */
export class StrokesPass {
  private readonly puffs: PuffTextures;
  private readonly uniforms;
  private readonly found = new StrokeRows();
  private readonly candidates = opacityTarget();
  private readonly standings = opacityTarget();
  private readonly coverage = opacityTarget();
  private readonly kinds: Readonly<Record<'plain' | 'deformed', StrokeShaders>>;
  /** The draw call of the strokes. */
  readonly strips: DrawnRows;
  private readonly ink: FullScreen;
  private strokes = 0;

  constructor(eye: FrameView, puffs: PuffTextures) {
    this.puffs = puffs;
    this.uniforms = { ...eye.uniforms, ...strokeUniforms(this.candidates.texture, this.standings.texture) };
    this.kinds = {
      plain: new StrokeShaders(this.uniforms, {}),
      deformed: new StrokeShaders(this.uniforms, DEFORMED),
    };
    this.strips = new DrawnRows(this.kinds.plain.strips);
    this.ink = new FullScreen(
      composeShader,
      { ...eye.uniforms, coverage: { value: this.coverage.texture } },
      {
        blending: CustomBlending,
        blendSrc: SrcAlphaFactor,
        blendDst: OneMinusSrcAlphaFactor,
        blendSrcAlpha: ZeroFactor,
        blendDstAlpha: OneFactor,
      },
    );
  }

  /**
   * @param strokes `style.strokes`, 0..1
   * @param pixelRatio pixels of the target for each CSS pixel
   */
  follow(strokes: number, pixelRatio: number): void {
    this.strokes = strokes;
    this.uniforms.pixelRatio.value = pixelRatio;
    this.uniforms.lobeTable.value = this.puffs.lobes.lobeTable;
    this.strips.material = this.kind.strips;
  }

  /**
   * Draws the opacity of the strokes, after the bodies. Leaves the targets bound.
   * @param drawing index of the drawing, for the boil of lines
   */
  draw(renderer: WebGLRenderer, targets: Targets, bodies: RowGeometry, drawing: number, surfaces?: SurfaceDepth): void {
    const { uniforms, coverage, found } = this;
    uniforms.depth.value = targets.depth;
    uniforms.lit.value = targets.lit;
    uniforms.surfaceDepth.value = surfaces?.depth ?? null;
    uniforms.hasSurfaces.value = surfaces !== undefined;
    uniforms.drawing.value = drawing;
    const strips = found.find(bodies.rows, this.puffs.lobes.puffs.lobeCount, this.strokes);
    this.compare(renderer, strips);
    coverage.setSize(targets.width, targets.height);
    renderer.setRenderTarget(coverage);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, false, false);
    this.strips.draw(renderer, strips);
    renderer.setRenderTarget(targets.renderTarget);
  }

  /** Draws the ink of the strokes over the bound target of tones, which are not premultiplied. */
  compose(renderer: WebGLRenderer): void {
    this.ink.draw(renderer);
  }

  /** Releases the render targets until the next draw. */
  rest(): void {
    for (const target of [this.candidates, this.standings, this.coverage]) target.dispose();
  }

  dispose(): void {
    for (const part of [...Object.values(this.kinds), this.found, this.ink]) part.dispose();
    this.rest();
  }

  private get kind(): StrokeShaders {
    return this.puffs.isDeformed ? this.kinds.deformed : this.kinds.plain;
  }

  /** Compares the depth at the samples. */
  private compare(renderer: WebGLRenderer, strips: RowGeometry): void {
    const { count } = strips.rows;
    if (count === 0) return;
    const { candidates, standings, uniforms, kind } = this;
    strips.bind(kind.strips);
    fit(candidates, uniforms.candidatesSize.value, CANDIDATES_PER_LINE, Math.ceil(count / CANDIDATES_PER_LINE));
    renderer.setRenderTarget(candidates);
    kind.candidates.draw(renderer, count);
    fit(standings, uniforms.standingsSize.value, SAMPLES * ARCS_PER_LINE, Math.ceil(count / ARCS_PER_LINE));
    renderer.setRenderTarget(standings);
    kind.samples.draw(renderer, SAMPLES * count);
  }
}

/** Gives a target at least this size, and `size` the size that it has. */
function fit(target: WebGLRenderTarget, size: Vector2, width: number, height: number): void {
  target.setSize(width, Math.max(height, target.height));
  size.set(target.width, target.height);
}

/** The programs for puffs that do not turn, stretch or unfold, or for those that do. */
class StrokeShaders {
  readonly strips: RawShaderMaterial;
  readonly candidates: DrawnPoints;
  readonly samples: DrawnPoints;

  constructor(uniforms: ViewUniforms, kind: Record<string, string>) {
    const defines = { SEGMENTS: String(SEGMENTS), ...kind };
    const points = (more: Record<string, string>) =>
      new DrawnPoints(standingVertexShader, standingFragmentShader, uniforms, { ...defines, ...more });
    this.candidates = points({ CANDIDATES: '' });
    this.samples = points({});
    this.strips = pictureMaterial({
      vertexShader,
      fragmentShader,
      uniforms,
      defines,
      blending: CustomBlending,
      blendEquation: MaxEquation,
      blendSrc: OneFactor,
      blendDst: OneFactor,
    });
  }

  dispose(): void {
    for (const part of [this.candidates, this.samples, this.strips]) part.dispose();
  }
}

function strokeUniforms(candidates: Texture, standings: Texture) {
  return {
    depth: { value: null as Texture | null },
    lit: { value: null as Texture | null },
    surfaceDepth: { value: null as Texture | null },
    hasSurfaces: { value: false },
    lobeTable: { value: null as Texture | null },
    candidates: { value: candidates },
    candidatesSize: { value: new Vector2(1, 1) },
    standings: { value: standings },
    standingsSize: { value: new Vector2(1, 1) },
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
