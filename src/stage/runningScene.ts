import { Matrix4 } from 'three';
import { missingContext, type ContextEvent, type Device } from '../device/device.ts';
import { FramesInFlight } from '../device/framesInFlight.ts';
import { SimulatorError } from '../preset/errors.ts';
import type { Values } from '../preset/parameter.ts';
import { differing } from '../preset/values.ts';
import type { Scene } from '../scenes/scene.ts';
import { completionOf, type Completion } from '../smoke/completion.ts';
import { STEP_SECONDS } from '../sim/clock.ts';
import { FIRST_PART } from '../sim/layout.ts';
import type { SimulatorFactory } from '../sim/load.ts';
import type { SeekOptions, StageEvents, StageOptions, StageStats } from './contract.ts';
import { FrameLoop, type FrameTasks } from './frameLoop.ts';
import { Gestures } from './gestures.ts';
import { Listeners } from './listeners.ts';
import type { OpenedScene } from './openScene.ts';
import type { OrbitCamera } from './orbit.ts';
import { Picture, type PictureState } from './picture.ts';
import type { Presenter } from './presenter.ts';
import { advanceTo } from './seek.ts';
import { Sight } from './sight.ts';
import { Simulation } from './simulation.ts';

const HISTORY_BYTES = 64 * 1024 * 1024;

type RunOptions = Pick<StageOptions, 'frameRate' | 'historyBytes' | 'onStep'>;

/** A running scene: keeps its simulation, picture and values in sync and notifies listeners. */
export class RunningScene implements FrameTasks {
  readonly picture: Picture;
  readonly listeners = new Listeners<StageEvents>();
  readonly loop: FrameLoop;
  /** Loads the code that the picture needs. */
  readonly completion: Completion;
  private readonly device: Device;
  private readonly inFlight: FramesInFlight;
  private readonly stopListening: () => void;
  private readonly options: RunOptions;
  private opened: OpenedScene;
  private simulated: Simulation;
  private hands: Gestures;
  private now: Values;
  private hasEnded = false;
  private isStale = false;

  constructor(presenter: Presenter, opened: OpenedScene, values: Values, options: RunOptions) {
    this.loop = new FrameLoop(this, options.frameRate);
    this.now = values;
    this.options = options;
    this.opened = opened;
    this.simulated = this.simulate(opened, values);
    this.picture = new Picture(presenter, opened.scene, values);
    this.hands = new Gestures(this.simulated, this.picture);
    this.completion = completionOf(
      () => this.picture.kind,
      () => this.show(() => undefined),
      (error) => this.listeners.notify('error', error),
    );
    this.device = presenter.device;
    this.inFlight = new FramesInFlight(this.device);
    this.stopListening = this.device.onContext((event) => this.followContext(event));
  }

  /** Replaced when another scene is entered. */
  get simulation(): Simulation {
    return this.simulated;
  }

  get gestures(): Gestures {
    return this.hands;
  }

  /** Converts between scene and picture coordinates, as of the last picture drawn. */
  get sight(): Sight {
    return new Sight(this.picture, (carrier) => {
      const { rigids, parts } = this.transforms();
      return (carrier < FIRST_PART ? rigids[carrier] : parts[carrier - FIRST_PART]) ?? new Matrix4();
    });
  }

  get scene(): Scene {
    return this.opened.scene;
  }

  get factory(): SimulatorFactory {
    return this.opened.factory;
  }

  /** All values by flat key. Optional parameters appear only when they are set. */
  get values(): Values {
    return this.now;
  }

  get isDisposed(): boolean {
    return this.hasEnded;
  }

  get stats(): StageStats {
    return statsOf(this.simulation, this.picture);
  }

  /** Fraction of the pixel ratio for the next frame. */
  get nextScale(): number {
    const { quality } = this.picture;
    return quality === 'auto' ? this.loop.scale : quality;
  }

  play(): void {
    if (!this.hasEnded && this.loop.play()) this.notifyState();
  }

  /** @returns whether it was playing */
  stop(): boolean {
    const hasStopped = this.loop.stop();
    if (hasStopped) this.notifyState();
    return hasStopped;
  }

