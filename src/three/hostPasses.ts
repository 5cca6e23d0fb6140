import { Device } from '../renderer/gpu/device.ts';
import { pictureTarget } from '../renderer/passes/targets.ts';
import { InsertPass } from '../renderer/passes/insert.ts';
import type { SmokeRenderer } from '../renderer/smoke.ts';
import { HostCasters } from './casters.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import { HostDepth } from './hostDepth.ts';
import { HostVolumes } from './volumes/hostVolumes.ts';
import { LateStencil } from './target/lateStencil.ts';
import type { LoadError } from '../base/errors.ts';
import type { WebGLRenderer, WebGLRenderTarget } from 'three';

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
