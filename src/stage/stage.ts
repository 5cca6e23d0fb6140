import { MathUtils } from 'three';
import { missingContext, type DeviceCanvas } from '../device/device.ts';
import type { Fault } from '../device/faults.ts';
import type { PuffForm } from '../device/puffTextures.ts';
import type { DebugView, Quality } from '../preset/quality.ts';
import { ParameterError, SimulatorError } from '../preset/errors.ts';
import type { Values } from '../preset/parameter.ts';
import { defaults, requireFinite, requireOptional, requireWhole, validate } from '../preset/values.ts';
import { demandShapes } from '../puffs/lobes.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import { STEP_SECONDS } from '../sim/clock.ts';
import { compileAhead } from '../smoke/prepare.ts';
import { fetchExtras, type PictureKind } from '../smoke/extraPasses.ts';
import type { Renderer } from '../smoke/style.ts';
import { bakeAhead } from '../smoke/prepare.ts';
import type { BlowInput } from './blow.ts';
import type { EnterOptions, PointerInput, SeekOptions, StageEvents, StageOptions, StageStats } from './contract.ts';
import { openScene, type OpenedScene } from './openScene.ts';
import type { Picture } from './picture.ts';
import { createPresenter, type Presenter } from './presenter.ts';
import { RunningScene } from './runningScene.ts';
import type { Retouch } from './shownSmoke.ts';
import type { Simulation } from './simulation.ts';
import type { Sight } from './sight.ts';
import { noteOf, takeOf, type Take } from './take.ts';

