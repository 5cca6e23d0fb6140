import { Matrix4, type Vector3 } from 'three';
import { ParameterError, SimulatorError } from '../base/errors.ts';
import type { AnyValues, Value, Values } from '../parameters/parameter.ts';
import { LOOK_STYLE } from '../parameters/lists.ts';
import { findParameter } from '../parameters/table.ts';
import { loaded } from '../renderer/extraPasses.ts';
import type { Dropped } from '../scenes/dropped.ts';
import type { Scene } from '../scenes/scene.ts';
import type { Animation } from '../simulator/animation.ts';
import { secondsAt, STEP_SECONDS } from '../simulator/clock.ts';
import {
  changeNumbers,
  EMISSION_LIMIT,
  emissionNumbers,
  type EmissionChange,
  type EmissionOptions,
} from '../simulator/emitterOptions.ts';
import type { SimulatorFactory } from '../simulator/load.ts';
import { stylesOf } from '../simulator/lookStyles.ts';
import { PlainLog } from '../simulator/plainLog.ts';
import { savedLooks } from '../simulator/savedState.ts';
import { hasRareForces } from '../simulator/rareForces.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { namingLook } from '../simulator/simulatorError.ts';
import { rigValues, simulatorValues, valuesIn } from '../simulator/simulatorValues.ts';
import { placedParts, placementIn, put, sceneStateOf } from './scenePoses.ts';
import { SavedStates } from './states.ts';
import { isLook, noteOf, readNote, stylesIn, takeOf, type Note, type Take } from './take.ts';

/** What moves a rigid between steps. */
export interface Mover {
  /** Called before each step. */
  beforeStep(): void;
  /** Called after the simulator took another state. */
  reset(): void;
}

/** A scene's simulator with its saved states. */
export class Simulation {
  /** Milliseconds per step in the latest batch. */
  stepMs = 0;
  /** Replaced on each restart. */
  simulator: Simulator;
  /** The values at the start of the current take, recorded or replayed. */
  startValues: Values;
  mover: Mover | undefined;
  /** What happens to the values over time. Undefined if nothing does, and until its code is loaded. */
  animation: Animation | undefined;
  /** Changes by people while there is no animation. */
  private log = new PlainLog();
  /** The log of the take that is replayed. */
  private replayed: Note | undefined;
  readonly scene: Scene;
  /** World transforms of the rigids by index, as last read by `rigids`. */
  readonly matrices: readonly Matrix4[];
  /** Optional parameters that the scene sets. */
  readonly rig: AnyValues;
  /** Whether the timeline has rare forces. */
  private hasRareTimeline = false;
  /** Whether the code of forces could not be loaded: the smoke goes on without them. */
  goesWithoutForces = false;
  private factory: SimulatorFactory;
  private readonly states: SavedStates;
  private inputsSeen = 0;
  /** Whether the timeline of the past has changed, so that the state is not that of the take. */
  private isStale = false;
  private readonly dropped: Dropped | undefined;

  /** @param historyBytes memory budget for saved states, 64 MiB by default */
  constructor(factory: SimulatorFactory, scene: Scene, values: Values, historyBytes?: number) {
    this.factory = factory;
    this.scene = scene;
    this.rig = rigValues(scene.rig);
    this.matrices = scene.rigids.map(() => new Matrix4());
    this.dropped = scene.createDropped?.();
    this.states = new SavedStates(historyBytes);
    this.simulator = this.create(values);
    this.startValues = values;
    this.play(values.timeline);
  }

  /** Bytes of the saved states. */
  get historyBytes(): number {
    return this.states.bytes;
  }

  /** Restarts from the first step and starts a new take. */
  restart(values: Values): void {
    this.replace(this.create(values), values);
  }

  /** The inputs since the start, with the values at the start as the note. @param hasLook whether with changes of the look */
  take(hasLook = true): Uint8Array {
    const { animation, log, replayed, simulator } = this;
    const changes = animation ? animation.log.pack(hasLook) : hasLook ? (replayed?.changes ?? log.packed) : undefined;
    const { isTruncated } = animation?.log ?? replayed ?? log;
    return simulator.take(
      noteOf({ values: this.startValues, changes, isTruncated, looks: stylesOf(simulator.styles) }),
    );
  }

