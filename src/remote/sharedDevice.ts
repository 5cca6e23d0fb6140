import { createDevice, type Device } from '../device/device.ts';

/** Who comes back soon, as on a page that moves its widgets about, finds programs compiled and puffs uploaded. */
const GRACE_MS = 2_000;

/** One device for all stages of a thread, so that their number meets no limit of contexts. */
export class SharedDevice {
  private device: Device | undefined;
  private holders = 0;
  private farewell: ReturnType<typeof setTimeout> | undefined;

  /**
   * The device, which has to be released as often as it was held.
   * @returns undefined where the browser cannot draw on a canvas that is on no page: each stage then needs one of its own
   */
  hold(): Device | undefined {
    clearTimeout(this.farewell);
    if (this.holders === 0 && this.device && !this.device.isUsable) this.end();
    this.device ??= createOffPage();
    if (this.device) this.holders += 1;
    return this.device;
  }

  release(): void {
    this.holders -= 1;
    if (this.holders === 0) this.farewell = setTimeout(() => this.end(), GRACE_MS);
  }

  private end(): void {
    this.device?.dispose();
    this.device = undefined;
  }
}

function createOffPage(): Device | undefined {
  if (typeof OffscreenCanvas === 'undefined' || !new OffscreenCanvas(1, 1).getContext('bitmaprenderer'))
    return undefined;
  try {
    return createDevice(new OffscreenCanvas(1, 1));
  } catch {
    return undefined;
  }
}

/** That of this thread. */
export const threadDevice = new SharedDevice();
