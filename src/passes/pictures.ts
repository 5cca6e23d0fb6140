import type { Texture, WebGLRenderer } from 'three';
import { pictureTarget } from '../device/pictureTarget.ts';
import type { ResolvePass } from './resolve.ts';
import type { Targets } from './targets.ts';

/**
 * Smoke in full light, in full shadow and in deep shadow as separate pictures with smoothed edges: premultiplied,
 * display-encoded.
 */
export class SmokePictures {
  private readonly litTarget = pictureTarget();
  private readonly unlitTarget = pictureTarget();
  private readonly deepTarget = pictureTarget();

  get lit(): Texture {
    return this.litTarget.texture;
  }

  get unlit(): Texture {
    return this.unlitTarget.texture;
  }

  get deep(): Texture {
    return this.deepTarget.texture;
  }

  /**
   * Resolves the puffs before the mask is drawn: once lit, and once as if all of it were in shadow.
   * @param hasDeep whether to resolve the picture in deep shadow, too
   */
  take(renderer: WebGLRenderer, { unlit, lit, width, height }: Targets, resolve: ResolvePass, hasDeep: boolean): void {
    for (const target of [this.litTarget, this.unlitTarget]) target.setSize(width, height);
    resolve.draw(renderer, { unlit, lit, width, height }, this.litTarget);
    // The alpha of unlit is the alpha of the page, which is 1 for smoke. Read as the mask, it puts all smoke in shadow.
    resolve.draw(renderer, { unlit, lit: unlit, width, height }, this.unlitTarget);
    if (!hasDeep) return;
    this.deepTarget.setSize(width, height);
    resolve.drawDeep(renderer, { unlit, lit, width, height }, this.deepTarget);
  }

  dispose(): void {
    this.litTarget.dispose();
    this.unlitTarget.dispose();
    this.deepTarget.dispose();
  }
}