  /** @throws SimulatorError for bytes that are damaged or no take */
  readTake(bytes: Uint8Array): Take {
    return takeOf(bytes, this.factory.readTake(bytes));
  }

  /**
   * Goes to the start of a take.
   * @returns the values there
   * @throws SimulatorError when the take is damaged or of another scene; the simulation is unchanged then
   */
  playTake(take: Uint8Array): Values {
    const note = readNote(this.factory.readTake(take).note);
    const { values } = note;
    const { name } = this.scene;
    if (values.scene !== name) throw new SimulatorError(`The take is for the scene ${values.scene}, not ${name}.`);
    this.replay(take, values, note);
    return this.valuesIn(values);
  }

  /**
   * Goes to the start of a take of this scene.
   * @param note what the take changes beside the simulator; nothing by default
   * @throws SimulatorError when it is damaged; nothing changes then
   */
  replay(take: Uint8Array, values: Values, note?: Note): void {
    const next = this.create(values);
    try {
      next.replay(take);
      next.addStyles(stylesIn(this.factory.readTake(take).note));
    } catch (error) {
      next.dispose();
      throw error;
    }
    this.replace(next, values, note);
  }

  /** Restores a saved state and starts a new take. */
  restore(bytes: Uint8Array, values: Values): Values {
    this.simulator.restore(bytes);
    this.states.clear();
    this.isStale = false;
    this.log = new PlainLog();
    this.replayed = undefined;
    this.animation?.restore(bytes, values);
    this.startValues = this.valuesIn({ ...values, ...savedLooks(bytes) });
    this.reset();
    return this.startValues;
  }

  /** Goes to a saved state of the current take. The following steps replay the inputs after it. */
  rewind(state: Uint8Array): void {
    this.simulator.rewind(state);
    this.reset();
  }

  /** The state, with the colours and the ink of looks, and what people hold of the timeline. @param values of the table */
  save(values: Values): Uint8Array {
    const { steps } = this.simulator;
    const state = this.simulator.save(values);
    return this.animation?.saved(state, steps) ?? state;
  }

  /** Whether values change over time, by a timeline or by the take that is replayed. */
  get isAnimated(): boolean {
    return (this.startValues.timeline ?? '') !== '' || this.replayed !== undefined;
  }

  /**
   * Plays a timeline from now on, as soon as its code is loaded. If it drives the past differently, the next seek simulates
   * that anew.
   */
  play(timeline = ''): void {
    this.startValues = { ...this.startValues, timeline };
    this.hasRareTimeline = hasRareForces({ timeline });
    const code = loaded.animation;
    const { log, replayed } = this;
    if (code && this.isAnimated) {
      this.animation ??= new code.Animation(replayed?.changes ?? log.packed, replayed !== undefined);
      this.animation.log.isTruncated ||= (replayed ?? log).isTruncated === true;
    }
    const from = this.animation?.play(timeline) ?? Infinity;
    this.states.dropFrom(from + 1);
    this.isStale ||= this.simulator.steps > from;
  }

  /**
   * Records changes of values by a person that the simulator does not record.
   * @param changes null for what follows the scene again
   * @param time drawn, in steps
   */
  record(changes: Readonly<Record<string, Value | null>>, time: number): void {
    const { animation, log, simulator } = this;
    if (animation) return animation.record(changes, { steps: simulator.steps, time });
    for (const key of Object.keys(changes).filter(isLook)) log.add(Math.floor(time + 1e-6), key, changes[key]);
  }

  /** `values`, with the simulator's current values for every parameter that it reads. */
  valuesIn(values: Values): Values {
    const { animation, simulator } = this;
    const { rig, rule } = this.scene;
    const after: AnyValues = valuesIn(simulator, values, rig);
    const isDriven = (key: string) => animation?.isDriven(key, simulator.steps);
    const isKept = (key: string) => key in values || !(rule?.keys.includes(key) || isDriven(key));
    const keys = Object.keys(after).filter(isKept);
    return Object.fromEntries(keys.map((key) => [key, (isDriven(key) ? (values as AnyValues) : after)[key]]));
  }