/** A running scene on a canvas. Reads no page: sizes, pointers and keys come in as numbers, so that it runs in a worker. */
export class Stage {
  /** Settled when the first picture stands. */
  readonly ready: Promise<void>;
  readonly canvas: DeviceCanvas;
  /**
   * Moves the eye, which sets `camera.*` of what is moved; draws anew when paused. Angles in radians, lengths in CSS
   * pixels. `reset` gives the eye back to the scene.
   */
  readonly camera = {
    orbit: (azimuth: number, elevation: number) => this.#running.look((eye) => eye.orbit(azimuth, elevation)),
    zoom: (factor: number) => this.#running.look((eye) => eye.zoom(factor)),
    pan: (x: number, y: number) => this.#running.look((eye) => eye.pan(x, y, this.#picture.size[1])),
    reset: () => this.#running.unset(Object.keys(this.#picture.eye.held)),
    /** Where the eye stands about the vertical; 0 looks from +z. */
    azimuth: () => this.#picture.eye.azimuth,
  };
  readonly #running: RunningScene;
  /** The latest call of enter. */
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
  }

  get playing(): boolean {
    return this.#running.loop.isPlaying;
  }

  /**
   * Whether anybody can see the canvas; true unless somebody says otherwise. While nobody can, nothing is drawn and playing
   * rests, and whether it plays stays what it was.
   */
  get visible(): boolean {
    return this.#running.loop.isSeen;
  }

  set visible(isVisible: boolean) {
    this.#running.isSeen = isVisible;
  }

  /** Simulated seconds for each real second, 0 to 2. */
  get speed(): number {
    return this.#running.loop.clock.speed;
  }

  /** @throws ParameterError for what is no number */
  set speed(speed: number) {
    requireFinite({ speed });
    this.#running.loop.clock.speed = MathUtils.clamp(speed, 0, 2);
  }

  /** Share of the pixel ratio that is drawn, or 'auto': less than 1 while playing where frames come late. */
  get quality(): Quality {
    return this.#picture.quality;
  }

  /** @throws ParameterError for what is neither 'auto' nor 0.25 to 1 */
  set quality(quality: Quality) {
    this.#running.show(() => (this.#picture.quality = quality));
  }

  /** What is shown instead of the picture; undefined shows the picture. */
  get view(): DebugView | undefined {
    return this.#picture.view;
  }

  /** @throws ParameterError for a view that there is not */
  set view(view: DebugView | undefined) {
    this.#running.show(() => (this.#picture.view = view));
    this.#running.completion.begin();
    this.#running.notifyState();
  }

  /** Whether pictures show what lies behind everything; without it they are transparent there. */
  get background(): boolean {
    return this.#picture.hasBackground;
  }

  set background(isShown: boolean) {
    this.#running.show(() => (this.#picture.hasBackground = isShown));
  }

  get stats(): StageStats {
    return this.#running.stats;
  }

  /** Calls back on an event; returns the function that ends it. */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    return this.#running.listen(event, listener);
  }

  play(): void {
    this.#running.play();
  }

  pause(): void {
    if (!this.#running.stop()) return;
    // What stands still shows all its pixels.
    if (this.#picture.scale !== this.#running.nextScale) this.#running.draw();
  }

  /**
   * Settled when what the values and the view ask for is drawn: other renderers and views come when they are first asked for, and
   * nailboards are drawn until then. Pictures and seeking wait for it by themselves.
   * @throws LoadError when it cannot be fetched; whoever does not ask is told so by an error event, and the stage goes on
   */
  complete(): Promise<void> {
    this.#running.requireAlive();
    return this.#running.completion.wait();
  }

  /**
   * Takes n steps of 1/60 s and shows the last one.
   * @param n a whole number from 0
   * @throws ParameterError for any other n
   */
  step(n = 1): void {
    this.#running.requireAlive();
    requireWhole('n', n);
    this.#running.advance(n);
    this.#running.showLatest();
  }

  /**
   * Goes on by simulated seconds and shows that very moment, also where it falls between two steps: for pictures at any
   * rate. Where it stood between two steps already, it goes on from there.
   * @param seconds from 0
   * @throws ParameterError when seconds is negative or no number
   */
  advance(seconds: number): void {
    this.#running.requireAlive();
    requireFinite({ seconds }, 0);
    this.#running.advanceBy(seconds);
  }

  /**
   * Goes to a simulated time, with everything that was done on the way, as far back as the take began. Playing goes on
   * from there if it was playing. What is done there takes over: what was done later is forgotten.
   * @param seconds from 0; the nearest step is shown
   * @throws ParameterError when seconds is negative or no number
   */
  async seek(seconds: number, options: SeekOptions = {}): Promise<void> {
    this.#running.requireAlive();
    requireFinite({ seconds }, 0);
    options.signal?.throwIfAborted();
    // Who asked for what cannot be had was told; time goes on without it.
    await this.#running.completion.wait().catch(() => undefined);
    await this.#running.seek(Math.round(seconds / STEP_SECONDS), options);
  }

  /** Starts over from the first step with the values as they are, and begins a new take. */
  restart(): void {
    this.#running.requireAlive();
    this.#simulation.restart(this.#running.values);
    this.#running.showLatest();
  }

  /**
   * Goes to the scene of these values, or begins anew in this one, from the first step; values that are left out get the
   * defaults of the table. Of several calls at once the last counts. The old scene goes on until the new one has come.
   * @throws ParameterError for a value it does not take, LoadError when the scene cannot be fetched; nothing has changed then
   */
  async enter(values: Values, { onProgress }: EnterOptions = {}): Promise<void> {
    this.#running.requireAlive();
    const after = withDefaults(values);
    const entry = (this.#entering = {});
    const [opened] = await Promise.all([
      openScene(after.scene as string, onProgress),
      bakeAhead(after),
      fetchExtras(kindOf(after, this.view)),
    ]);
    if (this.#running.isDisposed || this.#entering !== entry) return;
    this.#running.enter(opened, after);
  }

  /**
   * Changes parameters by flat key; all of them, or none when one is refused. A new seed starts over; a new
   * simulation.maxParticles keeps what lives. What the simulator reads becomes part of the take; style, light and camera
   * do not.
   * Another scene comes by `enter`.
   * @throws ParameterError naming the parameter, the value and what would have been accepted
   */
  set(values: Values): void {
    this.#running.requireAlive();
    validate(values);
    const { scene } = this.#running.values;
    if ((values.scene ?? scene) !== scene)
      throw new ParameterError('scene', values.scene, `${scene} (or call enter())`);
    this.#running.change(values);
  }

  /**
   * Lets optional parameters, those of lists and of the camera, go back to what the scene has.
   * @throws ParameterError for a key that is not optional
   */
  unset(keys: readonly string[]): void {
    this.#running.requireAlive();
    keys.forEach(requireOptional);
    this.#running.unset(keys);
  }

  /**
   * Shows puffs of shapes of one's own, such as `fitPuff` makes them of a mesh, a variation each; without any, those that
   * the parameters describe. Looks only: takes, links and saved states hold nothing of it.
   * @throws ShapeError when a shape is none that a puff can have; nothing has changed then
   */
  setPuffs(shapes?: readonly PuffShape[]): void {
    this.#running.requireAlive();
    if (shapes) demandShapes(shapes);
    this.#running.show(() => this.#picture.smoke.usePuffs(shapes, this.#running.values));
  }

  /** All values by flat key; optional ones only where somebody has set them. */
  get(): Values {
    return { ...this.#running.values };
  }

  /** Ways between places of the scene and of its picture, for who puts something over it. */
  get sight(): Sight {
    return this.#running.sight;
  }

  /** Names of the scene's rigids by their number, for people who attach something to one. */
  get rigidNames(): readonly string[] {
    return this.#running.scene.rigidNames;
  }

  /** Names of the scene's moving parts by their number: emitters and forces ride on part n as on rigid 4096 + n. */
  get partNames(): readonly string[] {
    return (this.#running.scene.parts ?? []).map(({ name }) => name);
  }

  /** What the scene itself sets of the optional parameters; it holds wherever `get()` has no value. */
  get rig(): Values {
    return { ...this.#simulation.rig, ...this.#picture.eye.wanted };
  }

  /**
   * The present picture as a PNG, transparent where the scene is.
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
   * Another stage that shows the same smoke at the same step, from the same place: for pictures of another size, while this
   * one stays as it is. The take of the copy begins with it.
   * @param options as of createStage; the values are those of this stage
   * @throws what createStage throws
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
   * @internal Changes what each frame is drawn from, from the next one on and until another scene comes: for pictures
   * that show more than one moment.
   */
  retouch(change: Retouch): void {
    this.#picture.smoke.retouch(change);
  }

  /** The simulator's state as bytes. */
  save(): Uint8Array {
    return this.#simulation.simulator.save();
  }

  /**
   * Takes up a state that was saved in the same scene, with which a new take begins.
   * @throws SimulatorError for bytes that are none; nothing has changed then
   */
  restore(bytes: Uint8Array): void {
    this.#running.requireAlive();
    this.#running.follow(this.#simulation.restore(bytes, this.#running.values));
    this.#running.keepVariations();
    this.#running.showLatest();
  }

  /**
   * What was done since the stage was created, restarted or restored, by step: parameters of the simulator, the rigid
   * that was moved, steering and blowing. It has room for 20,000 inputs; more still act, and `isTruncated` tells.
   */
  take(): Take {
    this.#running.requireAlive();
    return this.readTake(this.#simulation.simulator.take(noteOf(this.#simulation.startValues)));
  }

  /**
   * What a take says of itself, without playing it.
   * @throws SimulatorError when the bytes are damaged or no take
   */
  readTake(bytes: Uint8Array): Take {
    return takeOf(bytes, this.#running.factory.readTake(bytes));
  }

  /**
   * Goes to the start of a take, with all values as they were there; playing, stepping and seeking then do what was done
   * in it, to the same hash at every step. What is done meanwhile takes over: the rest of the take is forgotten.
   * @param take as `take()` gave it, or its bytes
   * @throws SimulatorError when the bytes are damaged or the take was made in another scene; nothing has changed then
   */
  playTake(take: Take | Uint8Array): void {
    this.#running.requireAlive();
    const bytes = take instanceof Uint8Array ? take : take.toBytes();
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
   * Blows into the smoke at a place of the picture.
   * @throws ParameterError naming what is out of range
   */
  blow(input: BlowInput): void {
    this.#running.requireAlive();
    this.#running.gestures.blow(input);
  }

  /** How many things can be dropped into this scene; 0 where it has no physics. */
  get dropCount(): number {
    return this.#simulation.dropCount;
  }

  /**
   * Drops a ball or a crate into the scene at a place of the picture, CSS pixels from the top left; it falls from there
   * with the coming step. When all have been dropped, the one comes again that is farthest from there.
   * @returns whether there was anything to drop
   */
  drop(x: number, y: number): boolean {
    this.#running.requireAlive();
    let hasDropped = false;
    this.#running.show(() => (hasDropped = this.#running.gestures.drop(x, y)));
    return hasDropped;
  }

  /**
   * Steers what a scene has put on a channel.
   * @param channel 0 to 7
   * @param value -1 to 1
   * @throws ParameterError naming what is out of range
   */
  steer(channel: number, value: number): void {
    this.#running.requireAlive();
    this.#simulation.input((simulator) => simulator.inputSteer(channel, value));
  }

  /** The simulator's state in 16 hexadecimal digits; equal states have equal hashes everywhere. */
  hash(): string {
    return this.#simulation.simulator.hash();
  }

  /**
   * @param width, height in CSS pixels; nothing is drawn while one of them is 0
   * @param pixelRatio 0.1 to 4, others are clamped; as it was when left out
   */
  resize(width: number, height: number, pixelRatio?: number): void {
    requireFinite({ width, height, pixelRatio: pixelRatio ?? 1 });
    if (!this.#picture.resize(width, height, pixelRatio)) return;
    this.#running.loop.restGovernor();
    this.#running.draw();
  }

  /** Takes a pointer. Returns 'rigid' while the pointer moves a rigid, so that the page does not turn the camera too. */
  pointer(input: PointerInput): 'rigid' | null {
    requireFinite({ x: input.x, y: input.y });
    return this.#running.gestures.pointer(input, () => this.#running.showMoved());
  }

  /** Moves the place to which a spring draws the scene's movable rigid, by metres. */
  nudge({ dx = 0, dy = 0, dz = 0 }: { dx?: number; dy?: number; dz?: number }): void {
    requireFinite({ dx, dy, dz });
    if (this.#running.gestures.nudge(dx, dy, dz)) this.#running.showMoved();
  }

  /** Stops everything and gives the context and the memory back. May be called again. */
  dispose(): void {
    this.#running.dispose();
  }

  get #simulation(): Simulation {
    return this.#running.simulation;
  }

  get #picture(): Picture {
    return this.#running.picture;
  }
}

function kindOf(values: Values, view: DebugView | undefined): PictureKind {
  return { renderer: values['style.renderer'] as Renderer, form: values['puff.form'] as PuffForm, view };
}

/**
 * Sets a scene up on a canvas and draws its first picture unless nobody can see it; it does not play yet.
 * @throws ParameterError for a value it does not take, LoadError when the simulator or the scene cannot be fetched,
 * UnsupportedError when the browser lacks WebGL2 or WASM SIMD, SimulatorError when there is no memory left, ContextError
 * when the graphics context went meanwhile and has not come back for long, and for a canvas on which a stage was disposed
 */
export async function createStage(canvas: DeviceCanvas, options: StageOptions = {}): Promise<Stage> {
  const values = withDefaults(options.values);
  const presenter = createPresenter(canvas, options.device, options);
  try {
    compileAhead(presenter.device, values);
    const [opened] = await Promise.all([
      openScene(values.scene as string, options.onProgress),
      bakeAhead(values),
      fetchExtras({ ...kindOf(values, options.view), isFlat: !presenter.device.writesDepth }),
    ]);
    if (import.meta.env.DEV && options.fault) await provoke(options.fault, presenter, opened);
    if (!presenter.device.hasHope) throw missingContext();
    return new Stage(canvas, presenter, opened, values, options);
  } catch (error) {
    presenter.dispose();
    throw error;
  }
}

/** @throws ParameterError for a value that no parameter takes */
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
