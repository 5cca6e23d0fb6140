import { MathUtils } from 'three';
import { missingContext, requireCanvas, type DeviceCanvas } from '../device/device.ts';
import type { Fault } from '../device/faults.ts';
import type { DebugView, Quality } from '../preset/quality.ts';
import { ParameterError, requireOptions, SimulatorError } from '../preset/errors.ts';
import { runOnSelf } from '../preset/onSelf.ts';
import type { Values } from '../preset/parameter.ts';
import { defaults, requireFinite, requireOptional, requireWhole, validate } from '../preset/values.ts';
import { demandShapes } from '../puffs/lobes.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import { STEP_SECONDS } from '../sim/clock.ts';
import { compileAhead } from '../smoke/prepare.ts';
import { fetchExtras, type PictureKind } from '../smoke/extraPasses.ts';
import { styleOf } from '../smoke/style.ts';
import { bakeAhead } from '../smoke/prepare.ts';
import type { BlowInput } from './blow.ts';
import {
  STAGE_OPTIONS,
  type EnterOptions,
  type PointerInput,
  type SeekOptions,
  type StageEvents,
  type StageOptions,
  type StageStats,
} from './contract.ts';
import { openScene, type OpenedScene } from './openScene.ts';
import { firstDeviation, pixelsOf, type DrawnDepth, type Picture } from './picture.ts';
import { createPresenter, type Presenter } from './presenter.ts';
import { RunningScene } from './runningScene.ts';
import type { Retouch } from './shownSmoke.ts';
import type { Simulation } from './simulation.ts';
import type { Sight } from './sight.ts';
import { noteOf, takeOf, type Take } from './take.ts';

/**
 * A running scene on a canvas. It does not access the DOM: sizes, pointers and keys are passed as numbers, so it also
 * runs in a worker. `docs/three.md` describes the members in the same groups:
 *
 * - life cycle: `ready`, `canvas`, `on`, `complete`, `copy`, `dispose`
 * - time: `play`, `pause`, `playing`, `speed`, `step`, `advance`, `seek`, `clear`, `restart`
 * - values: `set`, `get`, `unset`, `enter`, `rig`, `rigidNames`, `partNames`, `setPuffs`
 * - state: `save`, `restore`, `hash`, `take`, `playTake`, `readTake`
 * - picture: `picture`, `resize`, `visible`, `background`, `quality`, `view`, `camera`, `sight`
 * - input: `pointer`, `nudge`, `blow`, `steer`, `drop`, `dropCount`
 * - statistics: `stats`, `timeGpu`
 */
export class Stage {
  /** Resolves when the first picture is drawn. */
  readonly ready: Promise<void>;
  readonly canvas: DeviceCanvas;
  /**
   * Moves the camera and sets the matching `camera.*` values. Redraws while paused.
   * Angles are in radians, lengths in CSS pixels. `reset` returns all camera parameters to the scene.
   */
  readonly camera = {
    orbit: (azimuth: number, elevation: number) => this.#running.look((eye) => eye.orbit(azimuth, elevation)),
    zoom: (factor: number) => this.#running.look((eye) => eye.zoom(factor)),
    pan: (x: number, y: number) => this.#running.look((eye) => eye.pan(x, y, this.#picture.size[1])),
    reset: () => this.#running.unset(Object.keys(this.#picture.eye.held)),
    /** Angle about the vertical axis; 0 looks from +z. */
    azimuth: () => this.#picture.eye.azimuth,
  };
  readonly #running: RunningScene;
  /** Identifies the latest call of enter; earlier calls are superseded. */
  #entering: object | undefined;

  /** @internal Use createStage. */
  constructor(canvas: DeviceCanvas, presenter: Presenter, opened: OpenedScene, values: Values, options: StageOptions) {
    this.canvas = canvas;
    this.#running = new RunningScene(presenter, opened, values, options);
    this.#picture.hasBackground = options.background ?? true;
    this.#picture.quality = options.quality ?? 1;
    this.#picture.view = options.view;
    this.visible = options.visible ?? true;
    this.resize(options.width ?? canvas.width, options.height ?? canvas.height, options.pixelRatio ?? 1);
    this.ready = Promise.resolve();
    runOnSelf(this);
  }

  get playing(): boolean {
    return this.#running.loop.isPlaying;
  }

