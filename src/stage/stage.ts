import { MathUtils } from 'three';
import type { DeviceCanvas } from '../renderer/gpu/device.ts';
import type { DebugView, Quality } from '../parameters/quality.ts';
import { LoadError, SimulatorError } from '../base/errors.ts';
import { runOnSelf } from '../base/onSelf.ts';
import type { Values } from '../parameters/parameter.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { requireFinite, requireWhole } from '../parameters/values.ts';
import { requireShapes } from '../renderer/puffs/lobes.ts';
import type { PuffShape } from '../renderer/puffs/shapes.ts';
import { STEP_SECONDS } from '../simulator/clock.ts';
import type { EmissionChange, EmissionOptions } from '../simulator/emitterOptions.ts';
import type {
  BlowInput,
  EnterOptions,
  Model,
  ModelOptions,
  ModelPoint,
  PointerInput,
  SeekOptions,
  StageEvents,
  StageOptions,
  StageStats,
} from './contract.ts';
import type { AddModel } from './model/kit.ts';
import { loadModel } from './modelLoading.ts';
import { cameraControls } from './orbit.ts';
import { openFor, openStage, read } from './openStage.ts';
import type { RunningScene } from './runningScene.ts';
import type { Sight } from './sight.ts';
import { statsOf } from './stats.ts';
import type { Take, TakeOptions } from './take.ts';

/**
 * A running scene on a canvas. It does not access the DOM: sizes, pointers and keys are passed as numbers, so it also
 * runs in a worker. The page docs/three.md groups the members.
 */
export class Stage {
  /** Resolves when the first picture is drawn. */
  readonly ready = Promise.resolve();
  readonly canvas: DeviceCanvas;
  readonly camera = cameraControls(() => this.#running);
  readonly #running: RunningScene;
  /** The latest call of enter or setModel, until it is over; earlier calls are superseded. */
  #entering: { readonly values: GivenValues; readonly addModel: AddModel | undefined } | undefined;
  /** Identifies the latest call of setModel. */
  #reading: object | undefined;

  /** @internal Use createStage. */
  constructor(canvas: DeviceCanvas, running: RunningScene) {
    this.canvas = canvas;
    this.#running = running;
    runOnSelf(this);
  }

  get playing(): boolean {
    return this.#running.loop.isPlaying;
  }

  /** Whether the user can see the canvas, by default true. While false, nothing is drawn and playback is suspended. */
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
    return this.#running.picture.quality;
  }

  /** @throws ParameterError unless the value is 'auto' or 0.25 to 1 */
  set quality(quality: Quality) {
    this.#running.show(() => (this.#running.picture.quality = quality));
  }

  /** The debug view shown instead of the picture; undefined shows the picture. */
  get view(): DebugView | undefined {
    return this.#running.picture.view;
  }

  /** @throws ParameterError for an unknown view */
  set view(view: DebugView | undefined) {
    this.#running.show(() => (this.#running.picture.view = view));
    this.#running.announce();
  }

  /** Whether to draw the background. Without it, the canvas is transparent where the background would be. */
  get background(): boolean {
    return this.#running.picture.hasBackground;
  }

  set background(isShown: boolean) {
    this.#running.show(() => (this.#running.picture.hasBackground = isShown));
  }

  get stats(): StageStats {
    return statsOf(this.#running.simulation, this.#running.picture);
  }

  /** Starts or stops measuring the time that the GPU takes for a frame, `stats.gpuMs`. It is not measured by default. */
  timeGpu(isOn: boolean): void {
    this.#running.picture.timeGpu(isOn);
  }

  /** Adds an event listener. @returns a function that removes the listener */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    return this.#running.listen(event, listener);
  }

  play(): void {
    this.#running.play();
  }