  advance(steps: number): void {
    if (steps > 0) this.gestures.settle();
    this.simulation.advance(steps, this.options.onStep);
    this.followLog();
  }

  /** Advances by a duration and shows that time, interpolated when it is between two steps. */
  advanceBy(seconds: number): void {
    const { steps } = this.simulation.simulator;
    const goal = steps - 1 + this.loop.clock.blend + seconds / STEP_SECONDS;
    const last = Math.max(steps, stepsFor(goal));
    this.advance(last - steps);
    this.showLatest(Math.min(1, goal - last + 1));
  }

  /**
   * Advances to a time after that of the latest step but one, and shows it with these values of camera and style. The
   * picture depends on the time only, not on the times shown before.
   */
  showAt(seconds: number, look: Values): void {
    const goal = seconds / STEP_SECONDS;
    const last = stepsFor(goal);
    this.advance(Math.max(0, last - this.simulation.simulator.steps));
    this.follow({ ...this.now, ...look });
    this.showLatest(Math.min(1, goal - last + 1));
  }

  /** Goes to a state of the current take; see `Stage.rewind`. */
  rewind(state: Uint8Array): void {
    this.simulation.rewind(state);
    this.followLog();
    this.keepVariations();
    this.showLatest();
  }

  /** Seeks to a step and replays the recorded inputs. */
  async seek(goal: number, options: SeekOptions): Promise<void> {
    this.loop.isHeld = true;
    try {
      this.simulation.approach(goal);
      await advanceTo(goal, this.simulation, options, () => this.hasEnded);
    } finally {
      this.loop.isHeld = false;
      if (!this.hasEnded) {
        this.followLog();
        this.keepVariations();
        this.showLatest();
      }
    }
  }

  /** Switches to another scene, from its first step; see `Stage.enter`. */
  enter(opened: OpenedScene, values: Values): void {
    // Created first because it can throw.
    const simulation = this.simulate(opened, values);
    this.simulated.dispose();
    this.simulated = simulation;
    this.opened = opened;
    this.picture.enter(opened.scene, values);
    this.hands = new Gestures(simulation, this.picture);
    this.follow(values);
    this.showLatest();
  }

  /** Applies validated values; see `Stage.set`. */
  change(values: Values): void {
    this.replace({ ...this.now, ...values });
  }

  /** Changes to validated values; see `Stage.replace`. */
  replace(after: Values): void {
    const before = this.now;
    this.simulation.unset(Object.keys(before).filter((key) => !(key in after)));
    this.simulation.set(differing(before, after));
    const capacity = after['simulation.maxParticles'] as number;
    if (capacity !== before['simulation.maxParticles']) {
      this.simulation.input((simulator) => simulator.inputCapacity(capacity));
    }
    if (after.seed !== before.seed) this.simulation.restart(after);
    this.show(() => this.follow(after));
  }

  /** Resets optional parameters to what the scene sets. */
  unset(keys: readonly string[]): void {
    this.simulation.unset(keys);
    const kept = Object.entries(this.now).filter(([key]) => !keys.includes(key));
    this.show(() => this.follow(Object.fromEntries(kept)));
  }

  /** Applies values that the log of a take changed since the last call. */
  private followLog(): void {
    if (this.simulation.hasFollowed()) this.follow(this.simulation.valuesIn(this.now));
  }

  /** Applies values that the simulator already has. */
  follow(values: Values): void {
    this.now = values;
    this.picture.follow(values);
    this.completion.begin();
    this.notifyState();
  }

  /** A restored state can contain particles whose variations exceed what the values ask for. */
  keepVariations(): void {
    this.picture.smoke.keepVariations(this.now, this.simulation.simulator.variationsAlive);
  }

  /** Applies a change and redraws, unless the next frame does. */
  show(change: () => void): void {
    change();
    if (!this.loop.isPlaying) this.draw();
  }

  /** Moves the camera. Overridden camera parameters become values. */
  look(move: (eye: OrbitCamera) => void): void {
    this.show(() => {
      move(this.picture.eye);
      this.now = { ...this.now, ...this.picture.eye.held };
    });
    this.notifyState();
  }

