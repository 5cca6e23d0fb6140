/**
 * One simulator: the owner of a handle into WASM, of the views on its memory, and of its life.
 */
import { SimulatorError } from '../preset/errors.ts';
import { requireWhole } from '../preset/values.ts';
import type * as Core from './core.ts';
import { blowNumbers, linesAndNumbers, type Blow } from './input.ts';
import { requireIndices } from './indices.ts';
import type { JointDescription } from './joint.ts';
import { blendPose, poseNumbers } from './pose.ts';
import { errorOfSimulator, isSimulatorRejection } from './simulatorError.ts';
import type { RigidDescription } from './rigid.ts';
import type * as RigidNumbers from './rigidNumbers.ts';
import type { RigidPath, RigidSpin } from './rigidPath.ts';
import { ATTRIBUTE_WORDS, PLACE_FLOATS, POSE_FLOATS, RIGID_FLOATS, type Rows } from './rows.ts';
import { VIEW_FLOATS, viewLength, writeView, type CoverageGrid, type View } from './view.ts';

/** An instantiated module: its functions and its memory. */
export interface SimulatorModule {
  readonly bindings: SimulatorBindings;
  readonly memory: WebAssembly.Memory;
}

/** Of the variant with physics, or of the other. */
export type SimulatorBindings = typeof Core & { readonly rigidNumbers?: typeof RigidNumbers };

/** What a new simulator is made of. */
export interface SimulatorOptions {
  /** Most particles that live at once. Its memory is taken at once, at most 96 bytes a particle. */
  capacity: number;
  /** Same seed, same calls: the same smoke. A whole number from 0 to 4294967295. */
  seed: number;
}

/** The world-space box of the living particles, metres; all zero while nothing lives. */
export interface Bounds {
  min: [number, number, number];
  max: [number, number, number];
  /** Of the living particles, metres. */
  greatestRadius: number;
}

/**
 * Particles under forces, rigids among them. Time goes in steps of 1/60 s, and only when told.
 *
 * Every call throws SimulatorError once the simulator was disposed or a fault stopped it, and ParameterError for a
 * number that it does not take; then nothing was changed.
 */
export class Simulator {
  readonly #module: SimulatorModule;
  readonly #handle: Core.Simulator;
  #view = new Float32Array(VIEW_FLOATS);
  #stopped: string | undefined;

  /** Made by {@link SimulatorFactory.create}. */
  constructor(module: SimulatorModule, options: SimulatorOptions) {
    this.#module = module;
    requireWhole('simulation.maxParticles', options.capacity);
    requireWhole('seed', options.seed);
    this.#handle = this.#attempt(() => new module.bindings.Simulator(options.capacity, options.seed));
  }

  /** Changes parameters by their flat keys, such as `emission.rate`; all of them, or none when one is refused. */
  set(values: Readonly<Record<string, number>>): void {
    const [keys, numbers] = linesAndNumbers(values);
    this.#attempt(() => this.#handle.set(keys, numbers));
  }

  /**
   * Takes up the surface of a mesh, which emitters of the shape `surface` smoke from by its number: `emitters.0.surface`.
   * It is neither drawn nor bumped into. There is room for 16. A save holds it; the hash tells nothing of it.
   *
   * @param vertices x, y, z each, metres about the emitter's place, at most 1000 from it along each axis.
   * @param indices Three a triangle, counter-clockwise from outside, where the smoke leaves.
   * @returns Its number, from 0 on.
   */
  addSurface(vertices: ArrayLike<number>, indices: ArrayLike<number>): number {
    requireIndices(indices, 'surface');
    const mesh = [Float32Array.from(vertices), Uint32Array.from(indices)] as const;
    return this.#attempt(() => this.#handle.addSurface(...mesh));
  }

  /** Puts a rigid among the particles and returns its index; needs the variant with physics. */
  addRigid(description: RigidDescription): number {
    const rigid = this.#rigids.rigidArguments(description);
    return this.#attempt(() => this.#handle.addRigid(...rigid));
  }

  /** Joins two rigids and returns the joint's index. */
  addJoint(description: JointDescription): number {
    const numbers = this.#rigids.jointNumbers(description);
    return this.#attempt(() => this.#handle.addJoint(numbers));
  }

