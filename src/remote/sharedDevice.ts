import { createDevice, type Device } from '../device/device.ts';

/** Who comes back soon, as on a page that moves its widgets about, finds programs compiled and puffs uploaded. */
const GRACE_MS = 2_000;

/**
 * One device for all stages of a thread, so that their number meets no limit of contexts. Once its context has been given up,
 * the next stage has another one; those that stand may still have theirs back.
 */
export class SharedDevice {
  private device: Device | undefined;
  private readonly holders = new Map<Device, number>();
  private farewell: ReturnType<typeof setTimeout> | undefined;

  /**
   * The device, which has to be released as often as it was held.
   * @returns undefined where the browser cannot draw on a canvas that is on no page: each stage then needs one of its own
   */
  hold(): Device | undefined {
    clearTimeout(this.farewell);
    this.leaveDead();
    this.device ??= createOffPage();
    if (this.device) this.holders.set(this.device, this.countOf(this.device) + 1);
    return this.device;
  }

  release(device: Device): void {
    const left = this.countOf(device) - 1;
    if (left > 0) return void this.holders.set(device, left);
    this.holders.delete(device);
    if (device === this.device) this.farewell = setTimeout(() => this.end(), GRACE_MS);
    else device.dispose();
  }

  /** Lets go of a device that is of no use to whoever comes next. */
  private leaveDead(): void {
    const { device } = this;
    if (!device) return;
    if (this.countOf(device) === 0 && !device.isUsable) this.end();
    else if (!device.hasHope) this.device = undefined;
  }

  private countOf(device: Device): number {
    return this.holders.get(device) ?? 0;
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
