import { NearestFilter, NoColorSpace, WebGLRenderTarget, type Texture, type WebGLRenderer } from 'three';
import type { ResolvePass } from './resolve.ts';
import type { Targets } from './targets.ts';

/** Smoke in full light and smoke in full shadow as two pictures, each with smooth edges: premultiplied, display-encoded. */
export class SmokePictures {
  private readonly litTarget = pictureTarget();
  private readonly unlitTarget = pictureTarget();

  get lit(): Texture {
    return this.litTarget.texture;
  }

  get unlit(): Texture {
    return this.unlitTarget.texture;
  }

  /** Resolves what the bodies have drawn and nothing has masked yet: once as it is, once as if all of it were in shadow. */
  take(renderer: WebGLRenderer, { unlit, lit, width, height }: Targets, resolve: ResolvePass): void {
    for (const target of [this.litTarget, this.unlitTarget]) target.setSize(width, height);
    resolve.draw(renderer, { unlit, lit }, this.litTarget);
    // The alpha of unlit is the page's, and 1 wherever there is smoke: read as a mask it leaves nothing lit.
    resolve.draw(renderer, { unlit, lit: unlit }, this.unlitTarget);
  }

  dispose(): void {
    this.litTarget.dispose();
    this.unlitTarget.dispose();
  }
}

function pictureTarget(): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    colorSpace: NoColorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });
}
