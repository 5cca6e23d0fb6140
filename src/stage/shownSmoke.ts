import { Vector3 } from 'three';
import type { Device } from '../device/device.ts';
import type { BakedPuffs } from '../device/puffTextures.ts';
import type { Values } from '../preset/parameter.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import type { Scene } from '../scenes/scene.ts';
import type { PictureKind } from '../smoke/extraPasses.ts';
import type { FrameInput } from '../smoke/frameInput.ts';
import { lightOf, moved, type Light } from '../smoke/light.ts';
import { LivePuffs } from '../smoke/livePuffs.ts';
import { drawnSurfaces } from '../smoke/sceneSurfaces.ts';
import { SmokeRenderer } from '../smoke/smoke.ts';
import { styleOf, type Style } from '../smoke/style.ts';

/**
 * Modifies the input of a frame. It can at most double the number of particles, relative to the simulator's capacity.
 */
export type Retouch = (input: FrameInput) => FrameInput;

/** The rendered smoke of a scene: its style, light, puffs and particle capacity, as the values define them. */
export class ShownSmoke {
  private readonly device: Device;
  private readonly scene: Scene;
  private readonly puffs: LivePuffs;
  private baked: BakedPuffs | undefined;
  private drawing: SmokeRenderer;
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
    this.drawing = this.makeRenderer();
  }

  /** Replaced when the capacity changes. */
  get renderer(): SmokeRenderer {
    return this.drawing;
  }

  get throwsShadow(): boolean {
    return this.style.shadows;
  }

  /** The settings that decide which modules the picture needs. */
  get kind(): PictureKind {
    return this.style;
  }

  /** Applies new values. */
  follow(values: Values): void {
    this.style = styleOf(values);
    this.values = values;
    this.light = this.lightOf(values);
    this.puffs.follow(values);
    if (this.capacity === capacityOf(values)) return;
    this.capacity = capacityOf(values);
    this.drawing.dispose();
    this.drawing = this.makeRenderer();
  }

  /** Provides at least as many variations as the restored particles use. */
  keepVariations(alive: number): void {
    this.puffs.follow(this.values, alive);
  }

  /** Custom shapes, if set. */
  get ownShapes(): readonly PuffShape[] | undefined {
    return this.puffs.ownShapes;
  }

  /** Uses custom shapes; without them, the values define the shapes. */
  usePuffs(shapes: readonly PuffShape[] | undefined): void {
    this.puffs.use(shapes, this.values);
  }

  /** Continues baking puffs for some milliseconds, or until they are done. */
  bake(milliseconds = Infinity): void {
    const puffs = milliseconds === Infinity ? this.puffs.finish() : this.puffs.workFor(milliseconds);
    if (!puffs) return;
    this.baked = puffs;
    this.drawing.setPuffs(puffs);
  }

  /** Completes the input of a frame for the renderer. */
  inputOf(given: Omit<FrameInput, 'style' | 'light'>): FrameInput {
    const input = { ...given, style: this.style, light: this.lightAt(given.time ?? 0) };
    return this.change ? this.change(input) : input;
  }

  /** See `Stage.retouch`. */
  retouch(change: Retouch): void {
    this.change = change;
    this.drawing.dispose();
    this.drawing = this.makeRenderer();
  }

  dispose(): void {
    this.drawing.dispose();
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
    const { backdrop, surfaces } = this.scene;
    const options = { capacity, backdrop, surfaces: drawnSurfaces(surfaces), puffs: this.baked };
    return new SmokeRenderer(this.device, options);
  }
}

function capacityOf(values: Values): number {
  return values['simulation.maxParticles'] as number;
}
