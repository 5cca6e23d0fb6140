import type { BakedPuffs } from './gpu/puffTextures.ts';
import type { Values } from '../parameters/parameter.ts';
import type { PuffShape } from './puffs/shapes.ts';
import type { FrameInput } from './frameInput.ts';
import { LivePuffs } from './livePuffs.ts';
import type { SmokeOptions, SmokeRenderer } from './smoke.ts';
import { loaded } from './extraPasses.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { styleOf, type Style } from './style.ts';

/**
 * Modifies the input of a frame. It can at most double the number of particles, relative to the simulator's capacity.
 */
type FrameOverride = (input: FrameInput) => FrameInput;

type Make = (options: Pick<SmokeOptions, 'capacity' | 'puffs'>) => SmokeRenderer;

/** Smoke as values describe it: its style, its puffs, and a renderer with their capacity. */
export class ShownSmoke {
  values: Values;
  /** The style of the values, with the looks that the simulator had at the last call of `followLooks`. */
  style: Style;
  /** Replaced when the capacity changes. */
  renderer: SmokeRenderer;
  private plain: Style;
  private readonly make: Make;
  private readonly styleIn: (values: Values) => Style;
  private readonly puffs: LivePuffs;
  private baked: BakedPuffs | undefined;
  private change: FrameOverride | undefined;

  constructor(values: Values, make: Make, styleIn = styleOf) {
    this.values = values;
    this.style = this.plain = styleIn(values);
    this.make = make;
    this.styleIn = styleIn;
    this.puffs = new LivePuffs(values);
    this.baked = this.puffs.finish();
    this.renderer = this.makeRenderer();
  }

  /** Applies new values. */
  setValues(values: Values): void {
    const before = capacityOf(this.values);
    this.values = values;
    this.style = this.plain = this.styleIn(values);
    this.puffs.requestPuffs(values);
    if (capacityOf(values) !== before) this.renew();
  }

  /**
   * Takes over the looks that a simulator has now, as far as their code is loaded.
   * @returns whether the style has changed
   */
  followLooks(simulator: Pick<Simulator, 'hasLooks' | 'lookStyles'>): boolean {
    const { plain, values, style } = this;
    if (!simulator.hasLooks) this.style = plain;
    else if (loaded.looks) this.style = loaded.looks.withLooks(plain, values, simulator, style);
    else if (!style.hasLooks) this.style = { ...plain, hasLooks: true };
    return this.style !== style;
  }

  /** Provides at least as many variations as restored particles use. */
  keepVariations(alive: number): void {
    this.puffs.requestPuffs(this.values, alive);
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
    this.renderer.setPuffs(puffs);
  }

  /** Completes the input of a frame. */
  inputOf(given: Omit<FrameInput, 'style'>): FrameInput {
    const input = { ...given, style: this.style };
    return this.change ? this.change(input) : input;
  }

  /** Changes the input of each frame, from the next frame on. Used to draw more than one moment in a picture. */
  overrideFrame(change: FrameOverride): void {
    this.change = change;
    this.renew();
  }

  dispose(): void {
    this.renderer.dispose();
  }

  private renew(): void {
    this.renderer.dispose();
    this.renderer = this.makeRenderer();
  }

  private makeRenderer(): SmokeRenderer {
    const capacity = capacityOf(this.values);
    return this.make({ capacity: this.change ? 2 * capacity : capacity, puffs: this.baked });
  }
}

function capacityOf(values: Values): number {
  return values['simulation.maxParticles'] as number;
}
