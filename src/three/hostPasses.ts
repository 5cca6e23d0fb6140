import { Device } from '../renderer/gpu/device.ts';
import { pictureTarget, depthCopy } from '../renderer/passes/targets.ts';
import { InsertPass } from '../renderer/passes/insert.ts';
import type { SmokeRenderer } from '../renderer/smoke.ts';
import { HostCasters } from './casters.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import { HostVolumes } from './volumes/hostVolumes.ts';
import type { LoadError } from '../base/errors.ts';
import { type WebGLRenderer, type WebGLRenderTarget, Vector2, type DepthTexture } from 'three';
import type { FrameView } from '../renderer/gpu/frameView.ts';
import { LazyModules } from '../base/timeout.ts';
import type { OwnStencil } from './target/ownStencil.ts';
import type { SurfaceDepth } from '../renderer/passes/surfaceDepth.ts';

/** Passes for a frame in the host's scene. */
export class HostPasses {
  readonly smoke: SmokeRenderer;
  readonly casters: HostCasters;
  readonly insert: InsertPass;
  readonly volumes: HostVolumes;
  /** The smoke with its shadow: premultiplied, display-encoded. */
  readonly picture: WebGLRenderTarget = pictureTarget();
  readonly depth = new HostDepth();

  readonly ownStencil: LateStencil;

  /**
   * @param smoke which these passes dispose of
   * @param capacity maximum number of particles
   * @param frame the space of the smoke
   * @param miss called with the error, if the code for targets without stencil cannot be loaded
   */
  constructor(
    smoke: SmokeRenderer,
    device: Device,
    capacity: number,
    frame: SmokeFrame,
    miss: (error: LoadError) => void,
  ) {
    const { eye } = smoke.passes;
    this.smoke = smoke;
    this.casters = new HostCasters(device, eye, frame);
    this.volumes = new HostVolumes(capacity);
    this.insert = new InsertPass(eye);
    this.ownStencil = new LateStencil(eye, miss);
  }

  /** Frees the GPU resources. The next draw recreates them. */
  release(): void {
    this.insert.dispose();
    this.volumes.dispose();
    this.picture.dispose();
    this.depth.dispose();
    this.ownStencil.dispose();
    this.casters.release();
  }

  dispose(): void {
    this.smoke.dispose();
    this.release();
    this.casters.dispose();
  }
}

interface BorrowedDevice {
  device: Device;
  users: number;
}

const devices = new WeakMap<WebGLRenderer, BorrowedDevice>();

/**
 * Returns the device of the host's renderer, which all smoke objects on it share. Return it with {@link releaseDevice}.
 */
export function borrowDevice(renderer: WebGLRenderer): Device {
  let shared = devices.get(renderer);
  if (!shared) {
    shared = { device: new Device(renderer, false), users: 0 };
    devices.set(renderer, shared);
  }
  ++shared.users;
  return shared.device;
}

/** Disposes of the device when its last user releases it. */
export function releaseDevice({ renderer }: Device): void {
  const shared = devices.get(renderer);
  if (!shared || --shared.users > 0) return;
  shared.device.dispose();
  devices.delete(renderer);
}

const modules = new LazyModules({ ownStencil: () => import('./target/ownStencil.ts') });
const load = () => modules.load('ownStencil', 'The code for shadow in targets without stencil');

/** The {@link OwnStencil} of one smoke. Its code is loaded when smoke is first drawn into a target without stencil. */
class LateStencil {
  private readonly eye: FrameView;
  private readonly miss: (error: LoadError) => void;
  private made: OwnStencil | undefined;
  private isNeeded = false;

  /** @param miss called once with the error, if the code cannot be loaded */
  constructor(eye: FrameView, miss: (error: LoadError) => void) {
    this.eye = eye;
    this.miss = miss;
  }

  /** Undefined until the code is loaded, which starts on the first call. */
  loaded(): OwnStencil | undefined {
    const { ownStencil } = modules.loaded;
    if (ownStencil) return (this.made ??= new ownStencil.OwnStencil(this.eye));
    if (!this.isNeeded) load().catch(this.miss);
    this.isNeeded = true;
    return undefined;
  }

