import type { BufferGeometry } from 'three';
import { SellePass } from '../passes/selle.ts';
import { ShadowMapPass, type ShadowMapSources } from '../passes/shadowMap.ts';
import { SpritesPass } from '../passes/sprites.ts';
import type { FrameInput } from './frameInput.ts';
import type { SmokePasses } from './smokePasses.ts';
import type { ComparisonRenderer } from './style.ts';

/** What the passes of the comparison renderers draw from. */
export interface ComparisonSources extends ShadowMapSources {
  readonly bodies: BufferGeometry;
}

/** Passes that only other renderers use, each made when it is first asked for. */
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

  /** Draws smoke as a comparison renderer does, from where the surfaces stand in the targets. */
  draw(kind: ComparisonRenderer, passes: SmokePasses, input: FrameInput): void {
    ways[kind](this, passes, input);
  }

  /** Lets go of everything; a pass that is asked for again is made anew. */
  dispose(): void {
    for (const pass of [this.sellePass, this.spritesPass, this.shadowMapPass]) pass?.dispose();
    this.sellePass = this.spritesPass = this.shadowMapPass = undefined;
  }
}

type DrawSmoke = (comparisons: ComparisonRenderers, passes: SmokePasses, input: FrameInput) => void;

/** The other ways of drawing smoke, for comparison by eye and clock: each from there on. */
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
