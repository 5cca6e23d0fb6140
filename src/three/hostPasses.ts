import type { Device } from '../device/device.ts';
import { InsertPass } from '../passes/insert.ts';
import { SmokePictures } from '../passes/pictures.ts';
import { SmokeRenderer } from '../smoke/smoke.ts';
import { HostCasters } from './casters.ts';

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