  /**
   * Sends a kinematic rigid to a place, which it reaches in the coming step, or later when it would have to move
   * faster than 120 m/s. It leaves its path for that; its spin goes on. A dynamic rigid is put there at rest.
   *
   * @param rotation Unit quaternion x, y, z, w; no rotation when left out.
   */
  moveRigid(index: number, position: ArrayLike<number>, rotation?: ArrayLike<number>): void {
    this.#attempt(() => this.#handle.moveRigid(index, ...poseNumbers(position, rotation)));
  }

  /** Gives a kinematic rigid a path by the simulator's time, or takes it away. */
  setPath(index: number, path?: RigidPath): void {
    const numbers = this.#rigids.pathNumbers(path);
    this.#attempt(() => this.#handle.setRigidPath(index, numbers));
  }

  /** Lets a kinematic rigid spin on top of all else that moves it, or ends that; it goes on from how it is turned. */
  setSpin(index: number, spin?: RigidSpin): void {
    const numbers = this.#rigids.spinNumbers(spin);
    this.#attempt(() => this.#handle.setRigidSpin(index, ...numbers));
  }

  /**
   * Draws a point of a kinematic or dynamic rigid to a place by a critically damped spring that is as fast for every
   * mass, until {@link releaseRigid}. Call it again to move the place.
   *
   * @param anchor The point in the rigid's own space, metres.
   * @param target Metres, world space.
   * @param stiffness The spring's angular frequency, 0.1 to 200 1/s: a twentieth of the way is left after 4.7 / stiffness s.
   */
  dragRigid(index: number, anchor: ArrayLike<number>, target: ArrayLike<number>, stiffness = 30): void {
    const [a, b, c] = [anchor[0], anchor[1], anchor[2]];
    this.#attempt(() => this.#handle.dragRigid(index, a, b, c, target[0], target[1], target[2], stiffness));
  }

  /** Lets go: a kinematic rigid stays or goes back to its path, a dynamic one flies on. */
  releaseRigid(index: number): void {
    this.#attempt(() => this.#handle.releaseRigid(index));
  }

  /**
   * Says where the scene's parts are in the coming step, and in that step only. Items ride on part n by the number
   * 4096 + n, where others have the number of a rigid.
   *
   * @param numbers All parts at the start of the step, 64 at most, then all at its end. For each the rigid that carries it, -1
   * for none, and its pose in the space of that rigid: x, y, z in metres and the unit quaternion x, y, z, w.
   */
  placeParts(numbers: readonly number[]): void {
    this.#attempt(() => this.#handle.placeParts(Float32Array.from(numbers)));
  }

  /** Advances by `count` steps of 1/60 s. */
  step(count = 1): void {
    requireWhole('step count', count);
    this.#attempt(() => this.#handle.step(count));
  }

  /**
   * Changes how many particles can live at once. Those that live are carried over; where they do not all fit, those
   * go that are nearest to their death.
   */
  resize(capacity: number): void {
    requireWhole('simulation.maxParticles', capacity);
    this.#attempt(() => this.#handle.resize(capacity));
  }

  /** Orders and, if asked, culls the rows for a view. */
  arrange(view: View): Rows {
    const length = viewLength(view);
    if (this.#view.length < length) this.#view = new Float32Array(length);
    const numbers = this.#view.subarray(0, length);
    writeView(view, numbers);
    return this.#attempt(() => {
      const count = this.#handle.arrange(numbers);
      // Memory that grew has a new buffer and leaves old views empty, so the views are made anew for each call.
      const { buffer } = this.#module.memory;
      return {
        count,
        place: new Float32Array(buffer, this.#handle.placePointer, count * PLACE_FLOATS),
        attributes: new Uint32Array(buffer, this.#handle.lookPointer, count * ATTRIBUTE_WORDS),
      };
    });
  }

  /**
   * Where the rigids are between the previous step (0) and now (1), in the order of adding.
   *
   * @param target Taken when it has room; else a new array is made.
   * @returns Per rigid x, y, z and the unit quaternion x, y, z, w.
   */
  rigidPoses(blend: number, target?: Float32Array): Float32Array {
    return this.#attempt(() => {
      const count = this.#handle.rigidCount;
      const poses = new Float32Array(this.#module.memory.buffer, this.#handle.rigidPosesPointer, count * RIGID_FLOATS);
      const size = count * POSE_FLOATS;
      const result = target !== undefined && target.length >= size ? target : new Float32Array(size);
      for (let index = 0; index < count; index++) blendPose(poses, index, blend, result);
      return result;
    });
  }

