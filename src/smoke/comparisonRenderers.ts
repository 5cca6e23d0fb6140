import type { BufferGeometry } from 'three';
import { SellePass } from '../passes/selle.ts';
import { ShadowMapPass, type ShadowMapSources } from '../passes/shadowMap.ts';
import { SpritesPass } from '../passes/sprites.ts';
import type { FrameInput } from './frameInput.ts';
import type { SmokePasses } from './smokePasses.ts';
import type { ComparisonRenderer } from './style.ts';

/** The resources of the comparison passes. */
export interface ComparisonSources extends ShadowMapSources {
  readonly bodies: BufferGeometry;
}

/** The passes of the comparison renderers, each created on first use. */
export class ComparisonRenderers {
  private readonly sources: ComparisonSources;
  private sellePass: SellePass | undefined;
  private spritesPass: SpritesPass | undefined;
  private shadowMapPass: ShadowMapPass | undefined;

  constructor(sources: ComparisonSources) {
    this.sources = sources;
  }

  get selle(): SellePass {
    const { eye, puffs, ramps, bodies } = this.sources;
    this.sellePass ??= new SellePass(eye, puffs, ramps, bodies);
    return this.sellePass;
  }

  get sprites(): SpritesPass {
    const { eye, ramps, bodies } = this.sources;
    this.spritesPass ??= new SpritesPass(eye, ramps, bodies);
    return this.spritesPass;
  }

  get shadowMap(): ShadowMapPass {
    this.shadowMapPass ??= new ShadowMapPass(this.sources);
    return this.shadowMapPass;
  }

  /** Draws the smoke of a frame with a comparison renderer, after the surfaces. */
  draw(kind: ComparisonRenderer, passes: SmokePasses, input: FrameInput): void {
    ways[kind](this, passes, input);
  }

  /** Disposes of all passes. They are created again on next use. */
  dispose(): void {
    for (const pass of [this.sellePass, this.spritesPass, this.shadowMapPass]) pass?.dispose();
    this.sellePass = this.spritesPass = this.shadowMapPass = undefined;
  }
}

type DrawSmoke = (comparisons: ComparisonRenderers, passes: SmokePasses, input: FrameInput) => void;

/** How each comparison renderer draws a frame after the surfaces. */
const ways: Readonly<Record<ComparisonRenderer, DrawSmoke>> = {
  selle(comparisons, { renderer, targets, bodies }, { style, output }) {
    const { outlines, innerLine, inkColor } = style;
    comparisons.selle.setLines(inkColor, outlines ? innerLine * bodies.meanRadius : Infinity);
    comparisons.selle.draw(renderer);
    comparisons.selle.drawLines(renderer, targets, output);
  },

  sprites(comparisons, { renderer, targets, resolve }, { output }) {
    resolve.draw(renderer, targets, output);
    comparisons.sprites.draw(renderer, targets, output);
  },

  shadowMap(comparisons, passes, { style, rigids, parts = [], output }) {
    const { renderer, targets, body, resolve, extras } = passes;
    body.draw(renderer);
    if (style.shadows) {
      const { shadowMap } = comparisons;
      shadowMap.setForm(extras.billboardsOf(style.form));
      passes.placeSurfaces(rigids, parts, [shadowMap]);
      shadowMap.draw(renderer, targets);
    }
    resolve.draw(renderer, targets, output);
  },
};
