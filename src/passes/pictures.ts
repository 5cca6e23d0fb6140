import type { Texture, WebGLRenderer } from 'three';
import { pictureTarget } from '../device/pictureTarget.ts';
import type { ChooseTones, ResolvePass } from './resolve.ts';
import type { Targets } from './targets.ts';

/**
 * Smoke in full light, in full shadow and in deep shadow as separate pictures with smoothed edges: premultiplied,
 * display-encoded.
 */
export class SmokePictures {
  private readonly litTarget = pictureTarget();
  private readonly unlitTarget = pictureTarget();
  private readonly deepTarget = pictureTarget();
  /** Whether the picture of lit smoke has its shadow, so that it stands for all. */
  private isOne = false;

  get lit(): Texture {
    return this.litTarget.texture;
  }

  get unlit(): Texture {
    return this.isOne ? this.lit : this.unlitTarget.texture;
  }

  get deep(): Texture {
    return this.isOne ? this.lit : this.deepTarget.texture;
  }

  /**
   * Resolves the puffs before the mask is drawn: once lit, and once as if all of it were in shadow.
   * @param hasDeep whether to resolve the picture in deep shadow, too
   */
  take(renderer: WebGLRenderer, { unlit, lit, width, height }: Targets, resolve: ResolvePass, hasDeep: boolean): void {
    this.isOne = false;
    for (const target of [this.litTarget, this.unlitTarget]) target.setSize(width, height);
    resolve.draw(renderer, { unlit, lit, width, height }, this.litTarget);
    // The alpha of unlit is the alpha of the page, which is 1 for smoke. Read as the mask, it puts all smoke in shadow.
    resolve.draw(renderer, { unlit, lit: unlit, width, height }, this.unlitTarget);
    if (!hasDeep) return;
    this.deepTarget.setSize(width, height);
    resolve.drawDeep(renderer, { unlit, lit, width, height }, this.deepTarget);
  }

  /** Resolves the puffs once, with their shadow, after the mask is drawn. */
  takeShadowed(renderer: WebGLRenderer, targets: Targets, resolve: ResolvePass, choose: ChooseTones): void {
    this.isOne = true;
    this.litTarget.setSize(targets.width, targets.height);
    resolve.draw(renderer, targets, this.litTarget, choose);
  }

  dispose(): void {
    this.litTarget.dispose();
    this.unlitTarget.dispose();
    this.deepTarget.dispose();
  }
}
