import { Matrix4 } from 'three';
import { missingContext, type ContextEvent, type Device } from '../device/device.ts';
import { FramesInFlight } from '../device/framesInFlight.ts';
import { SimulatorError } from '../preset/errors.ts';
import type { Values } from '../preset/parameter.ts';
import type { Scene } from '../scenes/scene.ts';
import { completionOf, type Completion } from '../smoke/completion.ts';
import { STEP_SECONDS } from '../sim/clock.ts';
import { FIRST_PART } from '../sim/rows.ts';
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

/** A scene that runs: its simulation, its picture and its values go on together, and whoever listens is told. */
export class RunningScene implements FrameTasks {
  readonly picture: Picture;
  readonly listeners = new Listeners<StageEvents>();
  readonly loop: FrameLoop;
  /** Of what the picture needs and is not here. */
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

  /** Another one in each scene. */
  get simulation(): Simulation {
    return this.simulated;
  }

  get gestures(): Gestures {
    return this.hands;
  }

  /** Ways between places of the scene and of its picture, as it was drawn last. */
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

  /** All values by flat key; optional ones only where somebody has set them. */
  get values(): Values {
    return this.now;
  }

  get isDisposed(): boolean {
    return this.hasEnded;
  }

  get stats(): StageStats {
    return statsOf(this.simulation, this.picture);
  }

  /** Share of the pixel ratio that the next frame is drawn with. */
  get nextScale(): number {
    const { quality } = this.picture;
    return quality === 'auto' ? this.loop.scale : quality;
  }

  play(): void {
    if (!this.hasEnded && this.loop.play()) this.notifyState();
  }

  /** Whether it was playing. */
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

  /** Goes on by a time and shows that moment, which may lie between two steps. */
  advanceBy(seconds: number): void {
    const { steps } = this.simulation.simulator;
    const goal = steps - 1 + this.loop.clock.blend + seconds / STEP_SECONDS;
    // A rounding error is not worth a step.
    const last = Math.max(steps, Math.ceil(goal - 1e-6));
    this.advance(last - steps);
    this.showLatest(Math.min(1, goal - last + 1));
  }

  /** Goes to where so many steps lead, with all that was done on the way. */
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

  /** Goes on with another scene, from its first step; see `Stage.enter`. */
  enter(opened: OpenedScene, values: Values): void {
    // First, because it may refuse.
    const simulation = this.simulate(opened, values);
    this.simulated.dispose();
    this.simulated = simulation;
    this.opened = opened;
    this.picture.enter(opened.scene, values);
    this.hands = new Gestures(simulation, this.picture);
    this.follow(values);
    this.showLatest();
  }

  /** Changes values, which are valid; see `Stage.set`. */
  change(values: Values): void {
    const before = this.now;
    const after = { ...before, ...values };
    this.simulation.set(differing(values, before));
    const capacity = after['simulation.maxParticles'] as number;
    if (capacity !== before['simulation.maxParticles']) {
      this.simulation.input((simulator) => simulator.inputCapacity(capacity));
    }
    if (after.seed !== before.seed) this.simulation.restart(after);
    this.show(() => this.follow(after));
  }

  /** Lets optional parameters go back to what the scene has. */
  unset(keys: readonly string[]): void {
    this.simulation.unset(keys);
    const kept = Object.entries(this.now).filter(([key]) => !keys.includes(key));
    this.show(() => this.follow(Object.fromEntries(kept)));
  }

  /** Where the log of a take has done something since, its values are shown. */
  private followLog(): void {
    if (this.simulation.hasFollowed()) this.follow(this.simulation.valuesIn(this.now));
  }

  /** Goes on with these values, which the simulator has already. */
  follow(values: Values): void {
    this.now = values;
    this.picture.follow(values);
    this.completion.begin();
    this.notifyState();
  }

  /** Where a state comes from elsewhere, its particles may have variations that no value has told of. */
  keepVariations(): void {
    this.picture.smoke.keepVariations(this.now, this.simulation.variationsAlive());
  }

  /** Changes what is seen, and shows it unless the next frame does. */
  show(change: () => void): void {
    change();
    if (!this.loop.isPlaying) this.draw();
  }

  /** Moves the eye; what is taken of it from the scene are values like all others. */
  look(move: (eye: OrbitCamera) => void): void {
    this.show(() => {
      move(this.picture.eye);
      this.now = { ...this.now, ...this.picture.eye.held };
    });
    this.notifyState();
  }

  /**
   * Shows where the simulation has come to by steps or by a leap.
   * @param blend between the previous step (0) and the latest (1)
   */
  showLatest(blend = 1): void {
    this.gestures.settle();
    this.loop.clock.settle(blend);
    this.draw();
  }

  /** While playing the spring brings the rigid to where it was put, and frames show it on its way. */
  showMoved(): void {
    if (!this.loop.isPlaying && !this.simulation.isSteered) this.show(() => this.gestures.showMoved());
  }

  notifyState(): void {
    this.listeners.notify('statechange', { playing: this.loop.isPlaying });
  }

  /** Whether anybody can see the pictures. While nobody can, none are drawn; the latest comes when somebody can again. */
  set isSeen(isSeen: boolean) {
    this.loop.isSeen = isSeen;
    if (isSeen && this.isStale && !this.loop.isPlaying) this.draw();
  }

  draw(): void {
    this.isStale = !this.loop.isSeen;
    if (!this.isStale) this.drawNow(this.nextScale);
  }

  /** Draws though nobody may see it. @param scale share of the pixel ratio */
  drawNow(scale: number): void {
    if (this.hasEnded) return;
    const { simulator } = this.simulation;
    const isDrawn = this.picture.draw({ ...this.transforms(), simulator, scale, isPlaying: this.loop.isPlaying });
    if (isDrawn && this.listeners.has('frame')) this.listeners.notify('frame', this.stats);
  }

  /** Of rigids and parts at the moment that is shown. */
  private transforms(): Pick<PictureState, 'rigids' | 'parts' | 'blend'> {
    const { blend } = this.loop.clock;
    const rigids = this.gestures.rigids(blend);
    return { rigids, parts: this.simulation.parts(blend, rigids), blend };
  }

  /** Who comes to listen to errors when nobody waits for the context any longer is told so, too. */
  listen<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    if (event === 'error' && !this.device.hasHope)
      queueMicrotask(() => (listener as (detail: Error) => void)(missingContext()));
    return this.listeners.add(event, listener);
  }

  /** @throws SimulatorError when it was disposed */
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

  /** A frame while it plays. */
  frame(steps: number): void {
    this.advance(steps);
    this.draw();
    this.inFlight.add();
  }

  private simulate({ factory, scene }: OpenedScene, values: Values): Simulation {
    return new Simulation(factory, scene, values, this.options.historyBytes ?? HISTORY_BYTES);
  }

  /** Playing has come to an end by an error. */
  fail(error: Error): void {
    this.notifyState();
    this.listeners.notify('error', error);
  }
}

/** Of `values`, those that `before` has otherwise. */
function differing(values: Values, before: Values): Values {
  return Object.fromEntries(Object.entries(values).filter(([key, value]) => before[key] !== value));
}

/** The figures of a stage as they are now. */
function statsOf(
  simulation: Simulation,
  { smoke, report, renderMs, drawCalls, writesDepth, scale }: Picture,
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
  };
}