  /**
   * Shows the latest state after steps or a seek.
   * @param blend between the previous step (0) and the latest (1)
   */
  showLatest(blend = 1): void {
    this.gestures.settle();
    this.loop.clock.settle(blend);
    this.draw();
  }

  /** Shows the moved rigid while paused. While playing, the spring moves it over the next frames. */
  showMoved(): void {
    if (!this.loop.isPlaying && !this.gestures.isSteered) this.show(() => this.gestures.showMoved());
  }

  notifyState(): void {
    this.listeners.notify('statechange', { playing: this.loop.isPlaying });
  }

  /**
   * Whether the canvas is visible. While it is not, nothing is drawn and the render targets are released; the latest
   * picture is drawn when it becomes visible.
   */
  set isSeen(isSeen: boolean) {
    this.loop.isSeen = isSeen;
    if (!isSeen) this.picture.rest();
    if (isSeen && this.isStale && !this.loop.isPlaying) this.draw();
  }

  draw(): void {
    this.isStale = !this.loop.isSeen;
    if (!this.isStale) this.drawNow(this.nextScale);
  }

  /**
   * Draws even if the canvas is not visible.
   * @param scale fraction of the pixel ratio
   */
  drawNow(scale: number): void {
    if (this.hasEnded) return;
    const { simulator } = this.simulation;
    const isDrawn = this.picture.draw({ ...this.transforms(), simulator, scale, isPlaying: this.loop.isPlaying });
    if (isDrawn && this.listeners.has('frame')) this.listeners.notify('frame', this.stats);
  }

  /** Transforms of rigids and parts at the interpolated time. */
  private transforms(): Pick<PictureState, 'rigids' | 'parts' | 'blend'> {
    const { blend } = this.loop.clock;
    const rigids = this.gestures.rigids(blend);
    return { rigids, parts: this.simulation.parts(blend, rigids), blend };
  }

  /** An error listener that is added after the context was given up also receives the error. */
  listen<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    if (event === 'error' && !this.device.hasHope)
      queueMicrotask(() => (listener as (detail: Error) => void)(missingContext()));
    return this.listeners.add(event, listener);
  }

  /** @throws SimulatorError after disposal */
  requireAlive(): void {
    if (this.hasEnded) throw new SimulatorError('This stage was disposed; create a new one.');
  }

  dispose(): void {
    if (this.hasEnded) return;
    this.stop();
    this.hasEnded = true;
    this.stopListening();
    this.simulation.dispose();
    this.picture.dispose();
    this.listeners.clear();
  }

  private followContext(event: ContextEvent): void {
    if (event === 'restored') this.drawAnew();
    if (event === 'missing') this.listeners.notify('error', missingContext());
  }

  private drawAnew(): void {
    this.inFlight.clear();
    this.draw();
  }

  get isBehind(): boolean {
    return this.inFlight.isFull;
  }

  /** Called for each frame while playing. */
  frame(steps: number): void {
    this.advance(steps);
    this.draw();
    this.inFlight.add();
  }

  private simulate({ factory, scene }: OpenedScene, values: Values): Simulation {
    return new Simulation(factory, scene, values, this.options.historyBytes ?? HISTORY_BYTES);
  }

  /** An error stopped playback. */
  fail(error: Error): void {
    this.notifyState();
    this.listeners.notify('error', error);
  }
}

/**
 * The number of steps after which a time can be shown. The tolerance keeps a rounding error from adding a step.
 * @param goal in steps
 */
function stepsFor(goal: number): number {
  return Math.max(0, Math.ceil(goal - 1e-6));
}

function statsOf(
  simulation: Simulation,
  { smoke, report, renderMs, drawCalls, writesDepth, scale, timer }: Picture,
): StageStats {
  const { alive, waiting, steps, inputCount, isTruncated } = simulation.simulator;
  return {
    time: steps * STEP_SECONDS,
    steps,
    alive,
    waiting,
    inputs: inputCount,
    isTruncated,
    historyBytes: simulation.historyBytes,
    ...report,
    bodiesTotal: alive,
    castersTotal: smoke.throwsShadow ? alive : 0,
    simMs: simulation.stepMs,
    renderMs,
    drawCalls,
    writesDepth,
    scale,
    ...timer?.read(),
  };
}