  /**
   * Whether the canvas is visible to the user. Default: true. While it is false, nothing is drawn and playback is
   * suspended; `playing` keeps its value.
   */
  get visible(): boolean {
    return this.#running.loop.isSeen;
  }

  set visible(isVisible: boolean) {
    this.#running.isSeen = isVisible;
  }

  /** Simulated seconds per real second, 0 to 2. */
  get speed(): number {
    return this.#running.loop.clock.speed;
  }

  /** @throws ParameterError when the value is not a finite number */
  set speed(speed: number) {
    requireFinite({ speed });
    this.#running.loop.clock.speed = MathUtils.clamp(speed, 0, 2);
  }

  /** Fraction of the pixel ratio to draw with. 'auto' reduces it while playing when frames arrive late. */
  get quality(): Quality {
    return this.#picture.quality;
  }

  /** @throws ParameterError unless the value is 'auto' or 0.25 to 1 */
  set quality(quality: Quality) {
    this.#running.show(() => (this.#picture.quality = quality));
  }

  /** The debug view shown instead of the picture; undefined shows the picture. */
  get view(): DebugView | undefined {
    return this.#picture.view;
  }

  /** @throws ParameterError for an unknown view */
  set view(view: DebugView | undefined) {
    this.#running.show(() => (this.#picture.view = view));
    this.#running.completion.begin();
    this.#running.notifyState();
  }

  /** Whether to draw the background. Without it, the canvas is transparent where the background would be. */
  get background(): boolean {
    return this.#picture.hasBackground;
  }

  set background(isShown: boolean) {
    this.#running.show(() => (this.#picture.hasBackground = isShown));
  }

  get stats(): StageStats {
    return this.#running.stats;
  }

  /** Starts or stops measuring the time that the GPU takes for a frame, `stats.gpuMs`. It is not measured by default. */
  timeGpu(isOn: boolean): void {
    this.#picture.timeGpu(isOn);
  }

