import {
  Box3,
  Group,
  Vector2,
  Vector4,
  type Camera,
  type Object3D,
  type Scene,
  type WebGLRenderer,
  Vector3,
} from 'three';
import type { Device } from '../device/device.ts';
import type { BakedPuffs } from '../device/puffTextures.ts';
import { SimulatorError, UnsupportedError } from '../preset/errors.ts';
import type { Values } from '../preset/parameter.ts';
import { requireFinite, requireWhole } from '../preset/values.ts';
import { Clock, STEP_SECONDS } from '../sim/clock.ts';
import { loadSimulators } from '../sim/load.ts';
import type { Simulator } from '../sim/simulator.ts';
import { simulatorValues } from '../sim/simulatorValues.ts';
import { completionOf, type Completion } from '../smoke/completion.ts';
import { fetchExtras } from '../smoke/extraPasses.ts';
import { LivePuffs } from '../smoke/livePuffs.ts';
import type { Style } from '../smoke/style.ts';
import { Colliders, type CollideOptions } from './colliders.ts';
import { borrowDevice, releaseDevice, HostPasses } from './hostPasses.ts';
import { drawIntoHost, markWith } from './hostFrame.ts';
import { lightFrom, requireKeyLight, type KeyLight } from './keyLight.ts';
import {
  hostStyle,
  requireChangeable,
  requireEmitter,
  startValues,
  type CartoonSmokeEvents,
  type CartoonSmokeOptions,
  type CartoonSmokeStats,
  type CastOptions,
} from './options.ts';
import { receiversIn } from './casters.ts';
import { requirementError, requireRenderer } from './requirements.ts';

/** Milliseconds per frame for baking puffs whose parameters have changed. */
const BAKING_MS = 4;
/** Renders before all other blended objects. */
const FIRST = -1e9;

/**
 * Cartoon smoke for an existing three.js scene. Add it to the scene and keep rendering as before. It renders itself
 * into the canvas or the current render target, for any number of cameras, and does not modify materials.
 *
 * ```ts
 * const smoke = await CartoonSmoke.create({ renderer, keyLight, values: { 'style.smokeColor': '#ffffff' } });
 * scene.add(smoke);
 * smoke.collide(robot);
 * renderer.setAnimationLoop(() => { smoke.update(clock.getDelta()); renderer.render(scene, camera); });
 * ```
 *
 * Smoke is simulated in world space: the transform of this object has no effect. The event `error` reports a resource
 * that could not be fetched and that smoke does without; such errors are not thrown from the render loop.
 * See {@link CartoonSmokeEvents}.
 */
export class CartoonSmoke extends Group<CartoonSmokeEvents> {
  private readonly device: Device;
  private readonly keyLight: KeyLight;
  private readonly onRelight: (isInShadow: boolean) => void;
  private readonly simulator: Simulator;
  private readonly passes: HostPasses;
  private readonly colliders: Colliders;
  private readonly nozzles: Nozzle[] = [];
  private readonly hasPhysics: boolean;
  private readonly clock = new Clock();
  private readonly receivers = new Box3();
  private readonly viewport = new Vector4();
  private readonly puffs: LivePuffs;
  private readonly completion: Completion;
  private readonly stopListening: () => void;
  private values: Values;
  private style: Style;
  private now = 0;
  private isDrawing = false;
  private isDisposed = false;
  private error: Error | undefined;
  private drawn = { bodiesDrawn: 0, castersDrawn: 0 };

  /**
   * @throws UnsupportedError when the renderer or the browser lacks a required feature. ParameterError for an unknown
   * preset, a value out of range or an unsupported type of light. LoadError when the simulator cannot be fetched, or
   * the billboards that the values require.
   */
  static async create(options: CartoonSmokeOptions): Promise<CartoonSmoke> {
    requireRenderer(options.renderer);
    requireKeyLight(options.keyLight);
    const values = startValues(options);
    const device = borrowDevice(options.renderer);
    try {
      const [factory] = await Promise.all([
        loadSimulators({ physics: options.physics ?? true }),
        fetchExtras(hostStyle(values)),
      ]);
      const simulator = factory.create({
        capacity: values['simulation.maxParticles'] as number,
        seed: values.seed as number,
      });
      simulator.set(simulatorValues(values));
      return new CartoonSmoke(options, device, values, simulator);
    } catch (error) {
      releaseDevice(device);
      throw error;
    }
  }

