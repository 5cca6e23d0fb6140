import {
  CustomBlending,
  LessEqualStencilFunc,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SrcAlphaFactor,
  Vector2,
  ZeroFactor,
  type IUniform,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import amountCode from '../../shaders/patterns/amount.glsl';
import coverageCode from '../../shaders/patterns/coverage.glsl';
import marksFragmentShader from '../../shaders/patterns/marks.frag';
import marksVertexShader from '../../shaders/patterns/marks.vert';
import placeCode from '../../shaders/patterns/place.glsl';
import tilesShader from '../../shaders/patterns/tiles.frag';
import { EDGE_TILE } from '../base/constants.ts';
import type { FrameView } from './gpu/frameView.ts';
import { DrawnPoints, FullScreen } from './gpu/fullScreen.ts';
import { fullFromOf } from './palette.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import { ShaderVariant, withCode, type AddedCode } from './gpu/shaderVariant.ts';
import type { Style } from './style.ts';
import { pictureTarget, type Targets } from './passes/targets.ts';

/** Marks that are placed across the view beside the centre of their puff. Others follow the form of the puff. */
const FLAT = new Set<Style['pattern']>(['dots', 'grain']);
/** Radii by which dots roll for a full turn of the camera. A multiple of all pitches, so that the first turn joins the second. */
const CIRCUMFERENCE = 6;
const FINEST = 4;

const AMOUNTS: AddedCode = { define: 'AMOUNTS', declared: 'AMOUNTS', code: amountCode };
const COVERAGE: AddedCode = { define: 'MARKS', declared: 'withMarks', code: coverageCode };

function placesOf(pattern: Style['pattern']): AddedCode {
  const code = FLAT.has(pattern) ? `#define FLAT_PLACE\n${placeCode}` : placeCode;
  return { define: 'PLACES', declared: 'packPlace', code };
}

type Defines = Record<string, string>;

/** A define of the shaders of marks. */
type Ground = 'ON_SMOKE' | 'ON_SURFACES' | 'ON_BACKDROP';

function groundsOf({ patternOn, patternCoverage, patternBackdrop }: Style): Ground[] {
  return [
    ...(patternCoverage > 0 ? (['ON_SMOKE'] as const) : []),
    ...(patternCoverage > 0 && patternOn !== 'tones' ? (['ON_SURFACES'] as const) : []),
    ...(patternBackdrop > 0 ? (['ON_BACKDROP'] as const) : []),
  ];
}

/** Shaders as they are drawn with a pattern. */
export function withPattern(shaders: Shaders, pattern: Style['pattern']): Shaders {
  return [placesOf(pattern), AMOUNTS, COVERAGE].reduce(withCode, shaders);
}

/**
 * Draws the marks of a print: dots and grain that move with the puffs and roll over them as the camera turns, and lines that
 * follow their form, all at a constant density on screen. Marks are a share of each pixel, which the last step of the frame
 * mixes in after edges are smoothed.
 */
export class PatternPass {
  /** The chosen tones, and the amount of marks with the opacity of ink. */
  private readonly chosen = pictureTarget(2);
  /** Code for bodies, for the choice of tones and for the last step of the frame. */
  variants: readonly ShaderVariant[] = [];
  private readonly eye: FrameView;
  private readonly coverage = pictureTarget();
  private readonly marked = pictureTarget();
  private readonly uniforms = {
    places: { value: null as Texture | null },
    amounts: { value: null as Texture | null },
    depth: { value: null as Texture | null },
    tiles: { value: null as Texture | null },
    coverage: { value: null as Texture | null },
    patterned: { value: new Vector2() },
    fullFrom: { value: 0 },
    pitchPixels: { value: 1 },
    softnessPixels: { value: 0 },
    tilt: { value: new Vector2() },
    rolled: { value: new Vector2() },
    rollPart: { value: 1 / FINEST },
    fullTurn: { value: CIRCUMFERENCE },
    shift: { value: new Vector2() },
    lowestTile: { value: new Vector2() },
    highestTile: { value: new Vector2() },
    isLinear: { value: false },
  };
  private readonly tiles: FullScreen;
  private readonly made = new Map<string, DrawnPoints | FullScreen>();
  private readonly codes;
  private kind: Style['pattern'] = 'none';
  /** What the marks are on. */
  private grounds: readonly Ground[] = [];

  constructor(eye: FrameView) {
    this.eye = eye;
    const { patterned, fullFrom, coverage, amounts, depth } = this.uniforms;
    const { patternCoverage, patternBackdrop, patternColor } = eye.uniforms;
    const uniforms = { patterned, fullFrom, coverage, depth, patternCoverage, patternBackdrop, patternColor };
    this.tiles = new FullScreen(tilesShader, { amounts });
    const variant = (code: AddedCode) => new ShaderVariant(code, uniforms);
    this.codes = {
      flat: variant(placesOf('dots')),
      form: variant(placesOf('lines')),
      others: [AMOUNTS, COVERAGE].map(variant),
    };
  }

  /** @param pixelRatio pixels of the target for each CSS pixel */
  setStyle(style: Style, pixelRatio: number): void {
    const { uniforms, codes } = this;
    const { pattern, patternOn, patternSize, patternSoftness, patternShiftX, patternShiftY, patternAngle } = style;
    this.kind = pattern;
    this.grounds = groundsOf(style);
    this.variants = [FLAT.has(pattern) ? codes.flat : codes.form, ...codes.others];
    // Grain has no direction, and repeats along one axis only.
    const angle = pattern === 'grain' ? 0 : (patternAngle * Math.PI) / 180;
    const size = patternSize * pixelRatio;
    uniforms.tilt.value.set(Math.cos(angle), Math.sin(angle));
    uniforms.pitchPixels.value = size;
    uniforms.softnessPixels.value = patternSoftness * pixelRatio;
    uniforms.patterned.value.set(Number(patternOn !== 'tones'), Number(patternOn !== 'shadow'));
    uniforms.fullFrom.value = fullFromOf(style);
    const shift = uniforms.shift.value.set(patternShiftX, patternShiftY).multiplyScalar(pixelRatio).round();
    // No mark is larger than their distance.
    const reach = pattern === 'dots' ? Math.ceil(size + patternSoftness * pixelRatio) : 0;
    const tileOf = (pixels: number) => Math.floor(pixels / EDGE_TILE);
    uniforms.lowestTile.value.set(tileOf(-shift.x - reach), tileOf(-shift.y - reach));
    const last = EDGE_TILE - 1 + reach;
    uniforms.highestTile.value.set(tileOf(last - shift.x), tileOf(last - shift.y));
  }

  /** @returns where tones and amounts are to be drawn */
  begin({ places, depth, width, height }: Targets): WebGLRenderTarget {
    const { uniforms, chosen, marked, coverage } = this;
    chosen.setSize(width, height);
    coverage.setSize(width, height);
    uniforms.places.value = places;
    uniforms.depth.value = depth;
    uniforms.amounts.value = chosen.textures[1];
    uniforms.tiles.value = marked.texture;
    uniforms.coverage.value = coverage.texture;
    return chosen;
  }

  /** Draws the marks after the tones are chosen. */
  draw(renderer: WebGLRenderer): void {
    const { marked, coverage } = this;
    this.roll();
    const { width, height } = coverage;
    const [columns, rows] = [width, height].map((pixels) => Math.ceil(pixels / EDGE_TILE));
    marked.setSize(columns, rows);
    renderer.setRenderTarget(marked);
    this.tiles.draw(renderer);
    renderer.setRenderTarget(coverage);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, false, false);
    for (const points of this.points) points.draw(renderer, columns * rows);
  }

  /** What it draws with. */
  meshes(): readonly (FullScreen | DrawnPoints)[] {
    return [this.tiles, ...this.points];
  }

  /**
   * Draws marks over the bound framebuffer where the stencil is at least 1.
   * @param depth of the host's objects, in the viewport of the smoke
   * @param isLinear whether the framebuffer holds linear colours instead of display-encoded ones
   */
  drawOnHost(renderer: WebGLRenderer, depth: Texture, isLinear: boolean): void {
    this.roll();
    this.uniforms.depth.value = depth;
    this.uniforms.isLinear.value = isLinear;
    const make = (defines: Defines) => new FullScreen(marksFragmentShader, this.all, { ...OVER_SHADOW, defines });
    (this.marksOf(['ON_SURFACES', 'ON_HOST'], make) as FullScreen).draw(renderer);
  }

  /** Releases the render targets until the next draw. */
  releaseTargets(): void {
    for (const target of [this.chosen, this.coverage, this.marked]) target.dispose();
  }

  dispose(): void {
    this.tiles.dispose();
    for (const marks of this.made.values()) marks.dispose();
    this.releaseTargets();
  }

  private get points(): DrawnPoints[] {
    return this.grounds.map((ground) => {
      const make = (defines: Defines) => new DrawnPoints(marksVertexShader, marksFragmentShader, this.all, defines);
      return this.marksOf([ground], make) as DrawnPoints;
    });
  }

  private get all(): Record<string, IUniform> {
    return { ...this.eye.uniforms, ...this.uniforms };
  }

  private marksOf(
    added: readonly string[],
    make: (defines: Defines) => DrawnPoints | FullScreen,
  ): DrawnPoints | FullScreen {
    const { kind, uniforms, made } = this;
    const { x, y } = uniforms.shift.value;
    const isShifted = x !== 0 || y !== 0;
    const names = [
      kind.toUpperCase(),
      ...(FLAT.has(kind) ? ['FLAT_PLACE'] : []),
      ...(isShifted ? ['SHIFTED'] : []),
      ...added,
    ];
    const name = names.join();
    const marks = made.get(name) ?? make(Object.fromEntries(names.map((each) => [each, ''])));
    made.set(name, marks);
    return marks;
  }

  /** Rolls dots over their puffs with the direction of view, as the front of a ball that turns. */
  private roll(): void {
    const { tilt, rolled } = this.uniforms;
    const { x: across, y: up } = tilt.value;
    const { x, y, z } = this.eye.forward;
    const turns = Math.atan2(-x, -z) / (2 * Math.PI);
    const elevation = Math.asin(Math.max(-1, Math.min(1, -y)));
    const way = (share: number) => (Math.round(CIRCUMFERENCE * FINEST * share) / FINEST) * turns;
    rolled.value.set(way(across) + elevation * up, way(-up) + elevation * across);
  }
}

/** Blends over what is in shadow, and keeps its alpha. */
const OVER_SHADOW = {
  blending: CustomBlending,
  blendSrc: SrcAlphaFactor,
  blendDst: OneMinusSrcAlphaFactor,
  blendSrcAlpha: ZeroFactor,
  blendDstAlpha: OneFactor,
  stencilWrite: true,
  stencilWriteMask: 0,
  stencilFunc: LessEqualStencilFunc,
  stencilRef: 1,
} as const;
