import { MathUtils, Matrix4, Quaternion, Vector2, Vector3 } from 'three';
import type { Device, DeviceCanvas } from '../device/device.ts';
import { SimulatorError } from '../preset/errors.ts';
import type { Values } from '../preset/parameter.ts';
import { defaults, validate } from '../preset/values.ts';
import type { Scene } from '../scenes/scene.ts';
import { sceneNamed } from '../scenes/scenes.ts';
import { loadSimulators, type LoadProgress, type SimulatorFactory } from '../sim/load.ts';
import type { Simulator } from '../sim/simulator.ts';
import type { FrameReport } from '../smoke/frame.ts';
import { towardsLight } from '../smoke/light.ts';
import { CartoonSmoke } from '../smoke/smoke.ts';
import { styleOf, type Style } from '../smoke/style.ts';
import { Clock, STEP_SECONDS } from './clock.ts';
import { Drag } from './drag.ts';
import { OrbitCamera } from './orbit.ts';
import { createPresenter, type Presenter } from './presenter.ts';
import { simulatorValues } from './simulatorValues.ts';

export interface StageOptions {
  /** Flat values that differ from the defaults of the table. */
  values?: Values;
  /** A device to share; without it the stage takes a WebGL2 context of its own on the canvas. */
  device?: Device;
  /** Size of the canvas in CSS pixels and how many pixels make one; the canvas's own size where absent. */
  width?: number;
  height?: number;
  pixelRatio?: number;
  /** Told how much of what must be fetched has come. */
  onProgress?: (progress: LoadProgress) => void;
}

/** What a stage is doing; figures of the latest frame. */
export interface StageStats {
  /** Simulated seconds. */
  time: number;
  steps: number;
  alive: number;
  /** Particles that wait for room to be born. */
  waiting: number;
  bodiesDrawn: number;
  castersDrawn: number;
  bodiesTotal: number;
  castersTotal: number;
  simMs: number;
  arrangeMs: number;
  renderMs: number;
  drawCalls: number;
}

export interface SeekOptions {
  /** Told how far the seek has come, 0 to 1. */
  onProgress?: (share: number) => void;
  /** Aborting stops the seek where it is; the promise then rejects with the signal's reason. */
  signal?: AbortSignal;
}

/** A pointer as plain data, in CSS pixels from the top left of the canvas. */
export interface PointerInput {
  type: 'down' | 'move' | 'up' | 'cancel';
  id: number;
  x: number;
  y: number;
}

export interface StageEvents {
  /** Playing began or ended, or values changed. */
  statechange: { playing: boolean };
  /** Something stopped the stage; it says what. */
  error: Error;
  /** A frame was drawn. */
  frame: StageStats;
}

// Long seeks give the page a turn this often, milliseconds.
const SEEK_SLICE_MS = 30;
const LARGEST_PIXEL_RATIO = 4;