  /**
   * Passes the simulator its share of `changed`.
   * @param all values after the change
   */
  set(changed: Values, all = changed): void {
    const inputs = simulatorValues(changed, all);
    // Other colours of a look that has some are no input, which would end the replay of a take.
    for (const key in inputs) if (key.endsWith(LOOK_STYLE) && this.has(key, inputs[key])) delete inputs[key];
    if (Object.keys(inputs).length > 0) this.input((simulator) => simulator.inputValues(inputs));
  }

  private has(key: string, number: number): boolean {
    return (this.simulator.parameters().get(key) ?? 0) === number;
  }

  /** What optional parameters have that are not set: what the scene sets, or their defaults. */
  unsetValues(keys: readonly string[]): Values {
    return Object.fromEntries(keys.map((key) => [key, this.rig[key] ?? findParameter(key)!.default]));
  }

  /** How many objects can be dropped; 0 in scenes without any. */
  get dropCount(): number {
    return this.dropped?.count ?? 0;
  }

  /**
   * Drops an object at a position, in metres: the one farthest away. Unused objects are very far away.
   * @param held a rigid that is not dropped
   */
  drop(place: Vector3, held?: number): void {
    const { dropped } = this;
    if (!dropped) return;
    const from = dropped.above(place);
    const rigid = dropped.next(from, this.simulator.rigidPoses(1), held);
    if (rigid === undefined) return;
    this.input((simulator) => simulator.inputPose(rigid, from.toArray(), dropped.tumbled));
    dropped.put(rigid, from);
  }

  /** Applies a user input. If a take is being replayed, the rest of it is discarded. */
  input<Result>(act: (simulator: Simulator) => Result): Result {
    const result = act(this.simulator);
    this.states.dropFrom(this.simulator.steps);
    this.inputsSeen = this.simulator.inputsDone;
    return result;
  }

  /**
   * Starts an emission.
   * @returns its number
   * @throws ParameterError for an invalid option, or when there are too many emissions or looks
   */
  emit(options: EmissionOptions): number {
    const numbers = emissionNumbers(options);
    const emission = namingLook('emit', () => this.input((simulator) => simulator.inputEmission(numbers)));
    if (emission >= 0) return emission;
    throw new ParameterError('emit', EMISSION_LIMIT + 1, `at most ${EMISSION_LIMIT} emissions at a time`);
  }

  /** Changes an emission unless it is over. @throws ParameterError for an invalid option */
  changeEmission(emission: number, options: EmissionChange): void {
    const numbers = changeNumbers(options);
    namingLook('changeEmission', () => this.input((simulator) => simulator.inputEmission(numbers, emission)));
  }

  /** Whether the log of a take has applied or undone inputs since the last call. */
  hasAppliedInputs(): boolean {
    const { inputsDone } = this.simulator;
    const hasFollowed = inputsDone !== this.inputsSeen;
    this.inputsSeen = inputsDone;
    return hasFollowed;
  }

  /** Whether it waits for the code of forces, and takes no steps. */
  get isWaiting(): boolean {
    return this.lacksForces && !loaded.rareForces && !this.goesWithoutForces;
  }

  /** Whether its simulator must move to a larger variant before the next step. */
  get lacksForces(): boolean {
    const { simulator } = this;
    return simulator.lacksForces || (this.hasRareTimeline && !simulator.hasRigids);
  }

  /**
   * @param onStep called after each step
   * @returns the number of steps that are left because it waits
   */
  advance(steps: number, onStep?: () => void): number {
    if (steps === 0) return 0;
    const started = performance.now();
    for (let taken = 0; taken < steps; ++taken) {
      if (this.isWaiting) return steps - taken;
      if (this.lacksForces && loaded.rareForces) this.enlarge(loaded.rareForces);
      this.mover?.beforeStep();
      this.dropped?.clear();
      this.guide();
      this.animation?.prepare(this.simulator, { isWhole: this.scene.rule !== undefined });
      this.sendParts();
      this.simulator.step();
      this.states.keep(this.simulator);
      onStep?.();
    }
    this.stepMs = (performance.now() - started) / steps;
    return 0;
  }

