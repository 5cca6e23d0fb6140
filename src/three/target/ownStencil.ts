import {
  CustomBlending,
  HalfFloatType,
  NearestFilter,
  OneFactor,
  OneMinusSrcAlphaFactor,
  WebGLRenderTarget,
  type Camera,
  type DepthTexture,
  type Scene,
  type Texture,
  type Vector2,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../../shaders/insert/shadow.frag';
import type { FrameView } from '../../renderer/gpu/frameView.ts';
import { FullScreen } from '../../renderer/gpu/fullScreen.ts';
import type { Style } from '../../renderer/style.ts';
import { drawAgain } from '../relight.ts';
import { insertShadow, type HostView, type InsertionPasses } from './insertion.ts';

/**
 * A target with depth and stencil in place of a host's target that has no stencil. The host's opaque objects are drawn
 * into its depth again: a depth buffer cannot be copied to one of another format, and the samples of a multisampled one
 * cannot be read. The shadow is drawn into it, and copied to the host's target.
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
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, true, false);
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
   * Inserts the shadow on the host's objects into the host's target.
   * @param receivers the depth of the pixels of this target, if they have one each
   * @param surfaceDepth depth of the host's opaque objects
   */
  insert(
    passes: InsertionPasses,
    view: HostView & { returnToTarget(): void },
    style: Style,
    receivers: DepthTexture | undefined,
    surfaceDepth: Texture | undefined,
  ): void {
    const { renderer, origin } = view;
    renderer.setRenderTarget(this.target);
    insertShadow(passes, view, style, receivers, surfaceDepth);
    view.returnToTarget();
    passes.smoke.passes.eye.uniforms.viewportOrigin.value.copy(origin);
    this.surfaceDepth.value = surfaceDepth ?? null;
    this.shadow.draw(renderer);
  }

  /** Frees the GPU resources. The next draw recreates them. */
  dispose(): void {
    this.target.dispose();
    this.shadow.dispose();
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