  private constructor(options: CartoonSmokeOptions, device: Device, values: Values, simulator: Simulator) {
    super();
    this.name = 'CartoonSmoke';
    this.renderOrder = FIRST;
    this.device = device;
    this.keyLight = options.keyLight;
    this.onRelight = options.onRelight ?? (() => {});
    this.hasPhysics = options.physics ?? true;
    this.simulator = simulator;
    this.values = values;
    this.style = hostStyle(values);
    this.colliders = new Colliders(simulator);
    this.passes = new HostPasses(device, values['simulation.maxParticles'] as number);
    this.puffs = new LivePuffs(values);
    this.showPuffs(this.puffs.finish());
    this.completion = completionOf(
      () => this.style,
      () => {},
      (error) => this.isDisposed || this.dispatchEvent({ type: 'error', error }),
    );
    this.stopListening = this.device.onContext((event) => (event === 'lost' ? this.passes.release() : undefined));
    const { unlitMesh } = this.passes.insert;
    markWith(unlitMesh, (renderer, scene, camera) => this.draw(renderer, scene, camera));
    this.add(unlitMesh);
  }

  /** Makes smoke collide with an object and follow its movement. See {@link CollideOptions}. */
  collide(object: Object3D, options: CollideOptions = {}): void {
    this.requireAlive();
    if (!this.hasPhysics)
      throw new UnsupportedError('collide() does not work with physics: false. Remove that option.');
    this.colliders.add(object, options);
  }

  /**
   * Makes an object cast shadow volumes onto smoke and onto the rest of the scene. Closed rigid meshes use their
   * silhouettes. Other meshes use balls, one for each instance, or several for each bone. An object that is hidden or
   * outside the scene casts no shadow.
   * @throws ParameterError when the object contains no mesh, or an open mesh without proxies
   */
  cast(object: Object3D, { proxies }: CastOptions = {}): void {
    this.requireAlive();
    this.passes.casters.add(object, proxies);
  }

  /**
   * Attaches an emitter to an object: puffs spawn at its origin and leave along its y axis.
   * @param emitter index from 0 to 7, as in `emitters.0.speed`
   * @throws ParameterError for any other index
   */
  emitFrom(object: Object3D, emitter = 0): void {
    this.requireAlive();
    requireEmitter(emitter);
    this.nozzles.push(new Nozzle(object, emitter));
  }

  /**
   * Advances the simulation. Call it once before each render.
   * @param seconds since the last call. The first call advances nothing; later calls advance at most 1/12 s. Frames
   * between two steps are interpolated
   * @throws ParameterError when `seconds` is not finite. UnsupportedError when smoke could not be drawn into a view
   * since the last call
   */
  update(seconds: number): void {
    this.requireAlive();
    requireFinite({ seconds });
    this.throwError();
    this.now += 1000 * seconds;
    this.advance(this.clock.tick(this.now));
    this.showPuffs(this.puffs.workFor(BAKING_MS));
  }

  /**
   * Simulates exactly `count` steps of 1/60 s and shows the last one. The frames are reproducible.
   * @param count integer from 0
   * @throws ParameterError for any other count
   */
  step(count = 1): void {
    this.requireAlive();
    requireWhole('count', count);
    this.throwError();
    this.clock.settle();
    this.advance(count);
    this.showPuffs(this.puffs.finish());
  }

  /**
   * Changes values by their flat keys. If one value is invalid, throws a ParameterError and changes none. The code of
   * billboards is fetched when `puff.form` first selects them. Until it arrives, or if the fetch fails, smoke renders
   * nailboards of lobes. A failure emits one `error` event. Later `set` calls retry only if they change `puff.form` to
   * billboards again; `complete` also retries.
   */
  set(values: Values): void {
    this.requireAlive();
    requireChangeable(values);
    const { form } = this.style;
    this.simulator.set(simulatorValues(values));
    this.values = { ...this.values, ...values };
    this.style = hostStyle(this.values);
    this.puffs.follow(this.values);
    if (this.style.form !== form) this.completion.begin();
  }

