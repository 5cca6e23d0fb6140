import { Vector3 } from 'three';
import type { Device } from '../device/device.ts';
import type { BakedPuffs } from '../device/puffTextures.ts';
import type { Values } from '../preset/parameter.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import type { Scene } from '../scenes/scene.ts';
import type { PictureKind } from '../smoke/extraPasses.ts';
import type { FrameInput, FrameReport } from '../smoke/frameInput.ts';
import { lightOf, moved, type Light } from '../smoke/light.ts';
import { LivePuffs } from '../smoke/livePuffs.ts';
import { SmokeRenderer } from '../smoke/smoke.ts';
import { styleOf, type Style } from '../smoke/style.ts';

/** Changes what a frame is drawn from; it may add as many particles again as the simulator has room for. */
export type Retouch = (input: FrameInput) => FrameInput;

/** A scene's smoke as values describe it: its style, its light, its puffs, and how many particles it can draw. */
export class ShownSmoke {
  private readonly device: Device;
  private readonly scene: Scene;
  private readonly puffs: LivePuffs;
  private baked: BakedPuffs | undefined;
  private renderer: SmokeRenderer;
  private capacity: number;
  private style: Style;
  private values: Values;
  private light: Light;
  private change: Retouch | undefined;

  constructor(device: Device, scene: Scene, values: Values) {
    this.device = device;
    this.scene = scene;
    this.style = styleOf(values);
    this.values = values;
    this.light = this.lightOf(values);
    this.puffs = new LivePuffs(values);
    this.baked = this.puffs.finish();
    this.capacity = capacityOf(values);
    this.renderer = this.makeRenderer();
  }

  get throwsShadow(): boolean {
    return this.style.shadows;
  }

  /** How smoke is to be drawn. */
  get kind(): PictureKind {
    const { renderer, form } = this.style;
    return { renderer, form };
  }

  /** Goes on with these values. */
  follow(values: Values): void {
    this.style = styleOf(values);
    this.values = values;
    this.light = this.lightOf(values);
    this.puffs.follow(values);
    if (this.capacity === capacityOf(values)) return;
    this.capacity = capacityOf(values);
    this.renderer.dispose();
    this.renderer = this.makeRenderer();
  }

  /** Makes sure of so many variations, for particles that come from elsewhere. */
  keepVariations(values: Values, alive: number): void {
    this.puffs.follow(values, alive);
  }

  /** What somebody brought, if anything. */
  get ownShapes(): readonly PuffShape[] | undefined {
    return this.puffs.ownShapes;
  }

  /** Shows shapes that somebody brought; without any, those that values describe. */
  usePuffs(shapes: readonly PuffShape[] | undefined, values: Values): void {
    this.puffs.use(shapes, values);
  }

  /** Goes on baking puffs for some milliseconds, or until they are ready. */
  bake(milliseconds = Infinity): void {
    const puffs = milliseconds === Infinity ? this.puffs.finish() : this.puffs.workFor(milliseconds);
    if (!puffs) return;
    this.baked = puffs;
    this.renderer.setPuffs(puffs);
  }

  draw(given: Omit<FrameInput, 'style' | 'light'>): FrameReport {
    const input = { ...given, style: this.style, light: this.lightAt(given.time ?? 0) };
    return this.renderer.draw(this.change ? this.change(input) : input);
  }

  /** See `Stage.retouch`. */
  retouch(change: Retouch): void {
    this.change = change;
    this.renderer.dispose();
    this.renderer = this.makeRenderer();
  }

  dispose(): void {
    this.renderer.dispose();
  }

  /** @param seconds simulated */
  private lightAt(seconds: number): Light {
    const shift = this.scene.lightMove?.(seconds);
    return shift ? this.lightOf(moved(this.values, shift)) : this.light;
  }

  private lightOf(values: Values): Light {
    const { lightCentre, camera } = this.scene;
    return lightOf(values, new Vector3(...(lightCentre ?? camera.target)));
  }

  private makeRenderer(): SmokeRenderer {
    const capacity = this.change ? 2 * this.capacity : this.capacity;
    return new SmokeRenderer(this.device, { ...this.scene, capacity, puffs: this.baked });
  }
}

function capacityOf(values: Values): number {
  return values['simulation.maxParticles'] as number;
}