  /** Rigids added so far. */
  get rigidCount(): number {
    return this.#attempt(() => this.#handle.rigidCount);
  }

  /** What the last {@link arrange} found to hold all living particles with their radius. */
  get bounds(): Bounds {
    return this.#attempt(() => {
      const bounds = new Float32Array(this.#module.memory.buffer, this.#handle.boundsPointer, 7);
      const [a, b, c, d, e, f, greatestRadius] = bounds;
      return { min: [a, b, c], max: [d, e, f], greatestRadius };
    });
  }

  /** By which grid the last {@link arrange} left out what others cover; without cells where it did not. */
  get coverageGrid(): CoverageGrid {
    return this.#attempt(() => {
      const [columns, rows, stride, left, low, density] = this.#handle.coverageShape;
      const depths = new Float32Array(this.#module.memory.buffer, this.#handle.coveragePointer, stride * rows);
      return { columns, rows, stride, corner: [left, low], density, depths };
    });
  }

  /** Particles that live. */
  get alive(): number {
    return this.#attempt(() => this.#handle.alive);
  }

  /** Vortex particles that live, 1,024 at most: what shedders shed. */
  get vortexParticles(): number {
    return this.#attempt(() => this.#handle.vortexParticles);
  }

  /** Particles that wait to be born until there is room. */
  get waiting(): number {
    return this.#attempt(() => this.#handle.waiting);
  }

  /** Steps made since creation. */
  get steps(): number {
    return this.#attempt(() => this.#handle.steps);
  }

  /** The whole state in 16 hexadecimal digits; equal states, equal hashes, on every machine. */
  hash(): string {
    return this.#attempt(() => this.#handle.hash());
  }

  /** The whole state as bytes, for {@link restore}. */
  save(): Uint8Array {
    return this.#attempt(() => this.#handle.save());
  }

  /** Takes up a saved state; bytes that are none are refused and nothing is changed. */
  restore(bytes: Uint8Array): void {
    this.#attempt(() => this.#handle.restore(bytes));
  }

  /**
   * Begins a take: what comes through {@link inputValues}, {@link inputCapacity}, {@link inputPose}, {@link inputDrag},
   * {@link inputRelease}, {@link inputSteer} and {@link inputBlow} from here on is kept with its step. Inputs act in the coming step, quantised as they are kept.
   */
  record(): void {
    this.#attempt(() => this.#handle.record());
  }

  /** {@link set} as something that a person did. */
  inputValues(values: Readonly<Record<string, number>>): void {
    const [keys, numbers] = linesAndNumbers(values);
    this.#attempt(() => this.#handle.inputValues(keys, numbers));
  }

  /** {@link resize} as something that a person did. */
  inputCapacity(capacity: number): void {
    requireWhole('simulation.maxParticles', capacity);
    this.#attempt(() => this.#handle.inputCapacity(capacity));
  }

  /** {@link moveRigid} as something that a person did, to the millimetre. */
  inputPose(rigid: number, position: ArrayLike<number>, rotation?: ArrayLike<number>): void {
    requireWhole('rigid.index', rigid);
    const pose = Float64Array.of(...poseNumbers(position, rotation));
    this.#attempt(() => this.#handle.inputPose(rigid, pose));
  }

  /** {@link dragRigid} as something that a person did: places to the millimetre, stiffness to a tenth. */
  inputDrag(rigid: number, anchor: ArrayLike<number>, target: ArrayLike<number>, stiffness = 30): void {
    requireWhole('rigid.index', rigid);
    const numbers = Float64Array.of(anchor[0], anchor[1], anchor[2], target[0], target[1], target[2], stiffness);
    this.#attempt(() => this.#handle.inputDrag(rigid, numbers));
  }

  /** {@link releaseRigid} as something that a person did. */
  inputRelease(rigid: number): void {
    requireWhole('rigid.index', rigid);
    this.#attempt(() => this.#handle.inputRelease(rigid));
  }

  /** Gives channel 0 to 7, which scenes read by {@link control}, a value from -1 to 1. */
  inputSteer(channel: number, value: number): void {
    requireWhole('steer.channel', channel);
    this.#attempt(() => this.#handle.inputSteer(channel, value));
  }

  /** Lets somebody blow; of several blows between two steps only the last counts, and at most 16 go on at once. */
  inputBlow(blow: Blow): void {
    this.#attempt(() => this.#handle.inputBlow(blowNumbers(blow)));
  }

  /** What a channel was steered to, -1 to 1; 0 before, and for one that does not exist. */
  control(channel: number): number {
    return this.#attempt(() => this.#handle.control(channel));
  }

  /**
   * The take so far as bytes.
   *
   * @param note Comes along unread, at most 64 KiB of UTF-8.
   */
  take(note = ''): Uint8Array {
    return this.#attempt(() => this.#handle.take(note));
  }

  /**
   * Goes to the start of a take; the steps that follow do its inputs, until another input takes over. The simulator
   * must record and have the scene of the take. What is damaged or of another scene is refused and nothing is changed.
   */
  replay(take: Uint8Array): void {
    this.#attempt(() => this.#handle.replay(take));
  }

  /**
   * Goes to a moment of the take that is being recorded or replayed; the steps that follow do the inputs after it.
   *
   * @param state What {@link save} gave at that moment, before the inputs of its step; the start when left out.
   */
  rewind(state?: Uint8Array): void {
    this.#attempt(() => this.#handle.rewind(state));
  }

  /** Inputs of the take that have been done. */
  get inputsDone(): number {
    return this.#attempt(() => this.#handle.inputsDone);
  }

  /** Inputs of the take, at most 20,000. */
  get inputCount(): number {
    return this.#attempt(() => this.#handle.inputCount);
  }

  /** Whether inputs came for which the take had no room: they acted, and a replay will lack them. */
  get isTruncated(): boolean {
    return this.#attempt(() => this.#handle.isTruncated);
  }

  /** Steps made at the farthest point of the take. */
  get takeEnd(): number {
    return this.#attempt(() => this.#handle.takeEnd);
  }

  /** Most particles that live at once. */
  get capacity(): number {
    return this.#attempt(() => this.#handle.capacity);
  }

  /** What starts the random numbers. */
  get seed(): number {
    return this.#attempt(() => this.#handle.seed);
  }

  /** Every parameter that exists now, by key. */
  parameters(): Map<string, number> {
    const numbers = this.#attempt(() => this.#handle.parameterValues());
    const keys = this.#attempt(() => this.#handle.parameterKeys()).split('\n');
    return new Map(keys.map((key, index) => [key, numbers[index]]));
  }

  /** Stops the simulator as a fault inside it would, so that an application can try how it copes. */
  provokeFault(reason: string): void {
    this.#attempt(() => this.#module.bindings.provokeFault(reason));
  }

  /** Gives the memory back. May be called again, and after a fault. */
  dispose(): void {
    // After a fault the handle may still count as borrowed, and freeing it would throw: its memory stays lost.
    if (this.#stopped === undefined) this.#handle.free();
    this.#stopped ??= 'The simulator was disposed.';
  }

  get #rigids(): typeof RigidNumbers {
    const { rigidNumbers } = this.#module.bindings;
    if (rigidNumbers) return rigidNumbers;
    throw new SimulatorError('This simulator has no rigids: use loadSimulators({ physics: true }).');
  }

  #attempt<Result>(action: () => Result): Result {
    if (this.#stopped !== undefined) throw new SimulatorError(`${this.#stopped} Make a new one.`);
    try {
      return action();
    } catch (error) {
      throw this.#explain(error);
    }
  }

  #explain(error: unknown): Error {
    if (isSimulatorRejection(error)) return errorOfSimulator(error);
    if (!(error instanceof WebAssembly.RuntimeError)) {
      return new SimulatorError(`The simulator refused a call: ${String(error)}`, { cause: error });
    }
    this.#stopped = 'The simulator has stopped after a fault.';
    const fault = this.#module.bindings.lastFault() || error.message;
    return new SimulatorError(`The simulator has stopped after a fault: ${fault}. Make a new one.`, { cause: error });
  }
}
