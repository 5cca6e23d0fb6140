/** Wraps one WASM simulator: owns its handle, the typed-array views on its memory, and its lifetime. */
import { SimulatorError } from '../base/errors.ts';
import type { AnyValues } from '../parameters/parameter.ts';
import { requireWhole } from '../parameters/values.ts';
import { ArrangedInMemory, type Arranged } from './arranged.ts';
import type * as Core from './core.ts';
import { blowNumbers, linesAndNumbers, type Blow } from './input.ts';
import { FIRST_NUMBER, numbersOfStyles } from './lookStyles.ts';
import { splitState, withSavedLooks } from './savedState.ts';
import { requireIndices, type RigidDescription, blendPose, poseNumbers } from './rigid.ts';
import type { rigidArguments } from './rigidArguments.ts';
import { errorOfSimulator, isSimulatorRejection } from './simulatorError.ts';
import { POSE_FLOATS, RIGID_FLOATS, VIEW_FLOATS } from './layout.ts';
import { viewLength, writeView, type View } from './view.ts';

/** An instantiated module: its functions and its memory. */
export interface SimulatorModule {
  readonly bindings: SimulatorBindings;
  readonly memory: WebAssembly.Memory;
}

/** Bindings of a WASM variant. `rigidArguments` exists only in those with rigids, `hasDynamics` in that with physics. */
export type SimulatorBindings = typeof Core & {
  readonly rigidArguments?: typeof rigidArguments;
  readonly hasDynamics?: true;
};

/** Number of the styles of looks that are remembered for takes and saved states. */
const MOST_STYLES = 256;

/** Options of a new simulator. */
export interface SimulatorOptions {
  /** Maximum number of live particles. Their memory is allocated up front, at most 96 bytes per particle. */
  capacity: number;
  /** Random seed, an integer from 0 to 4294967295. The same seed and the same calls give the same smoke. */
  seed: number;
}

/**
 * A particle simulation with forces and rigid bodies. Time advances in fixed steps of 1/60 s, only through
 * {@link step}.
 *
 * Every method throws SimulatorError after the simulator was disposed or stopped by a fault, and ParameterError for an
 * invalid number. A rejected call changes nothing.
 */
export class Simulator {
  #module: SimulatorModule;
  #handle: Core.Simulator;
  #arranged: ArrangedInMemory;
  #view = new Float32Array(VIEW_FLOATS);
  #stopped: string | undefined;
  /** Numbers of the styles of looks that emitters outside the table have had, the latest last. */
  readonly #styles = new Set<number>();

  /** Use {@link SimulatorFactory.create} instead. */
  constructor(module: SimulatorModule, options: SimulatorOptions) {
    this.#module = module;
    requireWhole('simulation.maxParticles', options.capacity);
    requireWhole('seed', options.seed);
    this.#handle = this.#attempt(() => new module.bindings.Simulator(options.capacity, options.seed));
    this.#arranged = new ArrangedInMemory(this.#handle, module.memory);
  }

  /** Sets parameters by their flat keys, such as `emission.rate`. Sets none of them if one is rejected. */
  set(values: Readonly<Record<string, number>>): void {
    const [keys, numbers] = linesAndNumbers(values);
    this.#attempt(() => this.#handle.set(keys, numbers));
  }

  /**
   * Adds a triangle mesh for emitters with the shape `surface`; `emitters.0.surface` refers to it by its index. The
   * mesh is neither drawn nor a collider. At most 16 surfaces are allowed. A saved state contains them; the hash does
   * not cover them.
   *
   * @param vertices x, y, z per vertex, in metres relative to the emitter, each coordinate within 1000.
   * @param indices Three per triangle, counter-clockwise seen from outside, the side where smoke is emitted.
   * @returns Index of the surface, starting at 0.
   */
  addSurface(vertices: ArrayLike<number>, indices: ArrayLike<number>): number {
    requireIndices(indices, 'surface');
    const mesh = [Float32Array.from(vertices), Uint32Array.from(indices)] as const;
    return this.#attempt(() => this.#handle.addSurface(...mesh));
  }

