import { MathUtils, Vector2, Vector3 } from 'three';
import type { DeviceCanvas } from '../device/device.ts';
import type { BakedPuffs } from '../device/puffTextures.ts';
import { DEBUG_VIEWS, LOWEST_QUALITY, type DebugView, type Quality } from '../preset/environment.ts';
import { ParameterError, SimulatorError } from '../preset/errors.ts';
import type { Values } from '../preset/parameter.ts';
import { defaults, requireOptional, validate } from '../preset/values.ts';
import { demandShapes } from '../puffs/demandShapes.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import type { Scene } from '../scenes/scene.ts';
import { sceneNamed } from '../scenes/scenes.ts';
import { loadSimulators, type SimulatorFactory } from '../sim/load.ts';
import type { FrameReport } from '../smoke/frame.ts';
import { lightOf, type Light } from '../smoke/light.ts';
import { LivePuffs } from '../smoke/livePuffs.ts';
import { SmokeRenderer } from '../smoke/smoke.ts';
import { styleOf, type Style } from '../smoke/style.ts';
import { blowOf, type BlowInput } from './blow.ts';
import { Clock, STEP_SECONDS } from '../sim/clock.ts';
import type { PointerInput, SeekOptions, StageEvents, StageOptions, StageStats } from './contract.ts';
import { Governor } from './governor.ts';
import { Listeners } from './listeners.ts';
import { OrbitCamera } from './orbit.ts';
import { createPresenter, type Presenter } from './presenter.ts';
import { advanceTo } from './seek.ts';
import { Simulation } from './simulation.ts';
import { noteOf, takeOf, type Take } from './take.ts';

const LARGEST_PIXEL_RATIO = 4;
const HISTORY_BYTES = 64 * 1024 * 1024;
/** Spent with each picture on puffs that are being baked. */
const BAKING_MS = 5;

/** A running scene on a canvas. Reads no page: sizes, pointers and keys come in as numbers, so that it runs in a worker. */
export class Stage {
  /** Settled when the first picture stands. */
  readonly ready: Promise<void>;
  readonly canvas: DeviceCanvas;
  /** Moves the eye; draws anew when paused. Angles in radians, lengths in CSS pixels. */
  readonly camera = {
    orbit: (azimuth: number, elevation: number) => this.#moveEye(() => this.#eye.orbit(azimuth, elevation)),
    zoom: (factor: number) => this.#moveEye(() => this.#eye.zoom(factor)),
    pan: (x: number, y: number) => this.#moveEye(() => this.#eye.pan(x, y, this.#height / this.#pixelRatio)),
    reset: () => this.#moveEye(() => this.#eye.reset()),
  };
  readonly #presenter: Presenter;
  readonly #scene: Scene;
  readonly #simulation: Simulation;
  readonly #factory: SimulatorFactory;
  readonly #eye: OrbitCamera;
  readonly #puffs: LivePuffs;
  readonly #clock = new Clock();
  readonly #governor = new Governor();
  readonly #listeners = new Listeners<StageEvents>();
  readonly #stopListening: () => void;
  #smoke: SmokeRenderer;
  #baked: BakedPuffs | undefined;
  #values: Values;
  #style: Style;
  #light: Light;
  #width = 0;
  #height = 0;
  #pixelRatio = 1;
  #quality: Quality = 1;
  #view: DebugView | undefined;
  /** That of the latest frame. */
  #scale = 1;
  #playing = false;
  #disposed = false;
  #seeking = false;
  #movedWhilePaused = false;
  /** The most particles that the smoke can draw. */
  #capacity = 0;
  #request = 0;
  #renderMs = 0;
  #report: FrameReport = { bodiesDrawn: 0, castersDrawn: 0, arrangeMs: 0 };

