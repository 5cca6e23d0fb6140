import type { WebGLRenderer } from 'three';
import { Device } from '../device/device.ts';

interface SharedDevice {
  device: Device;
  users: number;
}

const devices = new WeakMap<WebGLRenderer, SharedDevice>();

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