  /**
   * Sets an emitter of the pool, outside the parameter table, or adds births to the next step of any emitter. It is saved,
   * but not recorded in takes.
   *
   * @param index 0 to 7 in the table, 8 to 391 in the pool
   * @param numbers Parameters of `emitters.#` in the order of lists.json, three for a vector, eight for a curve, 54 in all.
   * `share` is its rate in particles/s. Without numbers and a count the place is freed.
   * @param count Births in the next step. With numbers they replace those that wait.
   */
  setEmitter(index: number, numbers: Float64Array, count = 0): void {
    this.#requireRunning();
    let rejection: unknown;
    // No closure: bursts come often and leave no garbage.
    try {
      rejection = this.#handle.setEmitter(index, numbers, count);
      this.#noteStyle(numbers);
    } catch (error) {
      throw this.#explain(error);
    }
    if (rejection) throw this.#explain(rejection);
  }

  /**
   * Sets, moves or removes a collider outside the parameter table. It is saved and part of the hash. As those of rigids,
   * its moves are not recorded in takes.
   *
   * @param index 0 to 255
   * @param numbers Of a collider at rest, as `sim-wasm/sim/src/collide/pool.rs` documents them; seven of the pose at which
   * it arrives in the next step, or later if that would need more than 120 m/s; none to remove it.
   */
  setCollider(index: number, numbers: Float32Array): void {
    this.#attempt(() => this.#handle.setCollider(index, numbers));
  }

  /** Whether emitters have or had looks: rows then have the index of a look. False after it has stopped. */
  get hasLooks(): boolean {
    return this.#stopped === undefined && this.#handle.hasLooks;
  }

  /**
   * The looks of the puffs, three numbers for each index from 1 to 15: the number of a style, see lookStyles.ts, the tint of
   * the emitter, and the option of `emitters.#.look.dissolve`. Empty without looks.
   */
  lookStyles(): Float64Array {
    return this.#attempt(() => this.#handle.lookStyles());
  }

  /** Numbers of the styles of looks outside the table that a take or a saved state may refer to. */
  get styles(): ReadonlySet<number> {
    return this.#styles;
  }

  /** Adds {@link styles}. */
  addStyles(styles: readonly number[]): void {
    for (const style of styles) this.#styles.add(style);
  }

  /**
   * Number of steps at which the longest-lived puff of the latest burst ends; -1 while births wait or if there was none.
   * @param index of the emitter, see {@link setEmitter}
   */
  burstEnd(index: number): number {
    return this.#attempt(() => this.#handle.burstEnd(index));
  }

  /** Whether it has rigids. */
  get hasRigids(): boolean {
    return this.#module.bindings.rigidArguments !== undefined;
  }

  /** Whether there are rare forces, which need a larger variant: it must not take a step. See `rareForces.ts`. */
  get lacksForces(): boolean {
    return this.#stopped === undefined && !this.hasRigids && this.#handle.hasRareForces;
  }

  /** Whether it has dynamic rigids. */
  get hasDynamics(): boolean {
    return this.#module.bindings.hasDynamics !== undefined;
  }

