import {
  BufferAttribute,
  BufferGeometry,
  Group,
  Object3D,
  Vector3,
  type Camera,
  type JSONMeta,
  type Material,
  type Object3DJSON,
  type PointLight,
  type Scene,
  type WebGLRenderer,
} from 'three';
import type { Device } from '../renderer/gpu/device.ts';
import { SimulatorError, SmokeError, UnsupportedError, type LoadError } from '../base/errors.ts';
import { runOnSelf } from '../base/onSelf.ts';
import type { AnyValues, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { requireFinite, requireWhole } from '../parameters/values.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { Clock } from '../simulator/clock.ts';
import { loadSimulators, type LoadOptions, type LoadProgress } from '../simulator/load.ts';
import { MESHES } from '../simulator/meshes.ts';
import { hasRareForces } from '../simulator/rareForces.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { savedLooks } from '../simulator/savedState.ts';
import { simulatorValues, valuesIn } from '../simulator/simulatorValues.ts';
import { AnimationLoading, completionOf, type Completion } from '../renderer/completion.ts';
import {
  fetchExtras,
  fetchTimelineText,
  loaded,
  missingExtras,
  timelineText,
  type PictureKind,
} from '../renderer/extraPasses.ts';
import type { Animation } from '../simulator/animation.ts';
import { requireShapes } from '../renderer/puffs/lobes.ts';
import type { PuffShape } from '../renderer/puffs/shapes.ts';
import { ShownSmoke } from '../renderer/shownSmoke.ts';
import { SmokeRenderer } from '../renderer/smoke.ts';
import type { Style } from '../renderer/style.ts';
import { Attachment } from './attachment.ts';
import { ItemMotion } from './itemMotion.ts';
import { Caster } from './caster.ts';
import { Collider, requireCollideOptions, type CollideOptions, type Obstacles } from './colliders.ts';
import type { BurstOptions, EmitterOptions } from '../simulator/emitterOptions.ts';
import { EmitterPool, PooledEmitter, TableEmitter, TableNumbers, type EmitterHandle } from './emitters.ts';
import { SmokeFrame, type SmokeSpace } from './smokeSpace.ts';
import { GlowLights } from './glowLights.ts';
import { Handles, type Handle, type SmokeHandle } from './handle.ts';
import { borrowDevice, releaseDevice, HostPasses } from './hostPasses.ts';
import { drawIntoHost } from './hostFrame.ts';
import { requireKeyLight, type KeyLight } from './keyLight.ts';
import {
  changeable,
  hostStyle,
  loadPreset,
  ofSmoke,
  requireChangeable,
  requireCreation,
  startValues,
  type CartoonSmokeEvents,
  type CartoonSmokeOptions,
  type CartoonSmokeStats,
  type CastOptions,
} from './options.ts';
import { Overrides } from './overrides.ts';
import { PushedObject } from './pushed.ts';
import { isEmptyView, isOverridden, requireRenderer } from './requirements.ts';
import { ObjectParts } from './objectParts.ts';
import { SceneLight, type LitSmoke } from './sceneLight.ts';

/** Milliseconds per frame for baking puffs whose parameters have changed. */
const BAKING_MS = 4;
const NOTHING = { bodiesDrawn: 0, castersDrawn: 0 };
/** Renders before all other blended objects. */
const FIRST = -1e9;

/**
 * Cartoon smoke for an existing three.js scene. Add it to the scene and keep rendering as before. It renders itself
 * into the canvas or the current render target, for any number of cameras, and does not modify materials.
 *
 * ```ts
 * const smoke = await CartoonSmoke.create({ renderer, keyLight, values: { 'style.smokeColor': '#ffffff' } });
 * scene.add(smoke);
 * const exhaust = smoke.emitFrom(car, { rate: 40, inherit: 0.3 });
 * smoke.collide(robot);
 * renderer.setAnimationLoop(() => { smoke.update(clock.getDelta()); renderer.render(scene, camera); });
 * ```
 *
 * The transform of this object carries the emitters, forces and obstacles of the parameter table. Puffs that exist stay in
 * the world, or travel with the object if its {@link space} is `local`. A uniform scale enlarges the smoke. The event
 * `error` reports what fails in the render loop, which never throws. See {@link CartoonSmokeEvents}.
 */
export class CartoonSmoke extends Object3D<CartoonSmokeEvents> {
  /** Gives smoke its place among the blended objects that three.js draws. Tools that look for meshes skip sprites. */
  readonly isSprite = true;
  /** Empty, for tools that read the geometry of every object. */
  readonly geometry: BufferGeometry = new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(new Float32Array(), 3),
  );
  /** What three.js draws {@link geometry} with. It is visible while there is smoke. */
  readonly material: Material;
  /** What its transform does to puffs that exist, as given to `create`. */
  readonly space: SmokeSpace;
  /** Whether smoke and the objects of {@link cast} cast shadow volumes. `castShadow` of three.js has no effect. */
  castsShadow = true;
  private readonly device: Device;
  private light: KeyLight;
  private readonly sceneLight: SceneLight | undefined;
  private readonly onRelight: (isInShadow: boolean) => void;
  private readonly simulator: Simulator;
  private glow: GlowLights | undefined;
  /** The state before the first step, without handles. */
  private readonly start: Uint8Array;
  private readonly passes: HostPasses;
  private readonly handles: Handles;
  private readonly parts: ObjectParts;
  private readonly emitters: EmitterPool;
  private readonly overrides: Overrides;
  private readonly table: TableNumbers;
  private readonly frame: SmokeFrame;
  private readonly itemMotion: ItemMotion;
  private readonly attached = new Set<string>();
  /** Messages of the errors that were reported, each of which is reported once. */
  private readonly reported = new Set<string>();
  private readonly obstacles: Obstacles;
  /** The simulator that handles need and that is not loaded yet. */
  private needed: LoadOptions['physics'] = false;
  private larger: Promise<void> | undefined;
  private readonly mayBeLarger: boolean | undefined;
  /** Whether the simulator with rare forces could not be loaded: smoke goes on without them. */
  private goesWithoutForces = false;
  private readonly clock = new Clock();
  /** As callers have set them. */
  private values: Values;
  /** With those of the timeline that the simulator has; another object after each change. */
  private simulated: Values;
  /** Undefined without a timeline, and until its code is loaded. */
  private animation: Animation | undefined;
  private readonly loading = new AnimationLoading({
    isAnimated: () => this.isAnimated,
    isWaiting: () => this.isWaiting,
    set: (values) => this.setNow(values),
    play: () => this.play(),
    load: () => this.completion.begin(),
  });
  private readonly shown: ShownSmoke;
  private readonly completion: Completion;
  private readonly stopListening: () => void;
  private now = 0;
  private isDrawing = false;
  /** Whether its programs exist. The first frame compiles them, so that the first puff does not wait. */
  private hasDrawn = false;
  private isPlaced = true;
  private isDisposed = false;
  private error: unknown;
  private drawn = NOTHING;
  private unshadowed: { readonly of: Style; readonly style: Style } | undefined;

  /**
   * @throws UnsupportedError when the renderer or the browser lacks a required feature. ParameterError for an unknown
   * preset, a value out of range or an unsupported type of light. LoadError when the simulator, the preset or the code that
   * the values require cannot be fetched.
   */
  static async create(options: CartoonSmokeOptions): Promise<CartoonSmoke> {
    requireCreation(options);
    requireRenderer(options.renderer);
    requireKeyLight(options.keyLight);
    const given = { preset: options.preset, values: { ...options.values } };
    await loadPreset(given.preset);
    const values = await fetchTimelineText(startValues(given));
    const demands = loaded.animation?.demandsIn(values.timeline!);
    requireForces(values, options.physics);
    const device = borrowDevice(options.renderer);
    try {
      const [factory] = await Promise.all([
        loadSimulators({ physics: options.physics || (hasRareForces(values) && MESHES) }),
        // Casters that are balls are lobes and do not deform. Volumes are counted where the host's buffer is multisampled.
        fetchExtras({ ...hostStyle(values), form: 'lobes', isDeformed: false, volumes: 'counted' }),
        // Lamps of the host weaken.
        fetchExtras({
          ...hostStyle(values),
          ...(options.light === 'scene' && { lampLight: [1, 1, 1], hasAdditionalLights: true }),
        }),
        fetchExtras(hostStyle({ ...values, ...demands })),
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
    if (!(simulator as Simulator | undefined))
      throw new UnsupportedError('Smoke is created asynchronously: use await CartoonSmoke.create() instead of new.');
    this.name = 'CartoonSmoke';
    this.renderOrder = FIRST;
    this.device = device;
    this.light = options.keyLight;
    if (options.light === 'scene') this.sceneLight = new SceneLight(options.lightReference);
    this.onRelight = options.onRelight ?? (() => {});
    this.simulator = simulator;
    this.start = simulator.save();
    this.values = values;
    this.simulated = values;
    this.shown = new ShownSmoke(values, (given) => new SmokeRenderer(device, given), hostStyle);
    this.space = options.space ?? 'world';
    this.frame = new SmokeFrame(this.space);
    this.parts = new ObjectParts(simulator, this.frame);
    this.emitters = new EmitterPool(simulator, this.parts);
    this.overrides = new Overrides(simulator, (key) => this.itemMotion.numberOf(key));
    this.table = new TableNumbers(simulator, this.overrides, () => this.simulated);
    const { parts, overrides, frame } = this;
    this.mayBeLarger = options.physics;
    const need: Obstacles['need'] = (what) => this.need(what);
    this.obstacles = { simulator, frame, taken: new Set(), need };
    this.itemMotion = new ItemMotion({ simulator, parts, overrides, frame, values: () => this.simulated });
    const report = (error: unknown) => this.report(error);
    this.handles = new Handles({ object: this, report, isAlive: () => !this.isDisposed });
    const miss = (error: LoadError) => this.isDisposed || this.report(error);
    this.passes = new HostPasses(this.shown.renderer, device, values['simulation.maxParticles'] as number, frame, miss);
    this.completion = completionOf(
      () => this.kinds,
      () => this.isDisposed || this.loading.end(),
      (error) => {
        miss(error);
        if (!this.isDisposed) this.loading.end();
      },
    );
    this.play();
    this.stopListening = this.device.onContext((event) => {
      if (event !== 'lost') return;
      this.passes.release();
      this.hasDrawn = false;
    });
    this.material = this.passes.insert.placeholder;
    this.material.onBeforeRender = (renderer, scene, camera) => this.draw(renderer, scene, camera);
    Object.defineProperty(this, 'frustumCulled', { get: () => false, set: () => {} });
    runOnSelf(this, Object3D.prototype);
  }

  /** The light that shades smoke and that smoke blocks. Another one takes effect in the next frame. */
  get keyLight(): KeyLight {
    return this.light;
  }

  /** @throws ParameterError for an unsupported type of light */
  set keyLight(light: KeyLight) {
    requireKeyLight(light);
    this.light = light;
  }

  /**
   * Makes smoke collide with an object and follow its movement. See {@link CollideOptions}. Boxes, spheres and capsules need no
   * more code. Other meshes and `boundaryLayer` load a larger simulator first, `feelsSmoke` the largest, see the event
   * `progress`; `complete` waits for it.
   * @throws ParameterError for an invalid option, or when the object contains no mesh. UnsupportedError when it needs a
   * larger simulator and `physics` is false
   */
  collide(object: Object3D, options: CollideOptions = {}): SmokeHandle {
    this.requirePlaced();
    requireCollideOptions(options);
    const Kind = options.feelsSmoke ? PushedObject : Collider;
    return this.handles.add<Handle>(new Kind(this.obstacles, object, options));
  }

  /**
   * Makes an object cast shadow volumes onto smoke and onto the rest of the scene. Closed rigid meshes use their
   * silhouettes. Other meshes use balls, one for each instance, or several for each bone. An object that is hidden or
   * outside the scene casts no shadow.
   * @throws ParameterError when the object contains no mesh, or an open mesh without proxies
   */
  cast(object: Object3D, options: CastOptions = {}): SmokeHandle {
    this.requirePlaced();
    const caster = this.handles.add(new Caster(this.passes.casters, this.frame, object, options));
    this.markVisible();
    return caster;
  }

  /**
   * Emits puffs from an object: they spawn at its origin and leave along its y axis. At most 128 objects at a time.
   * @param emitter options of an emitter of its own, or the index of an emitter of the parameter table from 0 to 7, as
   * in `emitters.0.speed`, which then moves. Without it, an emitter of its own has the values of emitter 0, also after
   * `set`, and its rate. From that call on, emitter 0 itself is silent. An emitter of the table is silent while its handles
   * are paused and after they are removed
   * @throws ParameterError for any other index, an unknown option or an invalid value
   */
  emitFrom(object: Object3D, emitter?: EmitterOptions | number): EmitterHandle {
    this.requirePlaced();
    const own = emitter === undefined ? this.table : emitter;
    if (typeof own === 'object') return this.handles.add(new PooledEmitter(this.emitters, object, own));
    const { simulator, overrides, frame, emitters } = this;
    const release = (item: string) => this.itemMotion.release(item);
    const context = { simulator, overrides, frame, emitters, release, set: (values: Values) => this.set(values) };
    return this.handles.add(new TableEmitter(context, object, own));
  }

  /**
   * Emits puffs at once in the next step. While smoke is full they wait. At most 256 bursts wait; the next one replaces
   * the oldest.
   * @returns resolves in the step in which the last of these puffs ends by its lifetime, and when all puffs are cleared
   * @throws ParameterError for an unknown option or an invalid value
   */
  burst(options: BurstOptions): Promise<void> {
    this.requirePlaced();
    return this.emitters.burst(options);
  }

  /**
   * Lets a force or an emitter of the parameter table ride on an object. Its position and its directions are those in the
   * space of the object, without its scale. While its handle is paused it has no effect; `remove` leaves it where its
   * values are.
   * @param item such as `vortices.0`
   * @throws ParameterError for any other name, or when it rides on an object already
   */
  override attach(item: string, object: Object3D): SmokeHandle;
  /** Adds a child that keeps its world transform, as any Object3D does. */
  override attach(object: Object3D): this;
  override attach(item: string | Object3D, object?: Object3D): SmokeHandle | this {
    if (typeof item === 'object' && object === undefined) return super.attach(item);
    this.requirePlaced();
    const { parts, overrides, attached } = this;
    return this.handles.add(new Attachment({ parts, overrides, attached }, item as string, object!));
  }

  /**
   * Advances the simulation. Call it once before each render. It never throws: the event `error` reports what fails.
   * @param seconds since the last call. The first call advances nothing; later calls advance at most 1/12 s. Frames
   * between two steps are interpolated
   */
  update(seconds: number): void {
    try {
      this.requireAlive();
      requireFinite({ seconds });
      this.reportDrawing();
      this.now += 1000 * seconds;
      const steps = this.clock.tick(this.now);
      // The clock waits for the timeline.
      this.advance(this.loading.isOver ? steps : 0);
      this.showTime(BAKING_MS);
    } catch (error) {
      this.reportOnce(error);
    }
  }

  /**
   * Simulates exactly `count` steps of 1/60 s and shows the last one. The frames are reproducible.
   * @param count integer from 0
   * @throws ParameterError for any other count
   */
  step(count = 1): void {
    this.requireAlive();
    requireWhole('count', count);
    this.reportDrawing();
    this.loading.whenOver(() => {
      this.clock.settle();
      this.advance(count);
      this.showTime();
    });
  }

  /**
   * Changes values by their flat keys. If one value is invalid, throws a ParameterError and changes none. The code of
   * billboards, simplified light, strokes and bites is fetched when a value first selects it. Until it arrives, or if the
   * fetch fails, smoke renders plain nailboards of lobes. A failure emits one `error` event. Later `set` calls retry only
   * if they select it again; `complete` also retries.
   */
  set(values: GivenValues): void {
    this.requireAlive();
    this.loading.set(values)?.catch((error: unknown) => this.isDisposed || this.report(error));
  }

  /**
   * Draws puffs with custom shapes, one per variation, such as those that `drawPuff` and `fitPuff` make. Without an
   * argument, the values define the shapes again.
   * @throws ShapeError when a shape is invalid; the smoke is unchanged then
   */
  setPuffs(shapes?: readonly PuffShape[]): void {
    this.requireAlive();
    if (shapes) requireShapes(shapes);
    this.shown.usePuffs(shapes);
  }

  /**
   * Resolves when everything that the current values require is loaded, so that the next frame renders as requested. Use
   * it before recording frames. Failed fetches are retried.
   * @throws LoadError when the fetch fails again; smoke continues without the resource
   */
  async complete(): Promise<void> {
    this.requireAlive();
    const larger = this.needed ? this.loadLarger() : undefined;
    await Promise.all([this.completion.wait(), this.passes.ownStencil.wait(), larger]);
  }

  /** All current values that `set` takes. */
  get(): Values {
    return changeable(this.values);
  }

  /** Removes all puffs, and those that wait. Handles, emitters, values and the children of this object stay. */
  override clear(): this {
    this.requireAlive();
    this.simulator.inputClear();
    this.emitters.resolve(() => true);
    this.markVisible();
    this.showLatest();
    return this;
  }

  /** Restarts from the first step with the current values. Handles stay and act from where their objects are. */
  restart(): void {
    this.requireAlive();
    this.restoreState(this.start);
    this.animation?.restore(this.start, this.values);
    this.useValues(this.values);
  }

  /** Serializes the simulator's state and the values that it reads, without the effects of handles on them. */
  save(): Uint8Array {
    this.requireAlive();
    const { simulator } = this;
    const values: AnyValues = this.values;
    const numbers = simulator.parameters();
    const initial = [...numbers.keys(), ...Object.keys(values)].flatMap((key) => {
      const value = findParameter(key)?.default;
      return value === undefined ? [] : [[key, value] as const];
    });
    const defaults: AnyValues = Object.fromEntries(initial);
    const plain = simulatorValues({ ...defaults, ...values });
    simulator.set(plain);
    const bytes = simulator.save(values);
    // The simulator leaves out some numbers that have their defaults.
    simulator.set({ ...simulatorValues(defaults), ...Object.fromEntries(numbers) });
    return this.animation?.saved(bytes, simulator.steps) ?? bytes;
  }

  /**
   * Restores a state, also of another smoke, and the values that the simulator reads. Handles stay and act from where their
   * objects are: objects that smoke pushes start at rest. The capacity stays.
   * @throws SimulatorError for invalid bytes, or if its particles exceed the capacity; nothing changes then
   */
  restore(bytes: Uint8Array): void {
    this.requireAlive();
    this.restoreState(bytes);
    const values = valuesIn(this.simulator, { ...this.values, ...savedLooks(bytes) }, {});
    this.animation?.restore(bytes, values);
    this.useValues(values);
    this.shown.keepVariations(this.simulator.variationsAlive);
  }

  /**
   * Three lights at the parts of smoke that glow by `emission.glow`, for the other objects of the scene:
   * `smoke.add(...smoke.glowLights)`. Each `update` and `step` sets their position in the space of this object, metres, their
   * colour, and their intensity in candela, which is 0 if nothing glows. The smoke itself is lit there with and without them. The first access creates them.
   */
  get glowLights(): readonly PointLight[] {
    this.requireAlive();
    if (!this.glow) {
      this.glow = new GlowLights();
      this.showLatest();
    }
    return this.glow.lights;
  }

  get stats(): CartoonSmokeStats {
    const { steps, alive, waiting } = this.simulator;
    return { steps, alive, waiting, ...this.drawn };
  }

  /** Hash of the simulator's state, 16 hexadecimal digits. Equal states have equal hashes. */
  hash(): string {
    return this.simulator.hash();
  }

  /** Also when its parent holds a Proxy of it. */
  override removeFromParent(): this {
    const self = this.parent?.children.find(({ uuid }) => uuid === this.uuid);
    if (self) this.parent!.remove(self);
    return this;
  }

  /** @throws UnsupportedError always: a copy needs a simulator of its own, which takes time to create */
  override clone(): this {
    throw new UnsupportedError('Smoke cannot be cloned, since its simulator is created asynchronously: call create().');
  }

  /**
   * In the JSON of a parent, a group with the transform and the children of smoke.
   * @throws UnsupportedError when called for smoke itself: JSON cannot hold the state of the simulator
   */
  override toJSON(meta?: JSONMeta): Object3DJSON {
    if (typeof meta === 'object') {
      const { uuid } = this;
      return Object.assign(new Group().copy(this), { uuid, renderOrder: 0 }).toJSON(meta);
    }
    throw new UnsupportedError(
      'Smoke cannot be written as JSON: keep its values by get(), or call toJSON() of its scene, which leaves smoke out.',
    );
  }

  /**
   * Removes this object from its scene and frees its resources. The renderer and the scene stay usable. Further calls
   * have no effect.
   */
  override dispose(): void {
    if (this.isDisposed) return;
    // Before three.js 0.186 objects have no dispose(), which does no more than this.
    this.dispatchEvent({ type: 'dispose' });
    this.isDisposed = true;
    this.emitters.resolve(() => true);
    this.removeFromParent();
    this.simulator.dispose();
    this.stopListening();
    this.geometry.dispose();
    this.passes.dispose();
    this.glow?.dispose();
    releaseDevice(this.device);
  }

  private setNow(given: GivenValues): void {
    const { simulator, animation } = this;
    const values = timelineText(given);
    requireChangeable(values);
    requireForces(values, this.mayBeLarger);
    const after = { ...this.values, ...values };
    simulator.set(this.overrides.over(simulatorValues(values, after)));
    if (animation) {
      const now = { steps: simulator.steps, time: this.drawnTime };
      const { changed } = animation.changedBy(this.values, after, values, now, false);
      animation.record(changed, now);
      animation.reset();
    }
    this.change(after);
    this.showLatest();
  }

  /** Takes over values that the simulator has. */
  private change(values: Values): void {
    const missing = () => this.kinds.map(missingExtras).join();
    const before = missing();
    const isOther = values.timeline !== this.values.timeline;
    this.values = values;
    this.simulated = values;
    if (isOther) this.play();
    this.animation?.follow(this.drawnTime);
    this.showValues();
    if (this.isWaiting && this.mayBeLarger !== false) this.need('meshes');
    if (missing() !== before) this.completion.begin();
  }

  private get isAnimated(): boolean {
    return (this.values.timeline ?? '') !== '';
  }

  /** Whether it must move to a simulator with rare forces before the next step. */
  private get isWaiting(): boolean {
    const { simulator, goesWithoutForces, mayBeLarger } = this;
    if (goesWithoutForces || mayBeLarger === false) return false;
    return simulator.lacksForces || (!simulator.hasRigids && hasRareForces({ timeline: this.values.timeline! }));
  }

  /** Plays the timeline of the values if its code is loaded. */
  private play(): void {
    if (this.isAnimated && loaded.animation) this.animation ??= new loaded.animation.Animation();
    this.animation?.play(this.values.timeline ?? '');
  }

  private showValues(): void {
    this.shown.setValues({ ...this.values, ...ofSmoke(this.animation?.shown ?? {}) });
  }

  /** Of the current picture, and of all that the timeline leads to. */
  private get kinds(): readonly PictureKind[] {
    const { values, animation, loading, shown } = this;
    shown.followLooks(this.simulator);
    const demanding = animation && hostStyle({ ...values, ...ofSmoke(animation.demands) });
    return [{ ...shown.style, isAnimated: loading.isAnimationWanted }, ...(demanding ? [demanding] : [])];
  }

  /** The simulated time that is drawn, in steps. */
  private get drawnTime(): number {
    return Math.max(0, this.simulator.steps - 1 + this.clock.blend);
  }

  /** Shows the drawn time. */
  private showTime(bakingMs?: number): void {
    if (this.animation?.follow(this.drawnTime)) this.showValues();
    this.handles.show(this.clock.blend);
    this.shown.bake(bakingMs);
    this.markVisible();
    this.showLatest();
  }

  /** Starts to load a larger simulator. @throws UnsupportedError if the options forbid it */
  private need(what: 'meshes' | 'physics'): void {
    if (this.mayBeLarger === false)
      throw new UnsupportedError(
        'With physics: false, collide() works with boxes, spheres and capsules only. Remove that option.',
      );
    // Physics has meshes, too.
    if (this.needed !== true) this.needed = what === 'physics' || MESHES;
    if (this.larger) return;
    this.loadLarger().catch((error: unknown) => {
      if (this.isDisposed) return;
      this.report(error);
      this.goesWithoutForces = true;
      this.loading.end();
    });
  }

  /** Replaces the simulator by the one that is needed. Concurrent calls share one request. */
  private loadLarger(): Promise<void> {
    const load = async (physics: LoadOptions['physics']): Promise<void> => {
      const onProgress = (progress: LoadProgress) => this.dispatchEvent({ type: 'progress', ...progress });
      const { module } = await loadSimulators({ physics, onProgress });
      if (this.isDisposed) return;
      this.simulator.moveTo(module);
      this.loading.end();
      // Meanwhile an object may have come that needs more.
      if (this.needed !== physics) return load(this.needed);
      this.needed = false;
    };
    return (this.larger ??= load(this.needed).finally(() => (this.larger = undefined)));
  }

  /** Puts the simulator into a state without handles. */
  private restoreState(bytes: Uint8Array): void {
    const { simulator } = this;
    const before = simulator.save();
    // The handles end in the state that has what they own, after the new one has proved valid.
    simulator.restore(bytes, false);
    simulator.restore(before);
    this.handles.pause();
    simulator.restore(bytes, false);
    this.emitters.resolve(() => true);
  }

  /** Applies values and handles to a simulator that took another state, and shows it. */
  private useValues(values: Values): void {
    this.overrides.setAll(simulatorValues(values));
    this.change(values);
    if (this.simulator.steps === 0) this.place(1);
    this.handles.look();
    this.emitters.freeOthers();
    this.clock.settle();
    this.handles.show(this.clock.blend);
    this.markVisible();
    this.showLatest();
  }

  /** Draws smoke. The next `update` reports why it could not be drawn. */
  private draw(renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
    if (this.isDrawing || !this.device.isUsable) return;
    if (isOverridden(renderer, scene) || isEmptyView(renderer, camera)) return;
    this.isDrawing = true;
    try {
      const { keyLight, onRelight, frame, simulator } = this;
      const smoke = { object: this, frame, simulator, ...this.litIn(scene, camera), blend: this.clock.blend };
      this.drawn = drawIntoHost(this.passes, { renderer, scene, camera, keyLight, onRelight }, smoke);
      this.hasDrawn = true;
    } catch (failure) {
      this.error = failure;
    } finally {
      this.isDrawing = false;
    }
  }

  /** The style and the lights of the current frame. */
  private litIn(scene: Scene, camera: Camera): LitSmoke {
    const { shown, sceneLight, keyLight, castsShadow } = this;
    const place = new Vector3().setFromMatrixPosition(this.matrixWorld);
    const own = this.glow?.lights ?? [];
    const lit = sceneLight?.under(shown.style, { scene, camera, keyLight, own }, place) ?? {
      style: shown.style,
      lights: [],
    };
    if (castsShadow || !lit.style.shadows) return lit;
    // Renderers compare styles by identity.
    if (this.unshadowed?.of !== lit.style) this.unshadowed = { of: lit.style, style: { ...lit.style, shadows: false } };
    return { ...lit, style: this.unshadowed.style };
  }

  /** Hides the smoke while there is nothing to draw, so that a frame costs nothing. */
  private markVisible(): void {
    const isVisible = !this.hasDrawn || this.simulator.alive > 0 || !this.passes.casters.isEmpty;
    this.material.visible = isVisible;
    if (!isVisible) this.drawn = NOTHING;
  }

  /** Takes over the looks of the current frame, and moves the lights at glowing smoke. */
  private showLatest(): void {
    const { frame, simulator, shown, clock } = this;
    if (shown.followLooks(simulator)) this.completion.begin();
    this.glow?.show({ object: this, frame, simulator, style: shown.style, blend: clock.blend });
  }

  private advance(steps: number): void {
    if (steps === 0) return;
    this.place(steps);
    this.handles.look();
    for (let taken = 0; taken < steps; ++taken) {
      const [from, to] = [taken / steps, (taken + 1) / steps];
      this.animation?.prepare(this.simulator, this.playing);
      this.handles.move(from, to);
      this.itemMotion.place((from + to) / 2);
      this.parts.place(from, to);
      this.simulator.step();
      this.emitters.settle();
    }
  }

  /** How the simulator takes what the timeline plays. */
  private readonly playing = {
    put: (values: Values): void => {
      this.simulated = { ...this.simulated, ...values };
      this.simulator.set(this.overrides.over(simulatorValues(values)));
      this.itemMotion.refresh();
      for (const emitter of this.emitters.followers) emitter.followTable();
    },
    isSilent: (emitter: number): boolean => this.overrides.isSilent(`emitters.${emitter}`),
  };

  /** Reads the transform of this object. Reports errors once, until it is sound again. */
  private place(steps: number): void {
    try {
      this.itemMotion.look(this, steps, this.simulator.steps === 0);
      this.isPlaced = true;
    } catch (error) {
      if (this.isPlaced) this.report(error);
      this.isPlaced = false;
    }
  }

  /** Reports why smoke could not be drawn since the last call. */
  private reportDrawing(): void {
    const { error } = this;
    this.error = undefined;
    if (error) this.reportOnce(error);
  }

  private reportOnce(error: unknown): void {
    const message = String(error);
    if (this.reported.has(message)) return;
    this.reported.add(message);
    this.report(error);
  }

  private report(error: unknown): void {
    const known = error instanceof SmokeError ? error : new SimulatorError(String(error), { cause: error });
    this.dispatchEvent({ type: 'error', error: known });
  }

  private requireAlive(): void {
    if (this.isDisposed) throw new SimulatorError('This smoke was disposed; create a new one.');
  }

  /** Before the first step, calls place objects in the space that the smoke has now. */
  private requirePlaced(): void {
    this.requireAlive();
    if (this.simulator.steps === 0) this.place(1);
  }
}

/** @throws UnsupportedError for values with rare forces where no larger simulator may be loaded */
function requireForces(values: Values, mayBeLarger: boolean | undefined): void {
  if (mayBeLarger === false && hasRareForces(values))
    throw new UnsupportedError('With physics: false, smoke has no flows. Remove that option.');
}