  /** Steps for some milliseconds, up to a goal, unless it waits. */
  advanceFor(milliseconds: number, goal: number): void {
    const until = performance.now() + milliseconds;
    while (this.simulator.steps < goal && performance.now() < until) if (this.advance(1) > 0) return;
  }

  /**
   * Rewinds to the state from which `goal` takes the fewest steps: a saved state, the start of the take, or the current
   * state.
   */
  approach(goal: number): void {
    const { steps } = this.simulator;
    if (goal < steps) (this.animation ?? this.log).rewind(goal);
    const state = this.states.latest(goal);
    if (!this.isStale && steps <= goal && (state?.step ?? 0) <= steps) return;
    this.simulator.rewind(state?.bytes);
    this.isStale = false;
    this.reset();
  }

  /** World transforms of the rigids by index, interpolated between the previous step (0) and the latest (1). */
  rigids(blend: number): readonly Matrix4[] {
    const poses = this.simulator.rigidPoses(blend);
    this.matrices.forEach((matrix, rigid) => put(matrix, placementIn(poses, rigid)));
    const { dropped, matrices } = this;
    if (!dropped) return matrices;
    const { rotation } = dropped;
    for (const [rigid, place] of dropped.waiting) put(matrices[rigid], { position: place.toArray(), rotation });
    return matrices;
  }

  /** World transforms of the scene's parts by index, at the time of `rigids`. */
  parts(blend: number, rigids: readonly Matrix4[]): readonly Matrix4[] {
    return placedParts(this.scene, secondsAt(this.simulator.steps, blend)).map(({ rigid, ...own }) => {
      const matrix = put(new Matrix4(), own);
      return rigid === undefined ? matrix : matrix.premultiply(rigids[rigid]);
    });
  }

  dispose(): void {
    this.simulator.dispose();
  }

  /** Continues from the same state, within the same take, in a larger variant. */
  private enlarge(factory: SimulatorFactory): void {
    const { simulator } = this;
    this.factory = factory;
    const next = this.create(this.startValues);
    next.replay(simulator.take(''));
    next.rewind(simulator.save());
    next.addStyles([...simulator.styles]);
    simulator.dispose();
    this.simulator = next;
  }

  private create(values: Values): Simulator {
    const capacity = values['simulation.maxParticles'] as number;
    const simulator = this.factory.create({ capacity, seed: values.seed as number });
    simulator.set({ ...this.scene.rig, ...simulatorValues(values) });
    for (const { positions, indices } of this.scene.emissionSurfaces ?? []) simulator.addSurface(positions, indices);
    for (const rigid of this.scene.rigids) simulator.addRigid(rigid);
    simulator.record();
    return simulator;
  }

  private replace(next: Simulator, values: Values, note?: Note): void {
    this.simulator.dispose();
    this.simulator = next;
    this.states.clear();
    this.log = new PlainLog();
    this.replayed = note?.changes && note;
    this.animation = undefined;
    this.startValues = values;
    this.play(values.timeline);
    this.isStale = false;
    this.reset();
  }

  /** Runs the scene's guide and rule for the next step. Neither is recorded as an input. */
  private guide(): void {
    const { guide, rule } = this.scene;
    if (!guide && !rule) return;
    const sceneState = sceneStateOf(this.simulator);
    for (const { rigid, position, rotation } of guide?.(sceneState) ?? []) {
      this.simulator.moveRigid(rigid, position, rotation);
    }
    if (rule) this.simulator.set(rule.values(sceneState));
  }

  /**
   * Sends the parts' poses of the next step. The simulator composes them with its rigids, because three.js results can
   * differ in the last bit between JavaScript engines.
   */
  private sendParts(): void {
    if (!this.scene.parts) return;
    const { steps } = this.simulator;
    const numbers = [steps, steps + 1].flatMap((step) =>
      placedParts(this.scene, step * STEP_SECONDS).flatMap(({ rigid = -1, position, rotation }) => [
        rigid,
        ...position,
        ...rotation,
      ]),
    );
    this.simulator.placeParts(numbers);
  }

  private reset(): void {
    this.animation?.reset();
    this.dropped?.clear();
    this.mover?.reset();
  }
}