  /** @internal Use createStage. */
  constructor(canvas: DeviceCanvas, presenter: Presenter, factory: SimulatorFactory, options: StageOptions) {
    this.canvas = canvas;
    this.#presenter = presenter;
    this.#values = { ...defaults(), ...options.values };
    this.#style = styleOf(this.#values);
    this.#scene = sceneNamed(this.#values.scene as string);
    this.#light = lightOf(this.#values, new Vector3(...this.#scene.camera.target));
    this.#eye = new OrbitCamera(this.#scene.camera);
    this.#puffs = new LivePuffs(this.#values);
    this.#baked = this.#puffs.finish();
    this.#smoke = this.#prepareSmoke();
    this.#factory = factory;
    this.#simulation = new Simulation(factory, this.#scene, this.#values, options.historyBytes ?? HISTORY_BYTES);
    this.quality = options.quality ?? 1;
    this.view = options.view;
    this.#stopListening = presenter.device.onContext((event) => (event === 'restored' ? this.#draw() : undefined));
    this.resize(options.width ?? canvas.width, options.height ?? canvas.height, options.pixelRatio ?? 1);
    this.ready = Promise.resolve();
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** Simulated seconds for each real second, 0 to 2. */
  get speed(): number {
    return this.#clock.speed;
  }

  set speed(speed: number) {
    this.#clock.speed = MathUtils.clamp(speed, 0, 2);
  }

  /** Share of the pixel ratio that is drawn, or 'auto': less than 1 while playing where frames come late. */
  get quality(): Quality {
    return this.#quality;
  }

  /** @throws ParameterError for what is neither 'auto' nor 0.25 to 1 */
  set quality(quality: Quality) {
    if (quality !== 'auto' && !(quality >= LOWEST_QUALITY && quality <= 1)) {
      throw new ParameterError('quality', quality, `auto or ${LOWEST_QUALITY} to 1`);
    }
    this.#quality = quality;
    if (!this.#playing) this.#draw();
  }

  /** What is shown instead of the picture; undefined shows the picture. */
  get view(): DebugView | undefined {
    return this.#view;
  }

  /** @throws ParameterError for a view that there is not */
  set view(view: DebugView | undefined) {
    if (view !== undefined && !DEBUG_VIEWS.includes(view)) {
      throw new ParameterError('view', view, DEBUG_VIEWS.join(', '));
    }
    this.#view = view;
    if (!this.#playing) this.#draw();
    this.#listeners.tell('statechange', { playing: this.#playing });
  }

  get stats(): StageStats {
    const { alive, waiting, steps, inputCount, isTruncated } = this.#simulation.simulator;
    return {
      time: steps * STEP_SECONDS,
      steps,
      alive,
      waiting,
      inputs: inputCount,
      isTruncated,
      historyBytes: this.#simulation.historyBytes,
      bodiesDrawn: this.#report.bodiesDrawn,
      castersDrawn: this.#report.castersDrawn,
      bodiesTotal: alive,
      castersTotal: this.#style.shadows ? alive : 0,
      simMs: this.#simulation.stepMs,
      arrangeMs: this.#report.arrangeMs,
      renderMs: this.#renderMs,
      drawCalls: this.#presenter.device.renderer.info.render.calls,
      writesDepth: this.#presenter.device.writesDepth,
      scale: this.#scale,
    };
  }

  /** Calls back on an event; returns the function that ends it. */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    return this.#listeners.add(event, listener);
  }

  play(): void {
    if (this.#playing || this.#disposed) return;
    this.#playing = true;
    this.#clock.rest();
    this.#governor.rest();
    this.#request = requestAnimationFrame(this.#tick);
    this.#listeners.tell('statechange', { playing: true });
  }

  pause(): void {
    if (!this.#playing) return;
    this.#stop();
    // What stands still shows all its pixels.
    if (this.#scale !== this.#scaleNow) this.#draw();
  }

  /** Takes n whole steps and shows the last one. */
  step(n = 1): void {
    this.#requireAlive();
    this.#advance(n);
    this.#showLatest();
  }

  /**
   * Goes to a simulated time, with everything that was done on the way, as far back as the take began. Playing goes on
   * from there if it was playing. What is done there takes over: what was done later is forgotten.
   */
  async seek(seconds: number, options: SeekOptions = {}): Promise<void> {
    this.#requireAlive();
    const goal = Math.max(0, Math.round(seconds / STEP_SECONDS));
    this.#seeking = true;
    try {
      this.#simulation.approach(goal);
      await advanceTo(goal, this.#simulation, options, () => this.#disposed);
    } finally {
      this.#seeking = false;
      if (!this.#disposed) {
        this.#followLog();
        this.#keepVariations();
        this.#showLatest();
      }
    }
  }

  /** Starts over from the first step with the values as they are, and begins a new take. */
  restart(): void {
    this.#requireAlive();
    this.#simulation.restart(this.#values);
    this.#showLatest();
  }

  /**
   * Changes parameters by flat key; all of them, or none when one is refused. A new seed starts over; a new
   * simulation.maxParticles keeps what lives. What the simulator reads becomes part of the take; style and light do not.
   * @throws ParameterError naming the parameter, the value and what would have been accepted
   */
  set(values: Values): void {
    this.#requireAlive();
    validate(values);
    const before = this.#values;
    const after = { ...before, ...values };
    this.#simulation.set(differing(values, before));
    const capacity = after['simulation.maxParticles'] as number;
    if (capacity !== before['simulation.maxParticles']) {
      this.#simulation.input((simulator) => simulator.inputCapacity(capacity));
    }
    if (after.seed !== before.seed) this.#simulation.restart(after);
    this.#showValues(after);
    if (!this.#playing) this.#draw();
  }

  /**
   * Lets optional parameters, those of lists, go back to what the scene has.
   * @throws ParameterError for a key that is not optional
   */
  unset(keys: readonly string[]): void {
    this.#requireAlive();
    keys.forEach(requireOptional);
    this.#simulation.unset(keys);
    this.#showValues(Object.fromEntries(Object.entries(this.#values).filter(([key]) => !keys.includes(key))));
    if (!this.#playing) this.#draw();
  }

  /**
   * Shows puffs of shapes of one's own, such as `fitPuff` makes them of a mesh, a variation each; without any, those that
   * the parameters describe. Looks only: takes, links and saved states hold nothing of it.
   * @throws ShapeError when a shape is none that a puff can have; nothing has changed then
   */
  setPuffs(shapes?: readonly PuffShape[]): void {
    this.#requireAlive();
    if (shapes) demandShapes(shapes);
    this.#puffs.use(shapes, this.#values);
    if (!this.#playing) this.#draw();
  }

  /** All values by flat key; optional ones only where somebody has set them. */
  get(): Values {
    return { ...this.#values };
  }

  /** Names of the scene's rigids by their number, for people who attach something to one. */
  get rigidNames(): readonly string[] {
    return this.#scene.rigidNames;
  }

  /** What the scene itself sets of the optional parameters; it holds wherever `get()` has no value. */
  get rig(): Values {
    return this.#simulation.rig;
  }

  /**
   * The present picture as a PNG, transparent where the scene is.
   * @throws ContextError while the graphics context is lost
   */
  async picture(): Promise<Blob> {
    this.#requireAlive();
    this.#presenter.device.requireUsable();
    this.#showPuffs(this.#puffs.finish());
    this.#draw(1);
    return this.#presenter.encode();
  }

  /** The simulator's state as bytes. */
  save(): Uint8Array {
    return this.#simulation.simulator.save();
  }

  /** Takes up a saved state, with which a new take begins; refuses bytes that are none and then changes nothing. */
  restore(bytes: Uint8Array): void {
    this.#requireAlive();
    this.#showValues(this.#simulation.restore(bytes, this.#values));
    this.#keepVariations();
    this.#showLatest();
  }

  /**
   * What was done since the stage was created, restarted or restored, by step: parameters of the simulator, the rigid
   * that was moved, steering and blowing. It has room for 20,000 inputs; more still act, and `isTruncated` tells.
   */
  take(): Take {
    this.#requireAlive();
    const bytes = this.#simulation.simulator.take(noteOf(this.#simulation.startValues));
    return takeOf(bytes, this.#factory.readTake(bytes));
  }

  /**
   * Goes to the start of a take, with all values as they were there; playing, stepping and seeking then do what was done
   * in it, to the same hash at every step. What is done meanwhile takes over: the rest of the take is forgotten.
   * @param take as `take()` gave it, or its bytes
   * @throws SimulatorError when the bytes are damaged or the take was made in another scene; nothing has changed then
   */
  playTake(take: Take | Uint8Array): void {
    this.#requireAlive();
    const bytes = take instanceof Uint8Array ? take : take.toBytes();
    const { values } = takeOf(bytes, this.#factory.readTake(bytes));
    if (values.scene !== this.#scene.name) {
      throw new SimulatorError(`The take was made in the scene ${values.scene}; this stage shows ${this.#scene.name}.`);
    }
    this.#simulation.replay(bytes, values);
    this.#showValues(this.#simulation.valuesIn(values));
    this.#showLatest();
  }

  /**
   * Blows into the smoke at a place of the picture.
   * @throws ParameterError naming what is out of range
   */
  blow(input: BlowInput): void {
    this.#requireAlive();
    if (!this.#isVisible) return;
    const [width, height] = [this.#width / this.#pixelRatio, this.#height / this.#pixelRatio];
    const blow = blowOf(input, this.#eye.camera, this.#eye.distance, width, height);
    this.#simulation.input((simulator) => simulator.inputBlow(blow));
  }

  /**
   * Steers what a scene has put on a channel.
   * @param channel 0 to 7
   * @param value -1 to 1
   * @throws ParameterError naming what is out of range
   */
  steer(channel: number, value: number): void {
    this.#requireAlive();
    this.#simulation.input((simulator) => simulator.inputSteer(channel, value));
  }

  /** The simulator's state in 16 hexadecimal digits; equal states have equal hashes everywhere. */
  hash(): string {
    return this.#simulation.simulator.hash();
  }

  /** @param width, height in CSS pixels; nothing is drawn while one of them is 0 */
  resize(width: number, height: number, pixelRatio = this.#pixelRatio): void {
    this.#pixelRatio = MathUtils.clamp(pixelRatio, 0.1, LARGEST_PIXEL_RATIO);
    this.#width = Math.round(width * this.#pixelRatio);
    this.#height = Math.round(height * this.#pixelRatio);
    this.#governor.rest();
    if (this.#isVisible) this.#eye.setAspect(this.#width / this.#height);
    this.#draw();
  }

  /** Takes a pointer. Returns 'rigid' while the pointer moves a rigid, so that the page does not turn the camera too. */
  pointer({ type, id, x, y }: PointerInput): 'rigid' | null {
    const { drag } = this.#simulation;
    if (!drag || !this.#isVisible) return null;
    const ratio = this.#pixelRatio;
    const at = new Vector2(((x * ratio) / this.#width) * 2 - 1, 1 - ((y * ratio) / this.#height) * 2);
    const { camera } = this.#eye;
    if (type === 'down') return drag.grab(id, at, camera, this.#simulation.handleTransform()) ? 'rigid' : null;
    if (type !== 'move') {
      if (!drag.release(id)) return null;
      this.#simulation.releaseHandle();
      return 'rigid';
    }
    if (!drag.follow(id, at, camera)) return null;
    this.#simulation.dragHandle();
    this.#showMoved();
    return 'rigid';
  }

  /** Moves the place to which a spring draws the scene's movable rigid, by metres. */
  nudge({ dx = 0, dy = 0, dz = 0 }: { dx?: number; dy?: number; dz?: number }): void {
    const { drag } = this.#simulation;
    if (!drag) return;
    drag.nudge(new Vector3(dx, dy, dz));
    this.#simulation.dragHandle();
    if (!drag.isHeld) this.#simulation.releaseHandle();
    this.#showMoved();
  }

  /** Stops everything and gives the context and the memory back. May be called again. */
  dispose(): void {
    if (this.#disposed) return;
    this.#stop();
    this.#disposed = true;
    this.#stopListening();
    this.#smoke.dispose();
    this.#simulation.dispose();
    this.#presenter.dispose();
    this.#listeners.clear();
  }

  #stop(): void {
    if (!this.#playing) return;
    this.#playing = false;
    cancelAnimationFrame(this.#request);
    this.#clock.rest();
    this.#listeners.tell('statechange', { playing: false });
  }

  get #isVisible(): boolean {
    return this.#width > 0 && this.#height > 0;
  }

  readonly #tick = (now: number): void => {
    if (!this.#playing) return;
    this.#request = requestAnimationFrame(this.#tick);
    if (this.#seeking) return this.#governor.rest();
    this.#governor.tick(now);
    try {
      this.#advance(this.#clock.tick(now));
      this.#draw();
    } catch (error) {
      this.#stop();
      this.#listeners.tell('error', error as Error);
    }
  };

  #advance(steps: number): void {
    if (steps > 0) this.#movedWhilePaused = false;
    this.#simulation.advance(steps);
    this.#followLog();
  }

  /** Where the log of a take has done something since, its values are shown as the stage's. */
  #followLog(): void {
    if (this.#simulation.hasFollowed()) this.#showValues(this.#simulation.valuesIn(this.#values));
  }

  /** Goes on with these values, which the simulator has already. */
  #showValues(values: Values): void {
    this.#values = values;
    this.#style = styleOf(values);
    this.#puffs.follow(values);
    this.#light = lightOf(values, new Vector3(...this.#scene.camera.target));
    if (this.#capacity !== values['simulation.maxParticles']) {
      this.#smoke.dispose();
      this.#smoke = this.#prepareSmoke();
    }
    this.#listeners.tell('statechange', { playing: this.#playing });
  }

  #showLatest(): void {
    this.#movedWhilePaused = false;
    this.#clock.settle();
    this.#draw();
  }

  /** In a pause the rigid is shown where it was put, though the spring will bring it there only in the next steps. */
  #showMoved(): void {
    if (this.#playing) return;
    this.#movedWhilePaused = true;
    this.#draw();
  }

  /** Share of the pixel ratio to draw with. Where pictures must come again the same, the machine has no say in it. */
  get #scaleNow(): number {
    if (this.#quality !== 'auto') return this.#quality;
    return this.#playing && !this.#seeking ? this.#governor.scale : 1;
  }

  /** Where a state comes from elsewhere, its particles may have variations that no value has told of. */
  #keepVariations(): void {
    this.#puffs.follow(this.#values, this.#simulation.variationsAlive());
  }

  #draw(scale = this.#scaleNow): void {
    if (this.#disposed || !this.#isVisible || !this.#presenter.device.isUsable) return;
    this.#showPuffs(this.#playing ? this.#puffs.workFor(BAKING_MS) : this.#puffs.finish());
    const started = performance.now();
    const rigids = this.#simulation.rigids(this.#clock.blend);
    if (this.#movedWhilePaused) rigids[this.#scene.handle!.rigid].setPosition(this.#simulation.drag!.target);
    const canvas = { width: this.#width, height: this.#height };
    const drawn = { width: Math.ceil(canvas.width * scale), height: Math.ceil(canvas.height * scale) };
    const output = this.#presenter.prepare(canvas, drawn);
    this.#report = this.#smoke.draw({
      simulator: this.#simulation.simulator,
      camera: this.#eye.camera,
      light: this.#light,
      style: this.#style,
      blend: this.#clock.blend,
      time: this.#simulation.simulator.steps * STEP_SECONDS,
      ...drawn,
      pixelRatio: this.#pixelRatio * scale,
      rigids,
      cull: true,
      view: this.#view,
      output,
    });
    this.#presenter.present();
    this.#scale = scale;
    this.#renderMs = performance.now() - started;
    if (this.#listeners.has('frame')) this.#listeners.tell('frame', this.stats);
  }

  #showPuffs(puffs: BakedPuffs | undefined): void {
    if (!puffs) return;
    this.#baked = puffs;
    this.#smoke.setPuffs(puffs);
  }

  #prepareSmoke(): SmokeRenderer {
    this.#capacity = this.#values['simulation.maxParticles'] as number;
    return new SmokeRenderer(this.#presenter.device, { ...this.#scene, capacity: this.#capacity, puffs: this.#baked });
  }

  #moveEye(move: () => void): void {
    move();
    if (!this.#playing) this.#draw();
  }

  #requireAlive(): void {
    if (this.#disposed) throw new SimulatorError('This stage was disposed; create a new one.');
  }
}

/** Of `values`, those that `before` has otherwise. */
function differing(values: Values, before: Values): Values {
  return Object.fromEntries(Object.entries(values).filter(([key, value]) => before[key] !== value));
}

/**
 * Sets a scene up on a canvas and draws its first picture; it does not play yet.
 * @throws ParameterError for a value it does not take, LoadError when the simulator cannot be fetched,
 * UnsupportedError when the browser lacks WebGL2 or WASM SIMD
 */
export async function createStage(canvas: DeviceCanvas, options: StageOptions = {}): Promise<Stage> {
  validate(options.values ?? {});
  const scene = sceneNamed((options.values?.scene ?? defaults().scene) as string);
  const presenter = createPresenter(canvas, options.device, options);
  try {
    const factory = await loadSimulators({ physics: scene.rigids.length > 0, onProgress: options.onProgress });
    return new Stage(canvas, presenter, factory, options);
  } catch (error) {
    presenter.dispose();
    throw error;
  }
}
