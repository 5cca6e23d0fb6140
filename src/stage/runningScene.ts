import { Matrix4 } from 'three';
import { missingContext, type Device } from '../renderer/gpu/device.ts';
import { FramesInFlight } from '../renderer/gpu/framesInFlight.ts';
import type { Values } from '../parameters/parameter.ts';
import { requireFinite } from '../parameters/values.ts';
import { AnimationLoading, completionOf, type Completion } from '../renderer/completion.ts';
import { loaded, type PictureKind } from '../renderer/extraPasses.ts';
import { styleOf } from '../renderer/style.ts';
import { STEP_SECONDS } from '../simulator/clock.ts';
import { FIRST_PART } from '../simulator/layout.ts';
import { nextTask } from '../base/work.ts';
import type { SeekOptions, StageEvents, StageOptions } from './contract.ts';
import { FrameLoop, type FrameTasks } from './frameLoop.ts';
import { Gestures } from './gestures.ts';
import { Listeners } from './listeners.ts';
import type { AddModel } from './model/kit.ts';
import type { OpenedScene } from './openScene.ts';
import type { OrbitCamera } from './orbit.ts';
import { Picture, type PictureState } from './picture.ts';
import type { Presenter } from './presenter.ts';
import { Sight } from './sight.ts';
import { Simulation } from './simulation.ts';
import { StageValues } from './stageValues.ts';
import { statsOf } from './stats.ts';

/** Long seeks yield to the event loop this often, milliseconds. */
const SEEKING_MS = 30;

/** The parts of a stage: runs and draws its scene and notifies listeners. */
export class RunningScene implements FrameTasks {
  readonly picture: Picture;
  readonly listeners = new Listeners<StageEvents>();
  readonly loop: FrameLoop;
  /** Loads the code that the picture needs. */
  readonly completion: Completion;
  readonly values: StageValues;
  readonly timeline: AnimationLoading;
  /** Adds the model of the stage to scenes that are entered. */
  addModel: AddModel | undefined;
  /** Replaced when another scene is entered, as its simulation and its gestures. */
  opened: OpenedScene;
  simulation: Simulation;
  gestures: Gestures;
  isDisposed = false;
  private readonly device: Device;
  /** Undefined if the turns limit the frames. */
  private readonly inFlight: FramesInFlight | undefined;
  private readonly stopListening: () => void;
  private readonly options: StageOptions;
  private isStale = false;
  /** Shown in place of other values. */
  private otherLook: Values = {};

  /** @throws ParameterError for an invalid option */
  constructor(presenter: Presenter, opened: OpenedScene, values: Values, options: StageOptions) {
    this.loop = new FrameLoop(this, options.frameRate, options.turns);
    this.options = options;
    this.opened = opened;
    this.simulation = this.simulate(opened, values);
    this.picture = new Picture(presenter, opened.scene, values);
    this.gestures = new Gestures(this.simulation, this.picture, this.showMoved);
    this.values = new StageValues(values, this);
    this.timeline = new AnimationLoading({
      isAnimated: () => this.simulation.isAnimated,
      isWaiting: () => this.simulation.isWaiting,
      set: (given) => this.values.set(given),
      play: () => this.values.playTimeline(),
      load: () => this.completion.begin(),
    });
    this.picture.hasBackground = options.background ?? true;
    this.picture.quality = options.quality ?? 1;
    this.picture.view = options.view;
    this.completion = completionOf(
      () => this.kinds,
      () => {
        this.endLoading();
        this.show();
      },
      (error) => {
        this.listeners.notify('error', error);
        this.goOn();
      },
    );
    this.device = presenter.device;
    if (!options.turns) this.inFlight = new FramesInFlight(this.device);
    this.stopListening = this.device.onContext((event) => {
      if (event === 'missing') this.listeners.notify('error', missingContext());
      if (event !== 'restored') return;
      this.inFlight?.clear();
      this.draw();
    });
  }

  /** Converts between scene and picture coordinates, as of the last picture drawn. */
  get sight(): Sight {
    return new Sight(this.picture, (carrier) => {
      const { rigids, parts } = this.transforms();
      return (carrier < FIRST_PART ? rigids[carrier] : parts[carrier - FIRST_PART]) ?? new Matrix4();
    });
  }

