import { SellePass } from '../passes/selle.ts';
import { ShadowMapPass, type ShadowMapSources } from '../passes/shadowMap.ts';
import { SpritesPass } from '../passes/sprites.ts';
import type { DrawSmoke } from './smokePasses.ts';
import type { ComparisonRenderer } from './style.ts';

/** The passes of the comparison renderers, each created on first use. */
export class ComparisonRenderers {
  private readonly sources: ShadowMapSources;
  private sellePass: SellePass | undefined;
  private spritesPass: SpritesPass | undefined;
  private shadowMapPass: ShadowMapPass | undefined;

  constructor(sources: ShadowMapSources) {
    this.sources = sources;
  }

  get selle(): SellePass {
    const { eye, puffs, ramps } = this.sources;
    this.sellePass ??= new SellePass(eye, puffs, ramps);
    return this.sellePass;
  }

  get sprites(): SpritesPass {
    const { eye, ramps } = this.sources;
    this.spritesPass ??= new SpritesPass(eye, ramps);
    return this.spritesPass;
  }

  get shadowMap(): ShadowMapPass {
    this.shadowMapPass ??= new ShadowMapPass(this.sources);
    return this.shadowMapPass;
  }

  /** Draws the smoke of a frame with a comparison renderer, after the surfaces. */
  draw(...frame: Parameters<DrawSmoke>): void {
    const [, { style }] = frame;
    ways[style.renderer as ComparisonRenderer](this, ...frame);
  }

  /** Disposes of all passes. They are created again on next use. */
  dispose(): void {
    for (const pass of [this.sellePass, this.spritesPass, this.shadowMapPass]) pass?.dispose();
    this.sellePass = this.spritesPass = this.shadowMapPass = undefined;
  }
}

/** Mean radius of rows in metres; 0 without rows. */
function meanRadiusOf(places: Float32Array): number {
  let sum = 0;
  for (let at = 3; at < places.length; at += 4) sum += places[at];
  return sum / Math.max(1, places.length / 4);
}

type DrawWith = (comparisons: ComparisonRenderers, ...frame: Parameters<DrawSmoke>) => void;

/** How each comparison renderer draws a frame after the surfaces. */
const ways: Readonly<Record<ComparisonRenderer, DrawWith>> = {
  selle(comparisons, { renderer, targets }, { style, output }, { bodies }) {
    const { outlines, innerLine, inkColor } = style;
    comparisons.selle.setLines(inkColor, outlines ? innerLine * meanRadiusOf(bodies.places) : Infinity);
    comparisons.selle.draw(renderer, bodies.geometry);
    comparisons.selle.drawLines(renderer, targets, output);
  },

  sprites(comparisons, { renderer, targets, resolve }, { output }, { bodies }) {
    resolve.draw(renderer, targets, output);
    comparisons.sprites.draw(renderer, bodies.geometry, targets, output);
  },

  shadowMap(comparisons, passes, { style, rigids, parts = [], output }, { bodies, casters }, surfaceDepth) {
    const { renderer, targets, body, resolve, extras } = passes;
    body.draw(renderer, bodies.geometry, surfaceDepth);
    if (casters) {
      const { shadowMap } = comparisons;
      shadowMap.setForm(extras.billboardsOf(style.form));
      passes.scene?.place(rigids, parts, shadowMap);
      shadowMap.draw(renderer, targets, casters.geometry);
    }
    resolve.draw(renderer, targets, output);
  },
};
