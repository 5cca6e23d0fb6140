import { type Texture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import copyShader from '../../../shaders/resolve/copy.frag';
import edgesShader from '../../../shaders/resolve/edges.frag';
import edgesVertexShader from '../../../shaders/resolve/edges.vert';
import tilesShader from '../../../shaders/resolve/tiles.frag';
import tonesShader from '../../../shaders/resolve/tones.frag';
import vertexShader from '../../../shaders/lib/fullScreen.vert';
import { EDGE_TILE } from '../../base/constants.ts';
import type { FrameView } from '../gpu/frameView.ts';
import { DrawnPoints, FEW_TILES, FullScreen } from '../gpu/fullScreen.ts';
import { pictureTarget, type Targets } from './targets.ts';
import type { Shaders } from '../gpu/programsAhead.ts';

/** The colours to resolve, and their size in pixels. */
export type ResolveSources = Pick<Targets, 'unlit' | 'lit' | 'width' | 'height'> &
  Partial<Pick<Targets, 'places' | 'depth'>>;

/** Draws ink over the bound picture. */
export interface InkOverlay {
  compose(renderer: WebGLRenderer): void;
}

/** Draws the marks of a print. */
export interface Marks {
  /** @returns where tones and the amounts of marks are to be drawn */
  begin(targets: Targets): WebGLRenderTarget;
  /** Draws marks for the last step, after the tones are chosen. */
  draw(renderer: WebGLRenderer): void;
}

/** Draws tones that differ from the plain ones into a target. */
export type ChooseTones = (output: WebGLRenderTarget) => void;

/** What tiles.frag writes for tiles with an edge. */
const MARKED = 0xff0000;

/** The shaders of the pass. */
export const RESOLVE_SHADERS: readonly Shaders[] = [
  ...[tonesShader, tilesShader, copyShader].map((fragmentShader) => ({ vertexShader, fragmentShader })),
  { vertexShader: edgesVertexShader, fragmentShader: edgesShader },
];

/**
 * Chooses lit or unlit by the mask, smooths edges, and writes premultiplied colour to the canvas or to a render target.
 * Edge smoothing takes more draw calls, because it reads many neighbours of a pixel and each must be chosen only once.
 * Its shader is expensive, so it runs only in tiles that contain an edge. The others are copied.
 */
export class ResolvePass {
  smoothEdges = true;
  /** Draws marks of a print beneath ink, where tones are chosen. */
  pattern: Marks | undefined;
  /** Ink that is drawn over the picture. */
  overlay: InkOverlay | undefined;
  private readonly uniforms = {
    unlit: { value: null as Texture | null },
    lit: { value: null as Texture | null },
    isLast: { value: false },
  };
  private readonly chosen = pictureTarget();
  private readonly shown = { value: this.chosen.texture };
  private readonly eye: FrameView;
  private readonly tones: FullScreen;
  private readonly marks = pictureTarget();
  private readonly tiles: FullScreen;
  private readonly copy: FullScreen;
  private readonly edges: DrawnPoints;

  constructor(eye: FrameView) {
    this.eye = eye;
    this.tones = new FullScreen(tonesShader, { ...eye.uniforms, ...this.uniforms });
    const smoothing = { tones: this.shown, tiles: { value: this.marks.texture } };
    this.tiles = new FullScreen(tilesShader, smoothing);
    this.copy = new FullScreen(copyShader, smoothing);
    this.edges = new DrawnPoints(edgesVertexShader, edgesShader, smoothing);
  }

  /**
   * @param output render target, or null for the canvas
   * @param choose replaces tones, not premultiplied
   */
  draw(renderer: WebGLRenderer, sources: ResolveSources, output: WebGLRenderTarget | null, choose?: ChooseTones): void {
    this.drawPicture(renderer, sources, output, choose);
    this.overlay?.compose(renderer);
  }

  /** Releases the render targets until the next draw. */
  releaseTargets(): void {
    for (const target of [this.chosen, this.marks]) target.dispose();
  }

  dispose(): void {
    for (const part of [this.tones, this.tiles, this.copy, this.edges]) part.dispose();
    this.releaseTargets();
  }

  private drawPicture(
    renderer: WebGLRenderer,
    sources: ResolveSources,
    output: WebGLRenderTarget | null,
    choose?: ChooseTones,
  ): void {
    const { eye, uniforms, smoothEdges, marks } = this;
    uniforms.unlit.value = sources.unlit;
    uniforms.lit.value = sources.lit;
    uniforms.isLast.value = !smoothEdges && !choose;
    if (uniforms.isLast.value) {
      renderer.setRenderTarget(output);
      this.tones.draw(renderer);
      return;
    }
    const { width, height } = sources;
    const pattern = choose && this.pattern;
    const draw = (pass: FullScreen) => {
      if (pattern) eye.asVariant(pass, () => pass.draw(renderer));
      else pass.draw(renderer);
    };
    const chosen = pattern?.begin(sources as Targets) ?? this.chosen;
    this.shown.value = chosen.texture;
    chosen.setSize(width, height);
    renderer.setRenderTarget(chosen);
    draw(this.tones);
    choose?.(chosen);
    pattern?.draw(renderer);
    if (!smoothEdges) {
      renderer.setRenderTarget(output);
      draw(this.copy);
      return;
    }
    const [columns, rows] = [Math.ceil(width / EDGE_TILE), Math.ceil(height / EDGE_TILE)];
    marks.setSize(columns, rows);
    renderer.setRenderTarget(marks);
    const isSmall = columns * rows <= FEW_TILES;
    if (isSmall) {
      renderer.setClearColor(MARKED, 1);
      renderer.clear(true, false, false);
    } else this.tiles.draw(renderer);
    renderer.setRenderTarget(output);
    if (!isSmall) draw(this.copy);
    const drawEdges = () => this.edges.draw(renderer, columns * rows);
    if (pattern) eye.asVariant(this.edges, drawEdges);
    else drawEdges();
  }
}