  /** Fraction of the pixel ratio for the next frame. */
  get nextScale(): number {
    const { quality } = this.picture;
    return quality === 'auto' ? this.loop.scale : quality;
  }

  /** The simulated time that is drawn, in steps. */
  get drawnTime(): number {
    return Math.max(0, this.simulation.simulator.steps - 1 + this.loop.clock.blend);
  }

  play(): void {
    if (!this.isDisposed && this.loop.play()) this.notifyState();
  }

  /** @returns whether it was playing */
  stop(): boolean {
    const hasStopped = this.loop.stop();
    if (hasStopped) this.notifyState();
    return hasStopped;
  }

  /** @returns the number of steps that are left because it waits for code */
  advance(steps: number): number {
    if (steps > 0) this.gestures.settle();
    const left = this.simulation.advance(steps, this.options.onStep);
    this.values.applyLog();
    return left;
  }

  /** See `Stage.step`. */
  step(steps: number): void {
    this.timeline.whenOver(() => {
      const left = this.advance(steps);
      this.showLatest();
      if (left > 0) this.step(left);
    });
  }

  /** See `Stage.advance`. */
  advanceBy(seconds: number): void {
    this.timeline.whenOver(() => {
      this.showTime(this.simulation.simulator.steps - 1 + this.loop.clock.blend + seconds / STEP_SECONDS);
    });
  }

  /**
   * Advances to a simulated time and shows exactly it, interpolated when it is between two steps. The picture does not
   * depend on the times shown before. Only `seek` goes back.
   * @param seconds at least the time of the latest step but one
   * @param look valid values of camera and style in place of others, until the next call
   */
  showAt(seconds: number, look: Values = {}): void {
    this.otherLook = look;
    this.values.showWith(look);
    this.showTime(seconds / STEP_SECONDS);
  }

  /** Shows these values of style in place of others, until the next call or that of `showAt`. They stay as they are. */
  showWith(style: Values): void {
    this.show(() => this.values.showWith({ ...this.otherLook, ...style }));
  }

  /** @param goal in steps */
  private showTime(goal: number): void {
    const { steps } = this.simulation.simulator;
    // The tolerance keeps a rounding error from adding a step.
    const last = Math.max(steps, Math.ceil(goal - 1e-6));
    if (this.advance(last - steps) > 0) return this.timeline.whenOver(() => this.showTime(goal));
    this.showLatest(Math.min(1, goal - last + 1));
  }

  /** Seeks to a step and replays the recorded inputs; see `Stage.seek`. */
  async seek(goal: number, { onProgress, signal }: SeekOptions): Promise<void> {
    const { simulation } = this;
    this.loop.isHeld = true;
    try {
      simulation.approach(goal);
      const first = simulation.simulator.steps;
      while (!this.isDisposed && simulation.simulator.steps < goal) {
        simulation.advanceFor(SEEKING_MS, goal);
        onProgress?.((simulation.simulator.steps - first) / (goal - first));
        await nextTask();
        signal?.throwIfAborted();
        // The error was already reported; the seek works without the missing code.
        if (simulation.isWaiting) await this.completion.wait().catch(() => this.goOn());
      }
    } finally {
      this.loop.isHeld = false;
      if (!this.isDisposed) this.showJump();
    }
  }

  /**
   * Goes to a state that was saved in the current take, at any of its steps. Unlike `Stage.restore`, the following steps
   * replay the inputs after that step.
   * @throws SimulatorError for invalid bytes; nothing changes then
   */
  rewind(state: Uint8Array): void {
    this.simulation.rewind(state);
    this.showJump();
  }

  /** Switches to another scene, from its first step; see `Stage.enter`. */
  enter(opened: OpenedScene, values: Values): void {
    // Created first because it can throw.
    const simulation = this.simulate(opened, values);
    this.simulation.dispose();
    this.simulation = simulation;
    this.opened = opened;
    this.picture.enter(opened.scene, values);
    this.gestures = new Gestures(simulation, this.picture, this.showMoved);
    this.values.adoptValues(values);
    this.showLatest();
  }

  /** Called after the picture follows new values. */
  announce(): void {
    this.completion.begin();
    this.notifyState();
  }

  /** Applies a change and redraws, unless the next frame does. */
  show(change?: () => void): void {
    change?.();
    if (!this.loop.isPlaying) this.draw();
  }

