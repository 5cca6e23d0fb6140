import { Device } from '../device/device.ts';
import { InsertPass } from '../passes/insert.ts';
import { SmokePictures } from '../passes/pictures.ts';
import { SmokeRenderer } from '../smoke/smoke.ts';
import { HostCasters } from './casters.ts';
import type { WebGLRenderer } from 'three';

/** What a frame in the host's scene is drawn with. */
export class HostPasses {
  readonly smoke: SmokeRenderer;
  readonly casters: HostCasters;
  readonly insert: InsertPass;
  readonly pictures = new SmokePictures();

  /** @param capacity most particles that smoke may have */
  constructor(device: Device, capacity: number) {
    this.smoke = new SmokeRenderer(device, { capacity, surfaces: [], isGuest: true });
    const { eye } = this.smoke.passes;
    this.casters = new HostCasters(device, eye);
    this.insert = new InsertPass(eye);
  }

  /** Lets go of what is on the device; what is drawn again gets it anew. */
  release(): void {
    this.insert.dispose();
    this.pictures.dispose();
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

/** The device of the host's renderer: all smokes on it share one. Give it back with {@link releaseDevice}. */
export function borrowDevice(renderer: WebGLRenderer): Device {
  let shared = devices.get(renderer);
  if (!shared) {
    shared = { device: new Device(renderer, false), users: 0 };
    devices.set(renderer, shared);
  }
  ++shared.users;
  return shared.device;
}

/** Ends the device with its last user. */
export function releaseDevice({ renderer }: Device): void {
  const shared = devices.get(renderer);
  if (!shared || --shared.users > 0) return;
  shared.device.dispose();
  devices.delete(renderer);
}
