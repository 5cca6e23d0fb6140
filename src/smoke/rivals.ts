import type { BufferGeometry } from 'three';
import { SellePass } from '../passes/selle.ts';
import { ShadowMapPass, type ShadowMapSources } from '../passes/shadowMap.ts';
import { SpritesPass } from '../passes/sprites.ts';
import type { FrameInput } from './frame.ts';
import type { SmokePasses } from './smoke.ts';
import type { Rival } from './style.ts';

/** What the passes of the rivals draw from. */
export interface RivalSources extends ShadowMapSources {
  readonly bodies: BufferGeometry;
}

/** Passes that only other renderers use, each made when it is first asked for. */
export class Rivals {
  private readonly sources: RivalSources;
  private sellePass: SellePass | undefined;
  private spritesPass: SpritesPass | undefined;
  private shadowMapPass: ShadowMapPass | undefined;

  constructor(sources: RivalSources) {
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

  /** Draws smoke as a rival does, from where the surfaces stand in the targets. */
  draw(rival: Rival, passes: SmokePasses, input: FrameInput): void {
    ways[rival](this, passes, input);
  }

  /** Lets go of everything; a pass that is asked for again is made anew. */
  dispose(): void {
    for (const pass of [this.sellePass, this.spritesPass, this.shadowMapPass]) pass?.dispose();
    this.sellePass = this.spritesPass = this.shadowMapPass = undefined;
  }
}

type DrawSmoke = (rivals: Rivals, passes: SmokePasses, input: FrameInput) => void;

/** The other ways of drawing smoke, for comparison by eye and clock: each from there on. */
const ways: Readonly<Record<Rival, DrawSmoke>> = {
  selle(rivals, { renderer, targets, bodies }, { style, output }) {
    const { outlines, innerLine, inkColor } = style;
    rivals.selle.setLines(inkColor, outlines ? innerLine * bodies.meanRadius : Infinity);
    rivals.selle.draw(renderer);
    rivals.selle.drawLines(renderer, targets, output);
  },

  sprites(rivals, { renderer, targets, resolve }, { output }) {
    resolve.draw(renderer, targets, output);
    rivals.sprites.draw(renderer, targets, output);
  },

  shadowMap(rivals, passes, { style, rigids, parts = [], output }) {
    const { renderer, targets, body, resolve, extras } = passes;
    body.draw(renderer);
    if (style.shadows) {
      const { shadowMap } = rivals;
      shadowMap.setForm(extras.billboardsOf(style.form));
      passes.placeSurfaces(rigids, parts, [shadowMap]);
      shadowMap.draw(renderer, targets);
    }
    resolve.draw(renderer, targets, output);
  },
};