  /** Continues from the same state in a larger module, such as that with physics. The recording of a take ends. */
  moveTo(module: SimulatorModule): void {
    this.#attempt(() => {
      const before = this.#handle;
      const handle = new module.bindings.Simulator(before.capacity, before.seed);
      handle.restore(before.save(), true);
      before.free();
      this.#module = module;
      this.#handle = handle;
      this.#arranged = new ArrangedInMemory(handle, module.memory);
    });
  }

  /** Adds a rigid body and returns its index. Requires a variant with rigids; dynamic ones require that with physics. */
  addRigid(description: RigidDescription): number {
    const { rigidArguments } = this.#module.bindings;
    if (!rigidArguments) {
      throw new SimulatorError('This simulator has no rigids: use loadSimulators({ physics: true }).');
    }
    const rigid = rigidArguments(description);
    return this.#attempt(() => this.#handle.addRigid(...rigid));
  }

  /** Removes a rigid. The next rigid that is added takes the lowest free index. */
  removeRigid(index: number): void {
    this.#attempt(() => this.#handle.removeRigid(index));
  }

  /**
   * Moves a kinematic rigid to a pose. It arrives in the next step, or later if that would need more than 120 m/s. A
   * dynamic rigid is placed there at rest.
   *
   * @param position x, y, z in metres, world space.
   * @param rotation Unit quaternion x, y, z, w; identity if omitted.
   */
  moveRigid(index: number, position: ArrayLike<number>, rotation?: ArrayLike<number>): void {
    this.#attempt(() => this.#handle.moveRigid(index, ...poseNumbers(position, rotation)));
  }

  /**
   * Pulls a point of a kinematic or dynamic rigid towards a target with a critically damped spring, until
   * {@link releaseRigid}. The response time does not depend on the mass. Call it again to move the target.
   *
   * @param anchor The point in the rigid's local space, metres.
   * @param target Metres, world space.
   * @param stiffness Angular frequency of the spring, 0.1 to 200 1/s: 5 % of the distance remains after
   * 4.7 / stiffness s.
   */
  dragRigid(index: number, anchor: ArrayLike<number>, target: ArrayLike<number>, stiffness = 30): void {
    const [a, b, c] = [anchor[0], anchor[1], anchor[2]];
    this.#attempt(() => this.#handle.dragRigid(index, a, b, c, target[0], target[1], target[2], stiffness));
  }

  /** Ends a drag. A kinematic rigid stays; a dynamic rigid keeps its velocity. */
  releaseRigid(index: number): void {
    this.#attempt(() => this.#handle.releaseRigid(index));
  }

  /**
   * Sets the poses of the scene's parts for the next step only. List items attach to part n with the index 4096 + n in
   * place of a rigid's index.
   *
   * @param numbers All parts at the start of the step, at most 64, then all parts at its end. Each part has eight
   * numbers: the index of its parent rigid or -1, then its pose in that rigid's space: x, y, z in metres and the unit
   * quaternion x, y, z, w. Three more numbers are the unit vector against which gravity acts in that step; y without them.
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
   * Changes the maximum number of live particles. Live particles are kept; if they do not all fit, those closest to the
   * end of their lifetime are removed.
   */
  resize(capacity: number): void {
    requireWhole('simulation.maxParticles', capacity);
    this.#attempt(() => this.#handle.resize(capacity));
  }

  /** Sorts the rows for a view, and culls them if `view.cull` is set. */
  arrange(view: View): Arranged {
    const length = viewLength(view);
    if (this.#view.length < length) this.#view = new Float32Array(length);
    const numbers = this.#view.subarray(0, length);
    writeView(view, numbers);
    return this.#attempt(() => this.#arranged.read(this.#handle.arrange(numbers)));
  }

  /** One more than the highest variation of a living particle; 0 without particles. */
  get variationsAlive(): number {
    return this.#attempt(() => this.#handle.variationsAlive);
  }

  /**
   * The lamps at the glowing parts of smoke, three times {@link LAMP_FLOATS} numbers: functions of the state, the same for
   * every camera.
   * @param blend elapsed share of the step, 0..1
   * @param colors light of a puff of radius 1 m at each of {@link GLOW_HEATS} + 1 temperatures from 0 to 1: linear red, green
   * and blue, and their luminance
   */
  glow(blend: number, colors: Float32Array): Float32Array {
    return this.#attempt(() => this.#handle.glow(blend, colors));
  }

  /** Displacement in the latest step of each row of the last {@link arrange}, metres: x, y, z. */
  moves(): Float32Array {
    return this.#attempt(() => this.#handle.moves());
  }

  /**
   * Poses of all rigids, interpolated between the previous step (0) and the latest (1), in the order they were added.
   *
   * @param target Receives the poses if it is large enough; otherwise a new array is allocated.
   * @returns Seven floats per rigid: x, y, z in metres and the unit quaternion x, y, z, w.
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

  /** Number of rigids added so far. */
  get rigidCount(): number {
    return this.#attempt(() => this.#handle.rigidCount);
  }

  /** Number of live particles. */
  get alive(): number {
    return this.#attempt(() => this.#handle.alive);
  }

  /** Number of live vortex particles, at most 1,024. Shedders spawn them. */
  get vortexParticles(): number {
    return this.#attempt(() => this.#handle.vortexParticles);
  }

  /** Number of particles whose spawn is deferred because the capacity is reached. */
  get waiting(): number {
    return this.#attempt(() => this.#handle.waiting);
  }

  /** Number of steps since creation. */
  get steps(): number {
    return this.#attempt(() => this.#handle.steps);
  }

  /** Hash of the whole state, 16 hexadecimal digits. Equal states have equal hashes on every machine. */
  hash(): string {
    return this.#attempt(() => this.#handle.hash());
  }

  /**
   * Serialises the whole state for {@link restore}.
   *
   * @param values The values of the table, of which the colours and the ink of looks are saved, as those of other emitters.
   * Without them, the state is for this thread.
   */
  save(values?: AnyValues): Uint8Array {
    const state = this.#attempt(() => this.#handle.save());
    return values && this.hasLooks ? withSavedLooks(state, this.#styles, values) : state;
  }

  /**
   * Restores a saved state. Invalid bytes are rejected and change nothing.
   *
   * @param obstacles Whether with its rigids and its colliders outside the parameter table.
   */
  restore(bytes: Uint8Array, obstacles = true): void {
    const { state, meta } = splitState(bytes);
    this.#attempt(() => this.#handle.restore(state, obstacles));
    this.addStyles(numbersOfStyles(meta.styles));
  }

  /**
   * Starts recording a take. It logs every {@link inputValues}, {@link inputCapacity}, {@link inputPose},
   * {@link inputDrag}, {@link inputRelease}, {@link inputSteer}, {@link inputBlow}, {@link inputClear} and
   * {@link inputEmission} with its step. Inputs take effect in the next step, quantised as in the log.
   */
  record(): void {
    this.#attempt(() => this.#handle.record());
  }

  /** {@link set} as a recorded input. */
  inputValues(values: Readonly<Record<string, number>>): void {
    const [keys, numbers] = linesAndNumbers(values);
    this.#attempt(() => this.#handle.inputValues(keys, numbers));
  }

  /** {@link resize} as a recorded input. */
  inputCapacity(capacity: number): void {
    requireWhole('simulation.maxParticles', capacity);
    this.#attempt(() => this.#handle.inputCapacity(capacity));
  }

  /** {@link moveRigid} as a recorded input. Positions are rounded to the millimetre. */
  inputPose(rigid: number, position: ArrayLike<number>, rotation?: ArrayLike<number>): void {
    requireWhole('rigid.index', rigid);
    const pose = Float64Array.of(...poseNumbers(position, rotation));
    this.#attempt(() => this.#handle.inputPose(rigid, pose));
  }

  /** {@link dragRigid} as a recorded input. Positions are rounded to the millimetre, stiffness to 0.1 1/s. */
  inputDrag(rigid: number, anchor: ArrayLike<number>, target: ArrayLike<number>, stiffness = 30): void {
    requireWhole('rigid.index', rigid);
    const numbers = Float64Array.of(anchor[0], anchor[1], anchor[2], target[0], target[1], target[2], stiffness);
    this.#attempt(() => this.#handle.inputDrag(rigid, numbers));
  }

  /** {@link releaseRigid} as a recorded input. */
  inputRelease(rigid: number): void {
    requireWhole('rigid.index', rigid);
    this.#attempt(() => this.#handle.inputRelease(rigid));
  }

  /** Sets steering channel 0 to 7 to a value from -1 to 1, as a recorded input. Scenes read it with {@link control}. */
  inputSteer(channel: number, value: number): void {
    requireWhole('steer.channel', channel);
    this.#attempt(() => this.#handle.inputSteer(channel, value));
  }

  /**
   * Starts a gust of air, as a recorded input. Of several blows between two steps only the last takes effect. At most
   * 16 are active at once.
   */
  inputBlow(blow: Blow): void {
    this.#attempt(() => this.#handle.inputBlow(blowNumbers(blow)));
  }

  /** Removes all particles and the births that wait, as a recorded input. Emitters, rigids and parameters stay. */
  inputClear(): void {
    this.#attempt(() => this.#handle.inputClear());
  }

  /**
   * Starts an emission in a free place of the pool, or changes one, as a recorded input.
   *
   * @param numbers As of {@link setEmitter}, NaN to keep those of the one that is changed. The envelope starts that long
   * after the next step.
   * @param emission Number of the one to change.
   * @returns Its number; -1 if all places are taken, or if the one to change is over.
   */
  inputEmission(numbers: Float64Array, emission = -1): number {
    const found = this.#attempt(() => this.#handle.inputEmission(numbers, emission));
    this.#noteStyle(numbers);
    return found;
  }

  /** Value of a steering channel, -1 to 1. Returns 0 for an unset or unknown channel. */
  control(channel: number): number {
    return this.#attempt(() => this.#handle.control(channel));
  }

  /**
   * Serialises the take recorded so far.
   *
   * @param note Opaque text stored with the take, at most 64 KiB of UTF-8.
   */
  take(note = ''): Uint8Array {
    return this.#attempt(() => this.#handle.take(note));
  }

  /**
   * Goes to the start of a take. The following steps apply its inputs until a new input replaces them. The simulator
   * must be recording and must have the scene of the take. A damaged take or one of another scene is rejected and
   * changes nothing.
   */
  replay(take: Uint8Array): void {
    this.#attempt(() => this.#handle.replay(take));
  }

  /**
   * Seeks within the take that is being recorded or replayed. The following steps apply the inputs after that moment.
   *
   * @param state Result of {@link save} at that moment, before the inputs of its step; the start of the take if
   * omitted.
   */
  rewind(state?: Uint8Array): void {
    const saved = state && splitState(state);
    this.#attempt(() => this.#handle.rewind(saved?.state));
    this.addStyles(numbersOfStyles(saved?.meta.styles));
  }

  /** Number of inputs of the take applied so far. */
  get inputsDone(): number {
    return this.#attempt(() => this.#handle.inputsDone);
  }

  /** Number of inputs in the take, at most 20,000. */
  get inputCount(): number {
    return this.#attempt(() => this.#handle.inputCount);
  }

  /** Whether the take was full when inputs arrived. Those inputs took effect, but a replay lacks them. */
  get isTruncated(): boolean {
    return this.#attempt(() => this.#handle.isTruncated);
  }

  /** Step count at the end of the take. */
  get takeEnd(): number {
    return this.#attempt(() => this.#handle.takeEnd);
  }

  /** Maximum number of live particles. */
  get capacity(): number {
    return this.#attempt(() => this.#handle.capacity);
  }

  /** Random seed. */
  get seed(): number {
    return this.#attempt(() => this.#handle.seed);
  }

  /** All current parameters by key. */
  parameters(): Map<string, number> {
    const numbers = this.#attempt(() => this.#handle.parameterValues());
    const keys = this.#attempt(() => this.#handle.parameterKeys()).split('\n');
    return new Map(keys.map((key, index) => [key, numbers[index]]));
  }

  /** Stops the simulator as an internal fault would, so that applications can test their error handling. */
  provokeFault(reason: string): void {
    this.#attempt(() => this.#module.bindings.provokeFault(reason));
  }

  /** Frees the WASM memory. Safe to call repeatedly and after a fault. */
  dispose(): void {
    // After a fault the handle may still be borrowed, and freeing it would throw. Its memory leaks instead.
    if (this.#stopped === undefined) this.#handle.free();
    this.#stopped ??= 'The simulator was disposed.';
  }

  /** @param numbers of an emitter, of which the last one is the style of its look, NaN if it does not change */
  #noteStyle(numbers: Float64Array): void {
    const style = numbers[numbers.length - 1];
    if (style >= FIRST_NUMBER && !this.#styles.delete(style) && this.#styles.size === MOST_STYLES)
      this.#styles.delete(this.#styles.values().next().value!);
    if (style >= FIRST_NUMBER) this.#styles.add(style);
  }

  #attempt<Result>(action: () => Result): Result {
    this.#requireRunning();
    try {
      return action();
    } catch (error) {
      throw this.#explain(error);
    }
  }

  #requireRunning(): void {
    if (this.#stopped !== undefined) throw new SimulatorError(`${this.#stopped} Create a new one.`);
  }

  #explain(error: unknown): Error {
    if (isSimulatorRejection(error)) return errorOfSimulator(error);
    if (!(error instanceof WebAssembly.RuntimeError)) {
      return new SimulatorError(`The simulator rejected a call: ${String(error)}`, { cause: error });
    }
    this.#stopped = 'The simulator has stopped after a fault.';
    const fault = this.#module.bindings.lastFault() || error.message;
    return new SimulatorError(`The simulator has stopped after a fault: ${fault}. Create a new one.`, { cause: error });
  }
}
