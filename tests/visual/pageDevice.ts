/** The device that all pictures of a page share, so that each program is compiled once for all tests of a file. */
import type { WebGLRenderer } from 'three';
import { createDevice, type Device } from '../../src/renderer/gpu/device.ts';

const devices = new Map<string, Device>();
const kept = new WeakSet<object>();

/** @param kind devices of another kind, with the function that creates them */
export function pageDevice(kind = 'default', create = () => createDevice(new OffscreenCanvas(1, 1))): Device {
  const device = devices.get(kind) ?? create();
  devices.set(kind, device);
  return device;
}

/** Gives the drawing buffer of a device the size of the next picture, in pixels. */
export function fitDevice({ renderer }: Device, width: number, height: number): void {
  const { domElement: canvas } = renderer;
  if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
}

/** Counts one more use of each program, because three.js deletes a program with the last material that uses it. */
export function keepPrograms({ info }: WebGLRenderer): void {
  for (const program of info.programs ?? []) {
    if (kept.has(program)) continue;
    kept.add(program);
    program.usedTimes++;
  }
}