  /**
   * Resolves when the code is loaded, if a target needed it. A failed load is retried.
   * @throws LoadError if the code cannot be loaded
   */
  async wait(): Promise<void> {
    if (this.isNeeded) await load();
  }

  /** Frees the GPU resources. The next draw recreates them. */
  dispose(): void {
    this.made?.dispose();
  }
}

/**
 * Extent of the depth test about a pixel's centre in a multisampled framebuffer, pixels: samples are spread over the
 * pixel.
 */
const SLACK_OF_SAMPLES = 0.75;

/** A copy of the depth in the viewport of the smoke. */
interface CopiedDepth extends SurfaceDepth {
  /** The same depth at the coordinates of the framebuffer. */
  readonly inPlace: DepthTexture;
}

/** Copies the depth of the host's framebuffer, for puffs that touch the host's scene and for shadow on it. */
class HostDepth {
  /** The depth in the viewport of the smoke. */
  private readonly copy = depthCopy();
  /** The whole depth buffer, if smoke is drawn into a part of it. */
  private readonly whole = depthCopy();
  private readonly copyable = new CopyableDepths();

  /**
   * Copies the depth of the host's bound framebuffer and unbinds that framebuffer. If the depth format cannot be
   * copied, smoke has no contact lines, and shadow volumes are counted.
   * @param origin lower left corner of the viewport of the smoke, pixels
   * @param size size of that viewport, pixels
   */
  copyDepth(renderer: WebGLRenderer, origin: Vector2, size: Vector2, isNeeded: boolean): CopiedDepth | undefined {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    if (!isNeeded || !this.copyable.includesBound(gl)) return undefined;
    const slack = (gl.getParameter(gl.SAMPLES) as number) > 0 ? SLACK_OF_SAMPLES : 0;
    const isPart = origin.x > 0 || origin.y > 0;
    copyDepth(renderer, isPart ? this.whole : this.copy, origin, origin, size);
    if (isPart) copyDepth(renderer, this.copy, origin, new Vector2(), size);
    return { depth: this.copy.depthTexture!, slack, inPlace: (isPart ? this.whole : this.copy).depthTexture! };
  }

  /** Frees the GPU resources. The next copy recreates them. */
  dispose(): void {
    this.copy.dispose();
    this.whole.dispose();
  }
}

/**
 * Copies a rectangle of the bound framebuffer's depth, and leaves the copy bound. three.js cannot copy the depth of the
 * canvas. The depth of a multisampled framebuffer can only be copied to the same coordinates.
 * @param from lower left corner in the source, pixels
 * @param to lower left corner in the copy, pixels
 * @param size size of the rectangle, pixels
 */
function copyDepth(renderer: WebGLRenderer, copy: WebGLRenderTarget, from: Vector2, to: Vector2, size: Vector2) {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const source = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  const [fromEnd, toEnd] = [from.clone().add(size), to.clone().add(size)];
  copy.setSize(toEnd.x, toEnd.y);
  renderer.setRenderTarget(copy);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, source);
  gl.blitFramebuffer(
    from.x,
    from.y,
    fromEnd.x,
    fromEnd.y,
    to.x,
    to.y,
    toEnd.x,
    toEnd.y,
    gl.DEPTH_BUFFER_BIT,
    gl.NEAREST,
  );
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as WebGLFramebuffer);
}

/**
 * Tests whether a depth buffer has the format of the copy, which a blit requires. Results are memoized by framebuffer,
 * because the query is slow.
 */
class CopyableDepths {
  private readonly known = new WeakMap<object, boolean>();

  /** Whether the depth of the bound framebuffer can be copied. */
  includesBound(gl: WebGL2RenderingContext): boolean {
    const framebuffer = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    const key = framebuffer ?? gl;
    const isCopyable = this.known.get(key) ?? isLikeTheCopy(gl, framebuffer ? gl.DEPTH_ATTACHMENT : gl.DEPTH);
    this.known.set(key, isCopyable);
    return isCopyable;
  }
}

function isLikeTheCopy(gl: WebGL2RenderingContext, attachment: number): boolean {
  const ask = (name: number) => gl.getFramebufferAttachmentParameter(gl.DRAW_FRAMEBUFFER, attachment, name) as number;
  return (
    ask(gl.FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE) === 24 &&
    ask(gl.FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) === gl.UNSIGNED_NORMALIZED
  );
}