  /**
   * Adds an event listener.
   * @returns a function that removes the listener
   */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    return this.#running.listen(event, listener);
  }

  play(): void {
    this.#running.play();
  }

  pause(): void {
    if (!this.#running.stop()) return;
    // A paused picture uses the full resolution.
    if (this.#picture.scale !== this.#running.nextScale) this.#running.draw();
  }

  /**
   * Resolves when the renderer and the view that the values select are drawn. They load on first use; until then, smoke
   * is drawn with nailboards. `picture` and `seek` wait for this themselves.
   * @throws LoadError when the code cannot be fetched. Without a call to `complete`, the stage emits an error event
   * instead and keeps running
   */
  complete(): Promise<void> {
    this.#running.requireAlive();
    return this.#running.completion.wait();
  }

  /**
   * Takes n steps of 1/60 s and shows the last one.
   * @param n an integer of at least 0
   * @throws ParameterError for any other n
   */
  step(n = 1): void {
    this.#running.requireAlive();
    requireWhole('n', n);
    this.#running.advance(n);
    this.#running.showLatest();
  }

  /**
   * Advances by simulated seconds and shows exactly that time, interpolated when it is between two steps. This renders
   * at any frame rate. The next call continues from the interpolated time.
   * @param seconds at least 0
   * @throws ParameterError when seconds is negative or not finite
   */
  advance(seconds: number): void {
    this.#running.requireAlive();
    requireFinite({ seconds }, 0);
    this.#running.advanceBy(seconds);
  }

  /**
   * Seeks to a simulated time and replays the recorded inputs. It can go back to the start of the take. Playback
   * continues from there if it was running. A new input at that time discards all later inputs.
   * @param seconds at least 0; rounded to the nearest step
   * @throws ParameterError when seconds is negative or not finite
   */
  async seek(seconds: number, options: SeekOptions = {}): Promise<void> {
    this.#running.requireAlive();
    requireFinite({ seconds }, 0);
    options.signal?.throwIfAborted();
    // The error was already reported; the seek works without the missing code.
    await this.#running.completion.wait().catch(() => undefined);
    await this.#running.seek(Math.round(seconds / STEP_SECONDS), options);
  }

  /** Removes all puffs. Emitters, objects and values stay. Takes record it. */
  clear(): void {
    this.#running.requireAlive();
    this.#running.show(() => this.#simulation.input((simulator) => simulator.inputClear()));
  }

  /** Restarts from the first step with the current values and starts a new take. */
  restart(): void {
    this.#running.requireAlive();
    this.#simulation.restart(this.#running.values);
    this.#running.showLatest();
  }

  /**
   * Loads the scene that the values name, or restarts the current one, from the first step. Omitted values get their
   * defaults. Among concurrent calls, the last one wins. The old scene keeps running until the new one is loaded.
   * @throws ParameterError for an invalid value, LoadError when the scene cannot be fetched; the stage is unchanged
   * then
   */
  async enter(values: Values, { onProgress }: EnterOptions = {}): Promise<void> {
    this.#running.requireAlive();
    const after = withDefaults(values);
    const entry = (this.#entering = {});
    const [opened] = await Promise.all([
      openScene(after.scene as string, {
        onProgress,
        deviationIn: (scene) => this.#picture.deviationIn(scene, after),
      }),
      bakeAhead(after),
      fetchExtras(kindOf(after, this.view)).then(() => bakeAhead(after)),
    ]);
    if (this.#running.isDisposed || this.#entering !== entry) return;
    this.#running.enter(opened, after);
  }

  /**
   * Changes parameters by flat key: all of them, or none if one is invalid. A new seed restarts the simulation. A new
   * simulation.maxParticles keeps the living particles. Values that the simulator reads are recorded in the take;
   * style, light and camera are not.
   * Use `enter` to change the scene.
   * @throws ParameterError with the parameter, the value and the accepted range
   */
  set(values: Values): void {
    this.#requireChangeable(values);
    this.#running.change(values);
  }

  /** @internal Changes to these values as one change: like `set`, and `unset` of all optional parameters not in them. */
  replace(values: Values): void {
    this.#requireChangeable(values);
    const taken = Object.keys(this.#running.values).filter((key) => !(key in values));
    taken.forEach(requireOptional);
    this.#running.replace(values);
  }

  /**
   * Resets optional parameters (lists and camera) to what the scene sets.
   * @throws ParameterError for a key that is not optional
   */
  unset(keys: readonly string[]): void {
    this.#running.requireAlive();
    keys.forEach(requireOptional);
    this.#running.unset(keys);
  }

  /**
   * Draws puffs with custom shapes, such as those that `fitPuff` creates from a mesh, one per variation. Without an
   * argument, the parameters define the shapes again. This affects rendering only: takes, links and saved states do not
   * contain the shapes.
   * @throws ShapeError when a shape is invalid; the stage is unchanged then
   */
  setPuffs(shapes?: readonly PuffShape[]): void {
    this.#running.requireAlive();
    if (shapes) demandShapes(shapes);
    this.#running.show(() => this.#picture.smoke.usePuffs(shapes, this.#running.values));
  }

  /** All values by flat key. Optional parameters appear only when they are set. */
  get(): Values {
    return { ...this.#running.values };
  }

  /** Converts between scene and picture coordinates, for overlays. */
  get sight(): Sight {
    return this.#running.sight;
  }

  /** Names of the scene's rigids by index, for attaching emitters and forces. */
  get rigidNames(): readonly string[] {
    return this.#running.scene.rigidNames;
  }

  /** Names of the scene's moving parts by index. Emitters and forces attach to part n as rigid 4096 + n. */
  get partNames(): readonly string[] {
    return (this.#running.scene.parts ?? []).map(({ name }) => name);
  }

  /** Optional parameters that the scene sets. They apply where `get()` has no value. */
  get rig(): Values {
    return { ...this.#simulation.rig, ...this.#picture.eye.wanted };
  }

  /**
   * The current picture as a PNG, transparent where the scene is.
   * @throws ContextError while the graphics context is lost
   */
  async picture(): Promise<Blob> {
    this.#running.requireAlive();
    await this.#running.completion.wait();
    this.#picture.requireContext();
    this.#picture.smoke.bake();
    this.#running.drawNow(1);
    return this.#picture.encode();
  }

  /**
   * Creates another stage with the same smoke at the same step and the same camera, for example to render a picture of
   * another size. This stage is unchanged. The copy starts a new take.
   * @param options as for createStage; the values are those of this stage
   * @throws the errors of createStage
   */
  async copy(canvas: DeviceCanvas, options: Omit<StageOptions, 'values'> = {}): Promise<Stage> {
    this.#running.requireAlive();
    const [values, state] = [this.get(), this.save()];
    const shapes = this.#picture.smoke.ownShapes;
    const stage = await createStage(canvas, { ...options, values });
    stage.setPuffs(shapes);
    stage.restore(state);
    return stage;
  }

  /**
   * @internal Changes the input of each frame, from the next frame until another scene is entered. Used to draw more
   * than one moment in a picture.
   */
  retouch(change: Retouch): void {
    this.#picture.smoke.retouch(change);
  }

  /**
   * @internal Advances to a simulated time and shows exactly it, interpolated when it is between two steps. The picture
   * does not depend on the times shown before. Only `seek` goes back.
   * @param seconds at least the time of the latest step but one
   * @param look valid values of camera and style
   */
  showAt(seconds: number, look: Values = {}): void {
    this.#running.requireAlive();
    requireFinite({ seconds }, 0);
    this.#running.showAt(seconds, look);
  }

  /** @internal The depth buffer of the latest picture, until the next one is drawn. */
  get drawnDepth(): DrawnDepth {
    return this.#picture.drawnDepth;
  }

  /**
   * @internal Goes to a state that was saved in the current take, at any of its steps. Unlike `restore`, the following
   * steps replay the inputs after that step.
   * @throws SimulatorError for invalid bytes; the stage is unchanged then
   */
  rewind(state: Uint8Array): void {
    this.#running.requireAlive();
    this.#running.rewind(state);
  }

  /** Serializes the simulator's state. */
  save(): Uint8Array {
    return this.#simulation.simulator.save();
  }

  /**
   * Restores a state that was saved in the same scene and starts a new take.
   * @throws SimulatorError for invalid bytes; the stage is unchanged then
   */
  restore(bytes: Uint8Array): void {
    this.#running.requireAlive();
    this.#running.follow(this.#simulation.restore(bytes, this.#running.values));
    this.#running.keepVariations();
    this.#running.showLatest();
  }

  /**
   * The inputs since the stage was created, restarted or restored, by step: simulator parameters, drags, steering,
   * blows and clears. A take records up to 20,000 inputs. Later inputs still take effect but are not recorded; `isTruncated` is
   * true then.
   */
  take(): Take {
    this.#running.requireAlive();
    return this.readTake(this.#simulation.simulator.take(noteOf(this.#simulation.startValues)));
  }

  /**
   * Reads the metadata of a take without playing it.
   * @throws SimulatorError when the bytes are damaged or not a take
   */
  readTake(bytes: Uint8Array): Take {
    return takeOf(bytes, this.#running.factory.readTake(bytes));
  }

  /**
   * Goes to the start of a take and sets the values it started with. Playing, stepping and seeking then replay its
   * inputs, with the same hash at every step. A new input discards the rest of the take.
   * @param take the result of `take()`, or its bytes
   * @throws SimulatorError when the bytes are damaged or the take was made in another scene; the stage is unchanged
   * then
   */
  playTake(take: Take | Uint8Array): void {
    this.#running.requireAlive();
    const bytes = ArrayBuffer.isView(take) ? take : take.toBytes();
    const { values } = this.readTake(bytes);
    const { name } = this.#running.scene;
    if (values.scene !== name) {
      throw new SimulatorError(`The take is for the scene ${values.scene}, not ${name}.`);
    }
    this.#simulation.replay(bytes, values);
    this.#running.follow(this.#simulation.valuesIn(values));
    this.#running.showLatest();
  }

  /**
   * Blows into the smoke at a position in the picture.
   * @throws ParameterError naming the value that is out of range
   */
  blow(input: BlowInput): void {
    this.#running.requireAlive();
    this.#running.gestures.blow(input);
  }

  /** How many objects can be dropped into this scene; 0 in scenes without physics. */
  get dropCount(): number {
    return this.#simulation.dropCount;
  }

  /**
   * Drops a ball or a crate at a position in the picture, in CSS pixels from the top left. It starts to fall with the
   * next step. When all objects are in use, the one farthest from that position is reused.
   * @returns false if the scene has no objects to drop
   */
  drop(x: number, y: number): boolean {
    this.#running.requireAlive();
    let hasDropped = false;
    this.#running.show(() => (hasDropped = this.#running.gestures.drop(x, y)));
    return hasDropped;
  }

  /**
   * Sets a steering channel of the scene.
   * @param channel 0 to 7
   * @param value -1 to 1
   * @throws ParameterError naming the value that is out of range
   */
  steer(channel: number, value: number): void {
    this.#running.requireAlive();
    this.#simulation.input((simulator) => simulator.inputSteer(channel, value));
  }

  /** Hash of the simulator's state as 16 hexadecimal digits. Equal states have equal hashes on all platforms. */
  hash(): string {
    return this.#simulation.simulator.hash();
  }

  /**
   * @param width, height in CSS pixels; nothing is drawn while one of them is 0
   * @param pixelRatio clamped to 0.1 to 4; unchanged when omitted
   */
  resize(width: number, height: number, pixelRatio?: number): void {
    requireFinite({ width, height, pixelRatio: pixelRatio ?? 1 });
    if (!this.#picture.resize(width, height, pixelRatio)) return;
    this.#running.loop.restGovernor();
    this.#running.draw();
  }

  /**
   * Handles a pointer event. Returns 'rigid' while the pointer drags a rigid, so that the page does not orbit the
   * camera as well.
   */
  pointer(input: PointerInput): 'rigid' | null {
    requireFinite({ x: input.x, y: input.y });
    return this.#running.gestures.pointer(input, () => this.#running.showMoved());
  }

  /** Moves the target of the scene's movable rigid, in metres. A spring pulls the rigid there. */
  nudge({ dx = 0, dy = 0, dz = 0 }: { dx?: number; dy?: number; dz?: number }): void {
    requireFinite({ dx, dy, dz });
    if (this.#running.gestures.nudge(dx, dy, dz)) this.#running.showMoved();
  }

  /** Stops playback and releases the context and the memory. Can be called more than once. */
  dispose(): void {
    this.#running.dispose();
  }

  #requireChangeable(values: Values): void {
    this.#running.requireAlive();
    validate(values);
    const { scene } = this.#running.values;
    if ((values.scene ?? scene) !== scene)
      throw new ParameterError('scene', values.scene, `${scene} (or call enter())`);
  }

  get #simulation(): Simulation {
    return this.#running.simulation;
  }

  get #picture(): Picture {
    return this.#running.picture;
  }
}

function kindOf(values: Values, view: DebugView | undefined): PictureKind {
  return { ...styleOf(values), view };
}

/**
 * Creates a stage on a canvas. Draws the first picture if the canvas is visible; does not start playback.
 * @throws ParameterError for an invalid value, LoadError when the simulator or the scene cannot be fetched,
 * UnsupportedError when the browser lacks WebGL2 or WASM SIMD, SimulatorError when memory runs out, ContextError when
 * the graphics context is lost and not restored in time, and for a canvas whose stage was disposed
 */
export async function createStage(canvas: DeviceCanvas, options: StageOptions = {}): Promise<Stage> {
  requireCanvas(canvas);
  requireOptions('createStage', options, [...STAGE_OPTIONS, 'device', 'failsSelfTest', 'onStep']);
  const values = withDefaults(options.values);
  // Before the programs compile: a resize of the drawing buffer waits for the GPU.
  const { width, height, pixelRatio } = options;
  if (width && height) [canvas.width, canvas.height] = pixelsOf(width, height, pixelRatio);
  const size = [width ?? canvas.width, height ?? canvas.height] as const;
  const presenter = createPresenter(canvas, options.device, { failsSelfTest: options.failsSelfTest });
  try {
    const [opened] = await Promise.all([
      openScene(values.scene as string, {
        onProgress: options.onProgress,
        deviationIn: (scene) => firstDeviation(scene, values, ...size, pixelRatio),
      }),
      compileAhead(presenter.device, values),
      bakeAhead(values),
      // What the loaded code bakes.
      fetchExtras(kindOf(values, options.view)).then(() => bakeAhead(values)),
    ]);
    if (import.meta.env.DEV && options.fault) await provoke(options.fault, presenter, opened);
    if (!presenter.device.hasHope) throw missingContext();
    return new Stage(canvas, presenter, opened, values, options);
  } catch (error) {
    presenter.dispose();
    throw error;
  }
}

/** @throws ParameterError for an invalid value */
function withDefaults(values: Values = {}): Values {
  validate(values);
  return { ...defaults(), ...values };
}

/** @see Fault */
async function provoke(fault: Fault, { device }: Presenter, { factory }: OpenedScene): Promise<void> {
  const { fill, loseContext } = await import('../device/faults.ts');
  if (fault === 'outOfMemory') fill(factory.module.memory);
  if (fault === 'contextLostInStart') loseContext(device);
}