/** A running scene on a canvas. Reads no page: sizes, pointers and keys come in as numbers, so that it runs in a worker. */
export class Stage {
  /** Settled when the first picture stands. */
  readonly ready: Promise<void>;
  readonly canvas: DeviceCanvas;
  /** Moves the eye; draws anew when paused. */
  readonly camera = {
    orbit: (azimuth: number, elevation: number) => this.#moveEye(() => this.#eye.orbit(azimuth, elevation)),
    zoom: (factor: number) => this.#moveEye(() => this.#eye.zoom(factor)),
    pan: (x: number, y: number) => this.#moveEye(() => this.#eye.pan(x, y, this.#height / this.#pixelRatio)),
    reset: () => this.#moveEye(() => this.#eye.reset()),
  };
  readonly #presenter: Presenter;
  readonly #factory: SimulatorFactory;
  readonly #scene: Scene;
  readonly #eye: OrbitCamera;
  readonly #clock = new Clock();
  readonly #light = new Vector3();
  readonly #rigids: Matrix4[];
  readonly #listeners: { [Event in keyof StageEvents]: Set<(detail: StageEvents[Event]) => void> } = {
    statechange: new Set(),
    error: new Set(),
    frame: new Set(),
  };
  readonly #stopListening: () => void;
  #drag: Drag | undefined;
  #smoke: CartoonSmoke;
  #simulator: Simulator;
  #values: Values;
  #style: Style;
  #width = 0;
  #height = 0;
  #pixelRatio = 1;
  #playing = false;
  #disposed = false;
  #seeking = false;
  #request = 0;
  #simMs = 0;
  #renderMs = 0;
  #report: FrameReport = { bodiesDrawn: 0, castersDrawn: 0, arrangeMs: 0 };
  #drawCalls = 0;

  /** @internal Use createStage. */
  constructor(canvas: DeviceCanvas, presenter: Presenter, factory: SimulatorFactory, options: StageOptions) {
    this.canvas = canvas;
    this.#presenter = presenter;
    this.#factory = factory;
    this.#values = { ...defaults(), ...options.values };
    this.#style = styleOf(this.#values);
    this.#scene = sceneNamed(this.#values.scene as string);
    this.#rigids = this.#scene.rigids.map(() => new Matrix4());
    this.#eye = new OrbitCamera(this.#scene.camera);
    this.#smoke = this.#prepareSmoke();
    this.#simulator = this.#start();
    this.#aimLight();
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

  get stats(): StageStats {
    const { alive, waiting, steps } = this.#simulator;
    return {
      time: steps * STEP_SECONDS,
      steps,
      alive,
      waiting,
      bodiesDrawn: this.#report.bodiesDrawn,
      castersDrawn: this.#report.castersDrawn,
      bodiesTotal: alive,
      castersTotal: this.#style.shadows ? alive : 0,
      simMs: this.#simMs,
      arrangeMs: this.#report.arrangeMs,
      renderMs: this.#renderMs,
      drawCalls: this.#drawCalls,
    };
  }

  /** Calls back on an event; returns the function that ends it. */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void {
    this.#listeners[event].add(listener);
    return () => this.#listeners[event].delete(listener);
  }

  play(): void {
    if (this.#playing || this.#disposed) return;
    this.#playing = true;
    this.#clock.rest();
    this.#request = requestAnimationFrame(this.#tick);
    this.#emit('statechange', { playing: true });
  }

  pause(): void {
    if (!this.#playing) return;
    this.#playing = false;
    cancelAnimationFrame(this.#request);
    this.#clock.rest();
    this.#emit('statechange', { playing: false });
  }

  /** Takes n whole steps and shows the last one. */
  step(n = 1): void {
    this.#requireAlive();
    this.#advance(n);
    this.#clock.settle();
    this.#draw();
  }

  /** Goes to a simulated time, backwards by starting over. Playing goes on from there if it was playing. */
  async seek(seconds: number, { onProgress, signal }: SeekOptions = {}): Promise<void> {
    this.#requireAlive();
    const goal = Math.max(0, Math.round(seconds / STEP_SECONDS));
    if (goal < this.#simulator.steps) this.#replaceSimulator();
    const first = this.#simulator.steps;
    this.#seeking = true;
    try {
      while (this.#simulator.steps < goal) {
        this.#advanceFor(SEEK_SLICE_MS, goal);
        onProgress?.((this.#simulator.steps - first) / (goal - first));
        await nextTask();
        signal?.throwIfAborted();
        if (this.#disposed) return;
      }
    } finally {
      this.#seeking = false;
    }
    this.#clock.settle();
    this.#draw();
  }

  /** Starts over from the first step with the values as they are. */
  restart(): void {
    this.#requireAlive();
    this.#replaceSimulator();
    this.#clock.settle();
    this.#draw();
  }

  /**
   * Changes parameters by flat key; all of them, or none when one is refused. A new seed starts over; a new
   * simulation.maxParticles keeps what lives.
   * @throws ParameterError naming the parameter, the value and what would have been accepted
   */
  set(values: Values): void {
    this.#requireAlive();
    validate(values);
    if (values.scene !== undefined) sceneNamed(values.scene as string);
    const before = this.#values;
    const after = { ...before, ...values };
    this.#simulator.set(simulatorValues(after, values));
    this.#values = after;
    this.#style = styleOf(after);
    this.#aimLight();
    if (after['simulation.maxParticles'] !== before['simulation.maxParticles']) this.#resizeSimulator();
    if (after.seed !== before.seed) this.#replaceSimulator();
    this.#emit('statechange', { playing: this.#playing });
    if (!this.#playing) this.#draw();
  }

  /** All values by flat key. */
  get(): Values {
    return { ...this.#values };
  }

  /**
   * The present picture as a PNG, transparent where the scene is.
   * @throws ContextError while the graphics context is lost
   */
  async picture(): Promise<Blob> {
    this.#requireAlive();
    this.#presenter.device.requireUsable();
    this.#draw();
    return this.#presenter.encode();
  }

  /** The simulator's state as bytes. */
  save(): Uint8Array {
    return this.#simulator.save();
  }

  /** Takes up a saved state; refuses bytes that are none and then changes nothing. */
  restore(bytes: Uint8Array): void {
    this.#requireAlive();
    this.#simulator.restore(bytes);
    this.#clock.settle();
    this.#draw();
  }

  /** The simulator's state in 16 hexadecimal digits; equal states have equal hashes everywhere. */
  hash(): string {
    return this.#simulator.hash();
  }

  /** @param width, height in CSS pixels; nothing is drawn while one of them is 0 */
  resize(width: number, height: number, pixelRatio = this.#pixelRatio): void {
    this.#pixelRatio = MathUtils.clamp(pixelRatio, 0.1, LARGEST_PIXEL_RATIO);
    this.#width = Math.round(width * this.#pixelRatio);
    this.#height = Math.round(height * this.#pixelRatio);
    if (this.#isVisible) this.#eye.setAspect(this.#width / this.#height);
    this.#draw();
  }

  /** Takes a pointer. Returns 'rigid' while the pointer moves a rigid, so that the page does not turn the camera too. */
  pointer({ type, id, x, y }: PointerInput): 'rigid' | null {
    if (!this.#drag || !this.#isVisible) return null;
    const ratio = this.#pixelRatio;
    const at = new Vector2(((x * ratio) / this.#width) * 2 - 1, 1 - ((y * ratio) / this.#height) * 2);
    const { camera } = this.#eye;
    if (type === 'down') return this.#drag.grab(id, at, camera, this.#handlePlace()) ? 'rigid' : null;
    if (type === 'move') return this.#drag.follow(id, at, camera) ? 'rigid' : null;
    return this.#drag.release(id) ? 'rigid' : null;
  }

  /** Moves the scene's movable rigid by metres. */
  nudge({ dx = 0, dy = 0, dz = 0 }: { dx?: number; dy?: number; dz?: number }): void {
    this.#drag?.nudge(new Vector3(dx, dy, dz));
  }

  /** Stops everything and gives the context and the memory back. May be called again. */
  dispose(): void {
    if (this.#disposed) return;
    this.pause();
    this.#disposed = true;
    this.#stopListening();
    this.#smoke.dispose();
    this.#simulator.dispose();
    this.#presenter.dispose();
    for (const listeners of Object.values(this.#listeners)) listeners.clear();
  }

  get #capacity(): number {
    return this.#values['simulation.maxParticles'] as number;
  }

  get #isVisible(): boolean {
    return this.#width > 0 && this.#height > 0;
  }

  readonly #tick = (now: number): void => {
    if (!this.#playing) return;
    this.#request = requestAnimationFrame(this.#tick);
    if (this.#seeking) return;
    try {
      this.#advance(this.#clock.tick(now));
      this.#draw();
    } catch (error) {
      this.pause();
      this.#emit('error', error as Error);
    }
  };

  #advance(steps: number): void {
    if (steps === 0) return;
    const started = performance.now();
    for (let taken = 0; taken < steps; ++taken) {
      if (this.#drag) this.#simulator.moveRigid(this.#scene.handle!.rigid, this.#drag.target.toArray());
      this.#simulator.step();
    }
    this.#simMs = (performance.now() - started) / steps;
  }

  #advanceFor(milliseconds: number, goal: number): void {
    const until = performance.now() + milliseconds;
    while (this.#simulator.steps < goal && performance.now() < until) this.#advance(1);
  }

  #draw(): void {
    if (this.#disposed || !this.#isVisible || !this.#presenter.device.isUsable) return;
    const started = performance.now();
    this.#placeRigids();
    this.#presenter.prepare(this.#width, this.#height);
    this.#report = this.#smoke.draw({
      simulator: this.#simulator,
      camera: this.#eye.camera,
      towardsLight: this.#light,
      style: this.#style,
      blend: this.#clock.blend,
      width: this.#width,
      height: this.#height,
      pixelRatio: this.#pixelRatio,
      rigids: this.#rigids,
      cull: true,
      output: null,
    });
    this.#presenter.present();
    this.#renderMs = performance.now() - started;
    this.#drawCalls = this.#presenter.device.renderer.info.render.calls;
    if (this.#listeners.frame.size > 0) this.#emit('frame', this.stats);
  }

  #placeRigids(): void {
    const poses = this.#simulator.rigidPoses(this.#clock.blend);
    const [place, turn, size] = [new Vector3(), new Quaternion(), new Vector3(1, 1, 1)];
    this.#rigids.forEach((matrix, rigid) => {
      matrix.compose(place.fromArray(poses, 7 * rigid), turn.fromArray(poses, 7 * rigid + 3), size);
    });
  }

  #handlePlace(): Vector3 {
    return new Vector3().setFromMatrixPosition(this.#rigids[this.#scene.handle!.rigid]);
  }

  #start(): Simulator {
    const simulator = this.#factory.create({ capacity: this.#capacity, seed: this.#values.seed as number });
    simulator.set({ ...this.#scene.rig, ...simulatorValues(this.#values, this.#values) });
    for (const rigid of this.#scene.rigids) simulator.addRigid(rigid);
    this.#drag = this.#scene.handle && new Drag(this.#scene.handle);
    return simulator;
  }

  #replaceSimulator(): void {
    this.#simulator.dispose();
    this.#simulator = this.#start();
  }

  #resizeSimulator(): void {
    this.#simulator.resize(this.#capacity);
    this.#smoke.dispose();
    this.#smoke = this.#prepareSmoke();
  }

  #prepareSmoke(): CartoonSmoke {
    return new CartoonSmoke(this.#presenter.device, { ...this.#scene, capacity: this.#capacity });
  }

  #aimLight(): void {
    towardsLight(this.#values['light.azimuth'] as number, this.#values['light.elevation'] as number, this.#light);
  }

  #moveEye(move: () => void): void {
    move();
    if (!this.#playing) this.#draw();
  }

  #requireAlive(): void {
    if (this.#disposed) throw new SimulatorError('This stage was disposed; create a new one.');
  }

  #emit<Event extends keyof StageEvents>(event: Event, detail: StageEvents[Event]): void {
    for (const listener of this.#listeners[event]) listener(detail);
  }
}

/**
 * Sets a scene up on a canvas and draws its first picture; it does not play yet.
 * @throws ParameterError for a value it does not take, LoadError when the simulator cannot be fetched,
 * UnsupportedError when the browser lacks WebGL2 or WASM SIMD
 */
export async function createStage(canvas: DeviceCanvas, options: StageOptions = {}): Promise<Stage> {
  validate(options.values ?? {});
  const scene = sceneNamed((options.values?.scene ?? defaults().scene) as string);
  const presenter = createPresenter(canvas, options.device);
  try {
    const factory = await loadSimulators({ physics: scene.rigids.length > 0, onProgress: options.onProgress });
    return new Stage(canvas, presenter, factory, options);
  } catch (error) {
    presenter.dispose();
    throw error;
  }
}

/** Lets the page have a turn, without the delay that nested timers get. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