  pause(): void {
    if (!this.#running.stop()) return;
    // A paused picture uses the full resolution.
    if (this.#running.picture.scale !== this.#running.nextScale) this.#running.draw();
  }

  /**
   * Resolves when the renderer and the view that the values select are drawn. They load on first use; until then, smoke
   * is drawn with nailboards. `picture` and `seek` wait for this themselves.
   * @throws LoadError when the code cannot be fetched. Without a call to `complete`, the stage emits an error event
   * instead and keeps running
   */
  complete(): Promise<void> {
    return this.running.completion.wait();
  }

  /** Takes n steps of 1/60 s and shows the last one. @throws ParameterError unless n is an integer of at least 0 */
  step(n = 1): void {
    requireWhole('n', n);
    this.running.step(n);
  }

  /**
   * Advances by simulated seconds and shows exactly that time, interpolated when it is between two steps. This renders
   * at any frame rate. The next call continues from the interpolated time.
   * @throws ParameterError when seconds is negative or not finite
   */
  advance(seconds: number): void {
    requireFinite({ seconds }, 0);
    this.running.advanceBy(seconds);
  }

  /**
   * Seeks to a simulated time and replays the recorded inputs. It can go back to the start of the take. Playback
   * continues from there if it was running. A new input at that time discards all later inputs.
   * @param seconds at least 0; rounded to the nearest step
   * @throws ParameterError when seconds is negative or not finite
   */
  async seek(seconds: number, options: SeekOptions = {}): Promise<void> {
    requireFinite({ seconds }, 0);
    const { completion } = this.running;
    options.signal?.throwIfAborted();
    // The error was already reported; the seek works without the missing code.
    await completion.wait().catch(() => undefined);
    await this.#running.seek(Math.round(seconds / STEP_SECONDS), options);
  }

  /** Removes all puffs. Emitters, objects and values stay. Takes record it. */
  clear(): void {
    this.running.show(() => this.#running.simulation.input((simulator) => simulator.inputClear()));
  }

  /** Restarts from the first step with the current values and starts a new take. */
  restart(): void {
    const { simulation, values } = this.running;
    simulation.restart(values.all);
    this.#running.showLatest();
  }

  /**
   * Loads the scene that the values name, or restarts the current one, from the first step. Omitted values get their
   * defaults. Among concurrent calls, the last one wins. The old scene keeps running until the new one is loaded.
   * @throws ParameterError for an invalid value, LoadError when the scene cannot be fetched; nothing changes then
   */
  async enter(values: GivenValues, options: EnterOptions = {}): Promise<void> {
    const { addModel } = this.#entering ?? this.running;
    await this.#enter(values, options, addModel);
  }

  async #enter(values: GivenValues, options: EnterOptions, addModel: AddModel | undefined): Promise<void> {
    const { picture } = this.running;
    const [before, entry] = [this.#entering, (this.#entering = { values, addModel })];
    const after = await read(values).catch((error) => {
      // Invalid values supersede nothing.
      if (this.#entering === entry) this.#entering = before;
      throw error;
    });
    try {
      const scene = await openFor(after, picture, options);
      const opened = addModel ? await addModel(scene) : scene;
      if (this.#running.isDisposed || this.#entering !== entry) return;
      this.#running.addModel = addModel;
      this.#running.enter(opened, after);
    } finally {
      if (this.#entering === entry) this.#entering = undefined;
    }
  }

  /**
   * Adds a model to the scene and restarts the simulation from the first step, with the values as they are. The model
   * replaces the one before and stays until another call, also when another scene is entered. Smoke collides with it, it casts
   * shadow, its animation follows simulated time, and emitters can ride on its nodes; see `Model.nodes`. Takes, links and saved
   * states do not contain it: they need the same model. Of concurrent calls, the last one wins. Nothing in the file is fetched
   * from other addresses.
   * @param bytes a GLB file of at most 32 MB, with at most 200,000 triangles and 64 materials; null removes the model
   * @returns what the file contains; null without a model
   * @throws FileError with the fault of a file that cannot be used, ParameterError for an invalid option, LoadError when code
   * cannot be fetched; nothing changes then
   */
  async setModel(bytes: Uint8Array | null, options: ModelOptions = {}): Promise<Model | null> {
    const call = (this.#reading = {});
    const { smoke } = this.running.picture;
    const addModel = bytes ? await loadModel(bytes, options) : undefined;
    if (this.#reading === call) {
      await this.#enter(this.#entering?.values ?? this.get(), {}, addModel);
      this.setPuffs(smoke.ownShapes);
    }
    return this.model;
  }

  /** What the model file contains; null without a model. */
  get model(): Model | null {
    return this.#running.opened.model?.model ?? null;
  }

  /**
   * The place of the model's surface at a position in the picture, in CSS pixels from the top left, for an emitter that rides
   * on it.
   * @returns null where the model is not, or behind another surface of the scene. Smoke does not hide it
   */
  pickModel(x: number, y: number): ModelPoint | null {
    return this.running.opened.model?.pick(x, y, this.running) ?? null;
  }

  /**
   * Changes parameters by flat key: all of them, or none if one is invalid. A new seed restarts the simulation. A new
   * simulation.maxParticles keeps the living particles. Takes record the changes. Use `enter` to change the scene.
   *
   * A value that the timeline animates holds until the next keyframe of its parameter; see `recordsKeyframes`. A timeline
   * applies to all time: where it changes what the simulator has already done, the next seek simulates that anew. Its code
   * is loaded with the first one, and `complete` waits for it. Until then the values of that call are not set, the stage does
   * not play, `step` and `advance` wait, and an invalid value causes an `error` event in place of an error.
   * @throws ParameterError with the parameter, the value and the accepted range
   */
  set(values: GivenValues): void {
    const { listeners } = this.running;
    this.setChecked(values)?.catch((error: Error) => {
      // The loading error was already reported.
      if (!(error instanceof LoadError)) listeners.notify('error', error);
    });
  }

  /**
   * @internal Like `set`, without the event.
   * @returns if the code of the timeline is not loaded, a promise that rejects when the timeline is invalid
   */
  setChecked(values: GivenValues): Promise<void> | undefined {
    return this.running.timeline.set(values);
  }

  /** @internal Changes to these values as one change: like `set`, and `unset` of all optional parameters not in them. */
  replace(values: Values): void {
    this.running.values.replace(values);
  }

  /** Resets optional parameters (lists, camera) to what the scene sets. @throws ParameterError for any other key */
  unset(keys: readonly string[]): void {
    this.running.values.unset(keys);
  }

  /**
   * Draws puffs with custom shapes, such as those that `fitPuff` creates from a mesh, one per variation. Without an
   * argument, the parameters define the shapes again. This affects rendering only: takes, links and saved states do not
   * contain the shapes.
   * @throws ShapeError when a shape is invalid; the stage is unchanged then
   */
  setPuffs(shapes?: readonly PuffShape[]): void {
    const { smoke } = this.running.picture;
    if (shapes) requireShapes(shapes);
    this.#running.show(() => smoke.usePuffs(shapes));
  }

  /** All values by flat key. Optional parameters appear only when they are set. */
  get(): Values {
    return { ...this.#running.values.all };
  }

  /**
   * All values, with those of the timeline as they are at the time of the picture. A timeline leaves what `get()` returns as
   * it is.
   */
  get shown(): Values {
    return this.#running.values.shown;
  }

  /**
   * Whether a change of a parameter that the timeline animates, also by the camera's gestures, makes a keyframe at the
   * present step. By default false: the value holds until the next keyframe of that parameter.
   */
  get recordsKeyframes(): boolean {
    return this.#running.values.recordsKeyframes;
  }

  set recordsKeyframes(isOn: boolean) {
    this.#running.values.recordsKeyframes = isOn;
  }

  /** Converts between scene and picture coordinates, for overlays. */
  get sight(): Sight {
    return this.#running.sight;
  }

  /** Names of the scene's rigids by index, for attaching emitters and forces. */
  get rigidNames(): readonly string[] {
    return this.#running.opened.scene.rigidNames;
  }

  /** Names of the scene's moving parts by index. Emitters and forces attach to part n as rigid 4096 + n. */
  get partNames(): readonly string[] {
    return (this.#running.opened.scene.parts ?? []).map(({ name }) => name);
  }

  /** Optional parameters that the scene sets, and its backdrop. They apply where `get()` has no value or an empty ramp. */
  get rig(): Values {
    const { simulation, picture } = this.#running;
    return { ...simulation.rig, ...picture.eye.wanted, ...picture.sceneBackdrop };
  }

  /**
   * The current picture as a PNG, transparent where the scene is.
   * @throws ContextError while the graphics context is lost
   */
  async picture(): Promise<Blob> {
    const { completion, picture } = this.running;
    await completion.wait();
    picture.presenter.device.requireUsable();
    picture.smoke.bake();
    this.#running.drawNow(1);
    return picture.presenter.encode();
  }

  /**
   * Creates another stage with the same smoke at the same step and the same camera, for example to render a picture of
   * another size. This stage is unchanged. The copy starts a new take.
   * @param options as for createStage; the values are those of this stage
   * @throws the errors of createStage
   */
  async copy(canvas: DeviceCanvas, options: Omit<StageOptions, 'values'> = {}): Promise<Stage> {
    const { ownShapes } = this.running.picture.smoke;
    const [values, state] = [this.get(), this.save()];
    const stage = await createStage(canvas, { ...options, values });
    const { addModel } = this.#running;
    if (addModel) await stage.#enter(values, {}, addModel);
    stage.setPuffs(ownShapes);
    stage.restore(state);
    return stage;
  }

  /** Serializes the simulator's state, with the colours and the ink of emitters' looks. */
  save(): Uint8Array {
    return this.#running.simulation.save(this.#running.values.all);
  }

  /**
   * Restores a state that was saved in the same scene and starts a new take.
   * @throws SimulatorError for invalid bytes; the stage is unchanged then
   */
  restore(bytes: Uint8Array): void {
    const { simulation, values } = this.running;
    this.#running.showJump(simulation.restore(bytes, values.all));
  }

  /**
   * What was done since the stage was created, restarted or restored, by step: changes of parameters, drags, steering,
   * blows, emissions and clears. A take records up to 20,000 inputs, and 40,000 characters for the changes of style, light
   * and camera; `isTruncated` says whether later ones took effect unrecorded. After a seek back, changes of style, light and
   * camera stay, as if they were made there.
   */
  take({ look = true }: TakeOptions = {}): Take {
    return this.readTake(this.running.simulation.take(look));
  }

  /** Reads the metadata of a take without playing it. @throws SimulatorError for bytes that are damaged or no take */
  readTake(bytes: Uint8Array): Take {
    return this.#running.simulation.readTake(bytes);
  }

  /**
   * Goes to the start of a take and sets the values it started with. Playing, stepping and seeking then replay its
   * inputs, with the same hash at every step. A new input discards the rest of the take.
   * @param take the result of `take()`, or its bytes
   * @throws SimulatorError when the bytes are damaged or the take was made in another scene; nothing changes then
   */
  playTake(take: Take | Uint8Array): void {
    const { simulation } = this.running;
    this.#running.showJump(simulation.playTake(ArrayBuffer.isView(take) ? take : take.toBytes()));
  }

  /** Blows into the smoke at a position in the picture. @throws ParameterError naming the value out of range */
  blow(input: BlowInput): void {
    this.running.gestures.blow(input);
  }

  /** How many objects can be dropped into this scene; 0 in scenes without physics. */
  get dropCount(): number {
    return this.#running.simulation.dropCount;
  }

  /**
   * Drops a ball or a crate at a position in the picture, in CSS pixels from the top left. It starts to fall with the
   * next step. When all objects are in use, the one farthest from that position is reused.
   * @returns false if the scene has no objects to drop
   */
  drop(x: number, y: number): boolean {
    const hasDropped = this.running.gestures.drop(x, y);
    this.#running.show();
    return hasDropped;
  }

  /** Sets a steering channel of the scene, 0 to 7, to a value from -1 to 1. @throws ParameterError for any other */
  steer(channel: number, value: number): void {
    this.running.simulation.input((simulator) => simulator.inputSteer(channel, value));
  }

  /**
   * Emits puffs from the next step on, besides the emitters of the values. Takes and saved states contain it.
   * @returns the number of the emission, for `changeEmission`
   * @throws ParameterError naming the option that is unknown or invalid, or when 384 emissions are not over
   */
  emit(options: EmissionOptions): number {
    return this.running.simulation.emit(options);
  }

  /**
   * Changes options of an emission, for example to move it; the others stay. Does nothing when the emission is over.
   * @param emission the result of `emit`
   * @throws ParameterError naming the option that is unknown or invalid
   */
  changeEmission(emission: number, options: EmissionChange): void {
    requireWhole('emission', emission);
    this.running.simulation.changeEmission(emission, options);
  }

  /** Hash of the simulator's state as 16 hexadecimal digits. Equal states have equal hashes on all platforms. */
  hash(): string {
    return this.#running.simulation.simulator.hash();
  }

  /**
   * @param width, height in CSS pixels; nothing is drawn while one of them is 0
   * @param pixelRatio clamped to 0.1 to 4; unchanged when omitted
   */
  resize(width: number, height: number, pixelRatio?: number): void {
    this.#running.resize(width, height, pixelRatio);
  }

  /** Handles a pointer event. Returns 'rigid' while it drags a rigid, so that the page does not orbit the camera. */
  pointer(input: PointerInput): 'rigid' | null {
    requireFinite({ x: input.x, y: input.y });
    return this.#running.gestures.pointer(input);
  }

  /** Moves the target of the scene's movable rigid, in metres. A spring pulls the rigid there. */
  nudge({ dx = 0, dy = 0, dz = 0 }: { dx?: number; dy?: number; dz?: number }): void {
    requireFinite({ dx, dy, dz });
    this.#running.gestures.nudge(dx, dy, dz);
  }

  /** Stops playback and releases the context and the memory. Can be called more than once. */
  dispose(): void {
    this.#running.dispose();
  }

  /** @internal Its parts, for the demo page. @throws SimulatorError after disposal */
  get running(): RunningScene {
    if (this.#running.isDisposed) throw new SimulatorError('This stage was disposed; create a new one.');
    return this.#running;
  }
}

/**
 * Creates a stage on a canvas. Draws the first picture if the canvas is visible; does not start playback.
 * @throws ParameterError for an invalid value, LoadError when the simulator or the scene cannot be fetched,
 * UnsupportedError when the browser lacks WebGL2 or WASM SIMD, SimulatorError when memory runs out, ContextError when
 * the graphics context is lost and not restored in time, and for a canvas whose stage was disposed
 */
export async function createStage(canvas: DeviceCanvas, options: StageOptions = {}): Promise<Stage> {
  return new Stage(canvas, await openStage(canvas, options));
}
