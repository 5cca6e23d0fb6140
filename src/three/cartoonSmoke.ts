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

/** Spent with each picture on puffs whose knobs have been turned. */
const BAKING_MS = 4;
/** Before everything else that is blended. */
const FIRST = -1e9;

/**
 * Cartoon smoke for a three.js scene of your own: add it to the scene and go on rendering as before. It draws itself
 * into whatever the renderer draws, canvas or target, for any number of cameras, and leaves materials untouched.
 *
 * ```ts
 * const smoke = await CartoonSmoke.create({ renderer, keyLight, values: { 'style.smokeColor': '#ffffff' } });
 * scene.add(smoke);
 * smoke.collide(robot);
 * renderer.setAnimationLoop(() => { smoke.update(clock.getDelta()); renderer.render(scene, camera); });
 * ```
 *
 * Smoke lives in world space: where this object stands changes nothing. Its event `error` tells what could not be fetched and
 * is left out; no such thing is thrown into your frames. See {@link CartoonSmokeEvents}.
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
   * @throws UnsupportedError when the renderer lacks something, or the browser does. ParameterError for an unknown preset,
   * a value out of range, or a light of another kind. LoadError when the simulator cannot be fetched, or
   * billboards that the values ask for.
   */
  static async create(options: CartoonSmokeOptions): Promise<CartoonSmoke> {
    requireRenderer(options.renderer);
    requireKeyLight(options.keyLight);
    const values = startValues(options);
    const device = borrowDevice(options.renderer);
    try {
      const [factory] = await Promise.all([
        loadSimulators({ physics: options.physics ?? true }),
        fetchExtras({ ...hostStyle(values), isFlat: !device.writesDepth }),
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

  /** Lets smoke bump into an object, wherever that goes from now on. See {@link CollideOptions}. */
  collide(object: Object3D, options: CollideOptions = {}): void {
    this.requireAlive();
    if (!this.hasPhysics)
      throw new UnsupportedError('collide() does not work with physics: false. Remove that option.');
    this.colliders.add(object, options);
  }

  /**
   * Lets an object throw its shadow onto smoke and onto all else: closed rigid meshes by their silhouettes, others by
   * balls, one for each bone or instance. While it is hidden or out of the scene it throws none.
   * @throws ParameterError when there is no mesh in it, or one that is open and has no proxies
   */
  cast(object: Object3D, { proxies }: CastOptions = {}): void {
    this.requireAlive();
    this.passes.casters.add(object, proxies);
  }

  /**
   * Lets an emitter follow an object: puffs are born at its origin and leave along its y axis.
   * @param emitter 0 to 7, as of `emitters.0.speed` and so on
   * @throws ParameterError for another one
   */
  emitFrom(object: Object3D, emitter = 0): void {
    this.requireAlive();
    requireEmitter(emitter);
    this.nozzles.push(new Nozzle(object, emitter));
  }

  /**
   * Lets time pass: once before each picture.
   * @param seconds since the last call; those of the first one do not pass, and a twelfth of a second at most at once. Pictures
   * between two steps are interpolated
   * @throws ParameterError for what is no number. UnsupportedError for a view that smoke could not be drawn into since the last call
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
   * Makes exactly so many steps of 1/60 s, and shows the last one: the same pictures each time.
   * @param count a whole number from 0
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
   * Changes values by their flat keys: all of them, or none when one is refused, with a ParameterError. The code of billboards
   * is fetched when `puff.form` first becomes theirs; until it has come, and where it cannot be had, nailboards of lobes are
   * drawn. An `error` event tells so once, and no later `set` of other values tries anew: `complete` does, or asking for
   * billboards again after lobes.
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
   * Settled when the next picture is drawn as the values ask: for whoever records pictures. What could not be fetched is tried
   * anew.
   * @throws LoadError when it cannot be fetched: smoke goes on without it
   */
  async complete(): Promise<void> {
    this.requireAlive();
    await this.completion.wait();
  }

  /** All values that smoke has. */
  get(): Values {
    return { ...this.values };
  }

  get stats(): CartoonSmokeStats {
    const { steps, alive, waiting } = this.simulator;
    return { steps, alive, waiting, ...this.drawn };
  }

  /** The simulator's state in 16 digits: equal states, equal hashes. */
  hash(): string {
    return this.simulator.hash();
  }

  /** Takes it out of its scene and gives everything back. Renderer and scene stay yours. May be called again. */
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

  /** Draws all but the marker itself; false where smoke cannot be drawn, which the next update tells. */
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

/** Where an emitter is, while it follows an object. */
class Nozzle {
  private readonly object: Object3D;
  private readonly key: string;
  private readonly position = new Vector3();
  private readonly direction = new Vector3();

  constructor(object: Object3D, emitter: number) {
    this.object = object;
    this.key = `emitters.${emitter}`;
  }

  /** The simulator's values for it as the object stands now. */
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
