import { Vector2, type DepthTexture, type IUniform, type WebGLRenderer } from 'three';
import { CopyableDepths, copyDepth, depthCopy } from '../device/depthCopy.ts';
import type { Targets } from './targets.ts';

/** A smoothed picture is tested by samples all over each pixel. */
const SLACK_OF_SAMPLES = 0.75;

/**
 * Keeps a copy of the depth that the surfaces leave, for bodies that touch them: what is drawn into cannot be read.
 * See shaders/lib/contact.glsl.
 */
export class SurfaceDepthPass {
  readonly uniforms: {
    surfaceDepth: IUniform<DepthTexture>;
    hasSurfaces: IUniform<boolean>;
    surfaceSlack: IUniform<number>;
  };
  private readonly copy = depthCopy();
  /** Holds all of the host's picture where smoke is drawn into a part of it. */
  private readonly whole = depthCopy();
  private readonly copyable = new CopyableDepths();
  private readonly hasSurfaces: boolean;

  /** @param hasSurfaces whether there is anything to touch; without it nothing is copied and no memory is taken */
  constructor(hasSurfaces: boolean) {
    this.hasSurfaces = hasSurfaces;
    this.uniforms = {
      surfaceDepth: { value: this.copy.depthTexture! },
      hasSurfaces: { value: false },
      surfaceSlack: { value: 0 },
    };
  }

  /** Copies the depth, if lines are drawn at all, and goes on drawing into the targets. */
  draw(renderer: WebGLRenderer, targets: Targets, isInked: boolean): void {
    this.uniforms.hasSurfaces.value = isInked && this.hasSurfaces;
    if (!this.uniforms.hasSurfaces.value) return;
    this.copy.setSize(targets.width, targets.height);
    renderer.initRenderTarget(this.copy);
    renderer.copyTextureToTexture(targets.depth, this.copy.depthTexture!);
    renderer.setRenderTarget(targets.renderTarget);
  }

  /**
   * Copies the depth of the host's picture that is being drawn into, which is then no longer bound. Where that depth
   * is of a kind that cannot be copied, surfaces get no lines.
   * @param origin where the part that smoke is drawn into begins, pixels
   * @param size of that part
   */
  takeFromHost(renderer: WebGLRenderer, origin: Vector2, size: Vector2, isInked: boolean): void {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const { surfaceSlack, hasSurfaces } = this.uniforms;
    hasSurfaces.value = isInked && this.copyable.includesBound(gl);
    if (!hasSurfaces.value) return;
    surfaceSlack.value = (gl.getParameter(gl.SAMPLES) as number) > 0 ? SLACK_OF_SAMPLES : 0;
    const isPart = origin.x > 0 || origin.y > 0;
    copyDepth(renderer, isPart ? this.whole : this.copy, origin, origin, size);
    if (isPart) copyDepth(renderer, this.copy, origin, new Vector2(), size);
  }

  dispose(): void {
    this.copy.dispose();
    this.whole.dispose();
  }
}
