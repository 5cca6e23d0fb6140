import {
  CustomBlending,
  HalfFloatType,
  NearestFilter,
  OneFactor,
  OneMinusSrcAlphaFactor,
  WebGLRenderTarget,
  type Camera,
  type Scene,
  type Texture,
  type Vector2,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../../shaders/insert/shadow.frag';
import type { FrameView } from '../../device/frameView.ts';
import { FullScreen } from '../../device/fullScreen.ts';
import type { ArrangedFrame } from '../../smoke/smokePasses.ts';
import type { Style } from '../../smoke/style.ts';
import { drawAgain } from '../relight.ts';
import { countShadows, drawShadow, hasDeep, type HostView, type InsertionPasses } from './insertion.ts';

/**
 * A target with depth and stencil in place of a host's target that has no stencil. The host's opaque objects are drawn
 * into its depth again: a depth buffer cannot be copied to one of another format, and the samples of a multisampled one
 * cannot be read. Shadow and smoke are drawn into it one after the other, and copied to the host's target.
 */
export class OwnStencil {
  private readonly target = new WebGLRenderTarget(1, 1, {
    type: HalfFloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    stencilBuffer: true,
    resolveDepthBuffer: false,
  });
  private readonly surfaceDepth = { value: null as Texture | null };
  private readonly shadow: FullScreen;

  constructor(eye: FrameView) {
    const { viewportOrigin, clipFromView } = eye.uniforms;
    const { surfaceDepth } = this;
    const picture = { value: this.target.texture };
    this.shadow = new FullScreen(fragmentShader, { viewportOrigin, clipFromView, surfaceDepth, picture }, BLENDED);
  }

  /**
   * Binds the target and draws the depth of the host's opaque objects.
   * @param size size of the host's viewport, pixels
   * @param samples samples of the host's target
   */
  begin(renderer: WebGLRenderer, scene: Scene, camera: Camera, size: Vector2, samples: number): void {
    if (this.target.samples !== samples) this.target.dispose();
    this.target.samples = samples;
    this.target.setSize(size.x, size.y);
    this.clear(renderer, true);
    const { color, stencil } = renderer.state.buffers;
    color.setMask(false);
    color.setLocked(true);
    stencil.setTest(false);
    stencil.setLocked(true);
    try {
      drawAgain(renderer, scene, camera);
    } finally {
      color.setLocked(false);
      color.setMask(true);
      stencil.setLocked(false);
    }
  }

  /**
   * Inserts shadow and smoke into the host's target, except the colour of smoke, which the marker draws.
   * @param surfaceDepth depth of the host's opaque objects
   */
  insert(
    passes: InsertionPasses,
    view: HostView & { returnToTarget(): void },
    style: Style,
    casters: ArrangedFrame['casters'],
    surfaceDepth: Texture | undefined,
  ): void {
    const { renderer, origin } = view;
    const { insert, pictures, smoke } = passes;
    const { eye, targets } = smoke.passes;
    const { viewportOrigin } = eye.uniforms;
    const here = viewportOrigin.value.clone();
    renderer.setRenderTarget(this.target);
    insert.setSmoke(pictures, targets.depth, true);
    countShadows(passes, view, casters);
    if (casters) drawShadow(view);
    if (hasDeep(style)) insert.darken(renderer, style.shadowDepth, style.deepShadow);

    view.returnToTarget();
    viewportOrigin.value.copy(origin);
    this.surfaceDepth.value = surfaceDepth ?? null;
    this.shadow.draw(renderer);

    viewportOrigin.value.copy(here);
    // The host's target tests the depth of each sample, so that here all samples of a pixel have its smoke.
    this.clear(renderer, this.target.samples > 0);
    insert.setSmoke(pictures, targets.depth, false);
    insert.setFog(null);
    insert.drawLit(renderer);
    if (hasDeep(style)) insert.drawDeep(renderer);
    insert.drawUnlit(renderer);

    view.returnToTarget();
    viewportOrigin.value.copy(origin);
    const { texture } = this.target;
    insert.setSmoke({ lit: texture, unlit: texture, deep: texture }, targets.depth, true);
    insert.setFog(view.scene.fog, view.scale);
    insert.drawDepth(renderer);
  }

  /** Frees the GPU resources. The next draw recreates them. */
  dispose(): void {
    this.target.dispose();
    this.shadow.dispose();
  }

  private clear(renderer: WebGLRenderer, hasDepth: boolean): void {
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, hasDepth, false);
  }
}

/** Premultiplied alpha blending in front of what the depth buffer holds. */
const BLENDED = {
  depthTest: true,
  transparent: true,
  blending: CustomBlending,
  blendSrc: OneFactor,
  blendDst: OneMinusSrcAlphaFactor,
} as const;