  /** Moves the camera. Overridden camera parameters become values. */
  look(move: (eye: OrbitCamera) => void): void {
    this.show(() => {
      const before = this.picture.eye.held;
      move(this.picture.eye);
      this.values.adoptCamera(before);
    });
    this.notifyState();
  }

  /**
   * Shows the state that the simulation has jumped to. Its particles can have more variations than the values ask for.
   * @param values that the simulator has, if the log does not tell
   */
  showJump(values?: Values): void {
    if (values) this.values.adoptValues(values);
    else this.values.applyLog();
    this.picture.smoke.keepVariations(this.simulation.simulator.variationsAlive);
    this.showLatest();
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
  private readonly showMoved = (): void => {
    if (!this.loop.isPlaying && !this.gestures.isSteered) this.show(() => this.gestures.showMoved());
  };

  notifyState(): void {
    this.listeners.notify('statechange', { playing: this.loop.isPlaying });
  }

  /**
   * Whether the canvas is visible. While it is not, nothing is drawn and the render targets are released; the latest
   * picture is drawn when it becomes visible.
   */
  set isSeen(isSeen: boolean) {
    this.loop.isSeen = isSeen;
    if (!isSeen) this.picture.smoke.renderer.releaseTargets();
    if (isSeen && this.isStale && !this.loop.isPlaying) this.draw();
  }

  /** See `Stage.resize`. */
  resize(width: number, height: number, pixelRatio?: number): void {
    requireFinite({ width, height, pixelRatio: pixelRatio ?? 1 });
    if (!this.picture.resize(width, height, pixelRatio)) return;
    this.loop.pauseGovernor();
    this.draw();
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
    if (this.isDisposed) return;
    const { simulation, picture, listeners } = this;
    const { simulator } = simulation;
    this.values.followTimeline();
    // After new values, which have no looks yet. Emissions can have looks that need more code.
    if (picture.smoke.followLooks(simulator)) this.completion.begin();
    const isDrawn = picture.draw({ ...this.transforms(), simulator, scale, isPlaying: this.loop.isPlaying });
    if (isDrawn && listeners.has('frame')) listeners.notify('frame', statsOf(simulation, picture));
  }

  /** Transforms of rigids and parts at the interpolated time. */
  transforms(): Pick<PictureState, 'rigids' | 'parts' | 'blend'> {
    const { blend } = this.loop.clock;
    const rigids = this.gestures.rigids(blend);
    return { rigids, parts: this.simulation.parts(blend, rigids), blend };
  }

  /** An error listener that is added after the context was given up also receives the error. */
  listen<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    if (event === 'error' && !this.device.isRecoverable)
      queueMicrotask(() => (listener as (detail: Error) => void)(missingContext()));
    return this.listeners.add(event, listener);
  }

  dispose(): void {
    if (this.isDisposed) return;
    this.stop();
    this.isDisposed = true;
    this.stopListening();
    this.simulation.dispose();
    this.picture.dispose();
    this.listeners.clear();
  }

  get isBehind(): boolean {
    return this.inFlight?.isFull ?? false;
  }

  /** Called for each frame while playing. */
  frame(steps: number, isDrawn: boolean): void {
    // The clock waits for the timeline.
    if (!this.timeline.isOver) return;
    this.advance(steps);
    if (!isDrawn) return;
    this.draw();
    this.inFlight?.add();
  }

  /** Of the current picture, and of all that the timeline leads to. */
  private get kinds(): readonly PictureKind[] {
    const { picture, simulation } = this;
    const { animation, simulator } = simulation;
    const demanding = animation && styleOf({ ...picture.smoke.values, ...animation.demands });
    const { isAnimationWanted: isAnimated } = this.timeline;
    const { lacksForces } = simulation;
    return [{ ...picture.kindOf(simulator), isAnimated, lacksForces }, ...(demanding ? [demanding] : [])];
  }

  /** Code could not be loaded: continues without it. */
  private goOn(): void {
    this.simulation.goesWithoutForces = !loaded.rareForces;
    this.endLoading();
  }

  private endLoading(): void {
    if (!this.isDisposed) this.timeline.end();
  }

  private simulate({ factory, scene }: OpenedScene, values: Values): Simulation {
    return new Simulation(factory, scene, values, this.options.historyBytes);
  }

  /** An error stopped playback. */
  fail(error: Error): void {
    this.notifyState();
    this.listeners.notify('error', error);
  }
}