  /**
   * Resolves when everything that the current values require is loaded, so that the next frame renders as requested. Use
   * it before recording frames. Failed fetches are retried.
   * @throws LoadError when the fetch fails again; smoke continues without the resource
   */
  async complete(): Promise<void> {
    this.requireAlive();
    await this.completion.wait();
  }

  /** All current values. */
  get(): Values {
    return { ...this.values };
  }

  get stats(): CartoonSmokeStats {
    const { steps, alive, waiting } = this.simulator;
    return { steps, alive, waiting, ...this.drawn };
  }

  /** Hash of the simulator's state, 16 hexadecimal digits. Equal states have equal hashes. */
  hash(): string {
    return this.simulator.hash();
  }

  /**
   * Removes this object from its scene and frees its resources. The renderer and the scene stay usable. Further calls
   * have no effect.
   */
  override dispose(): void {
    if (this.isDisposed) return;
    super.dispose();
    this.isDisposed = true;
    this.removeFromParent();
    this.simulator.dispose();
    this.stopListening();
    this.passes.dispose();
    releaseDevice(this.device);
  }

  private showPuffs(puffs: BakedPuffs | undefined): void {
    if (puffs) this.passes.smoke.setPuffs(puffs);
  }

  /**
   * Draws everything except the marker mesh. Returns false where smoke cannot be drawn; the next `update` throws the
   * reason.
   */
  private draw(renderer: WebGLRenderer, scene: Scene, camera: Camera): boolean {
    if (this.isDrawing || !this.device.isUsable) return false;
    const error = requirementError(renderer, camera);
    if (error) {
      this.error = error;
      return false;
    }
    this.isDrawing = true;
    try {
      const { origin, ...input } = this.lookFrom(renderer, camera);
      const { keyLight, onRelight } = this;
      const view = { renderer, scene, camera, keyLight, origin, onRelight };
      receiversIn(scene, this.receivers);
      this.drawn = drawIntoHost(this.passes, view, { ...input, receivers: this.receivers });
      return true;
    } finally {
      this.isDrawing = false;
    }
  }

  private lookFrom(renderer: WebGLRenderer, camera: Camera) {
    const { x, y, z: width, w: height } = renderer.getCurrentViewport(this.viewport);
    return {
      simulator: this.simulator,
      camera,
      light: lightFrom(this.keyLight),
      style: this.style,
      blend: this.clock.blend,
      time: this.simulator.steps * STEP_SECONDS,
      origin: new Vector2(x, y),
      width,
      height,
      pixelRatio: renderer.getPixelRatio(),
      rigids: [],
      cull: true,
      output: null,
    };
  }

  private advance(steps: number): void {
    if (steps === 0) return;
    this.colliders.look();
    for (let taken = 1; taken <= steps; ++taken) {
      this.colliders.move(taken / steps);
      for (const nozzle of this.nozzles) this.simulator.set(nozzle.values());
      this.simulator.step();
    }
  }

  private throwError(): void {
    const { error } = this;
    this.error = undefined;
    if (error) throw error;
  }

  private requireAlive(): void {
    if (this.isDisposed) throw new SimulatorError('This smoke was disposed; create a new one.');
  }
}

/** Binds an emitter to the transform of an object. */
class Nozzle {
  private readonly object: Object3D;
  private readonly key: string;
  private readonly position = new Vector3();
  private readonly direction = new Vector3();

  constructor(object: Object3D, emitter: number) {
    this.object = object;
    this.key = `emitters.${emitter}`;
  }

  /** The emitter's parameters for the current transform of the object. */
  values(): Record<string, number> {
    const { object, key, position, direction } = this;
    object.updateWorldMatrix(true, false);
    position.setFromMatrixPosition(object.matrixWorld);
    direction.set(0, 1, 0).transformDirection(object.matrixWorld);
    return { ...vectorValues(`${key}.position`, position), ...vectorValues(`${key}.direction`, direction) };
  }
}

function vectorValues(key: string, { x, y, z }: Vector3): Record<string, number> {
  return { [`${key}.x`]: x, [`${key}.y`]: y, [`${key}.z`]: z };
}
