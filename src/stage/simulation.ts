import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Values } from '../preset/parameter.ts';
import { findParameter } from '../preset/table.ts';
import type { MovingSceneState, MovingPart, Placement, Scene } from '../scenes/scene.ts';
import { secondsAt, STEP_SECONDS } from '../sim/clock.ts';
import type { SimulatorFactory } from '../sim/load.ts';
import { POSE_FLOATS } from '../sim/rows.ts';
import type { Simulator } from '../sim/simulator.ts';
import { ALL_THAT_LIVES } from '../sim/view.ts';
import { Drag } from './drag.ts';
import { Dropped, TUMBLED } from './dropped.ts';
import { simulatorValues, valueOf, valuesIn } from '../sim/simulatorValues.ts';
import { SavedStates } from './states.ts';

const UNSCALED = new Vector3(1, 1, 1);
/** A state is kept each second: saving one costs about as much as two steps. */
const STEPS_BETWEEN_STATES = 60;
/** After so many steps the spring has brought the rigid to where it was let go, but for a 10,000th of the way. */
const SETTLING_STEPS = 30;

/** A scene's simulator, set up from its rig and the values, with its past and the rigid that people move. */
export class Simulation {
  /** Milliseconds of the latest step. */
  stepMs = 0;
  drag: Drag | undefined;
  /** What the scene sets of the optional parameters. */
  readonly rig: Values;
  private readonly factory: SimulatorFactory;
  private readonly scene: Scene;
  private readonly matrices: Matrix4[];
  private readonly states: SavedStates;
  private current: Simulator;
  private start: Values;
  private inputsSeen = 0;
  private readonly dropped: Dropped;
  /** Steps after which the spring lets go of the rigid that people move: undefined while it does not hold it. */
  private heldUntil: number | undefined;
  private heldFrom = 0;

  /** @param historyBytes how much memory states may take that are kept for going back */
  constructor(factory: SimulatorFactory, scene: Scene, values: Values, historyBytes: number) {
    this.factory = factory;
    this.scene = scene;
    this.rig = rigValues(scene);
    this.matrices = scene.rigids.map(() => new Matrix4());
    this.dropped = new Dropped(scene);
    this.states = new SavedStates(historyBytes);
    this.current = this.create(values);
    this.start = values;
    this.resetDrag();
  }

  /** Another one after each restart. */
  get simulator(): Simulator {
    return this.current;
  }

  /** The values with which the take began that is being recorded or replayed. */
  get startValues(): Values {
    return this.start;
  }

  /** Bytes of the states that are kept for going back. */
  get historyBytes(): number {
    return this.states.bytes;
  }

  /** Begins again from the first step, and a new take with it. */
  restart(values: Values): void {
    this.replace(this.create(values), values);
  }

  /**
   * Goes to the start of a take that was made in this scene.
   * @throws SimulatorError when the take is damaged; nothing has changed then
   */
  replay(take: Uint8Array, values: Values): void {
    const next = this.create(values);
    try {
      next.replay(take);
    } catch (error) {
      next.dispose();
      throw error;
    }
    this.replace(next, values);
  }

  /** Takes up a saved state, with which a new take begins. */
  restore(bytes: Uint8Array, values: Values): Values {
    this.current.restore(bytes);
    this.states.clear();
    this.start = this.valuesIn(values);
    this.resetDrag();
    return this.start;
  }

  /** `values` with all that the simulator reads as it is now. */
  valuesIn(values: Values): Values {
    const { rig, rule } = this.scene;
    const after = valuesIn(this.current, values, rig);
    return Object.fromEntries(Object.entries(after).filter(([key]) => key in values || !rule?.keys.includes(key)));
  }

  /** Hands on what the simulator reads of `changed`. */
  set(changed: Values): void {
    const inputs = simulatorValues(changed);
    if (Object.keys(inputs).length > 0) this.input((simulator) => simulator.inputValues(inputs));
  }

  /** Lets optional parameters go back to what the scene has, or to their defaults. */
  unset(keys: readonly string[]): void {
    this.set(Object.fromEntries(keys.map((key) => [key, this.rig[key] ?? findParameter(key)!.default])));
  }

  /** Draws the rigid that people move to where they want it, by a spring, or tells the scene's guide where that is. */
  dragHandle(): void {
    const { drag } = this;
    if (!drag) return;
    if (this.scene.handle!.steers) return this.steerHandle(drag);
    const [anchor, grip] = [drag.anchor.toArray(), drag.grip.toArray()];
    this.input((simulator) => simulator.inputDrag(this.scene.handle!.rigid, anchor, grip));
    if (this.heldUntil !== Infinity) this.heldFrom = this.current.steps;
    this.heldUntil = Infinity;
  }

  /** Whether a guide takes the rigid that people move to where they want it, which takes its time. */
  get isSteered(): boolean {
    return this.scene.handle?.steers !== undefined;
  }

  /**
   * Lets go of it as soon as it has come to where it was drawn: let go in a pause, it could not come there otherwise. What
   * falls when it is let go is let go at once unless it has not moved yet, so that people can throw it.
   */
  releaseHandle(): void {
    const { steps } = this.current;
    const isThrown = this.scene.rigids[this.scene.handle!.rigid].kind === 'dynamic' && steps > this.heldFrom;
    if (this.heldUntil === Infinity) this.heldUntil = steps + (isThrown ? 0 : SETTLING_STEPS);
  }

  /** How many things can be dropped; 0 where there is nothing. */
  get dropCount(): number {
    return this.dropped.count;
  }

  /** Lets a thing fall from a place, metres: the free one that is farthest from there. Those that wait are very far. */
  drop(place: Vector3): void {
    const from = this.dropped.above(place);
    const held = this.heldUntil === undefined ? undefined : this.scene.handle!.rigid;
    const rigid = this.dropped.next(from, this.current.rigidPoses(1), held);
    if (rigid === undefined) return;
    this.input((simulator) => simulator.inputPose(rigid, from.toArray(), TUMBLED));
    this.dropped.put(rigid, from);
  }

  /** Does something that people did. If a take was being replayed, its rest is dropped. */
  input(act: (simulator: Simulator) => void): void {
    act(this.current);
    this.states.dropFrom(this.current.steps);
    this.inputsSeen = this.current.inputsDone;
  }

  /** Whether the log of a take has done or undone something since this was last asked. */
  hasFollowed(): boolean {
    const { inputsDone } = this.current;
    const hasFollowed = inputsDone !== this.inputsSeen;
    this.inputsSeen = inputsDone;
    return hasFollowed;
  }

  /** @param onStep called after each of the steps */
  advance(steps: number, onStep?: () => void): void {
    if (steps === 0) return;
    const started = performance.now();
    for (let taken = 0; taken < steps; ++taken) {
      this.letGoWhenSettled();
      this.dropped.clear();
      this.guide();
      this.sendParts();
      this.current.step();
      this.keepState();
      onStep?.();
    }
    this.stepMs = (performance.now() - started) / steps;
  }

  /** Steps for some milliseconds, but not beyond a goal. */
  advanceFor(milliseconds: number, goal: number): void {
    const until = performance.now() + milliseconds;
    while (this.current.steps < goal && performance.now() < until) this.advance(1);
  }

  /** Goes to the moment from which the fewest steps lead to `goal`: a kept state, the start of the take, or where it is. */
  approach(goal: number): void {
    const { steps } = this.current;
    const state = this.states.latest(goal);
    if (steps <= goal && (state?.step ?? 0) <= steps) return;
    this.current.rewind(state?.bytes);
    this.resetDrag();
  }

  /** One more than the highest variation that a living particle has; 0 where none lives. */
  variationsAlive(): number {
    const { count, attributes } = this.current.arrange({ ...ALL_THAT_LIVES, blend: 1 });
    let variations = 0;
    for (let row = 0; row < count; row++) variations = Math.max(variations, 1 + (attributes[2 * row + 1] & 0xff));
    return variations;
  }

  /** World transforms of the rigids, by their number, between the previous step (0) and now (1). */
  rigids(blend: number): readonly Matrix4[] {
    const poses = this.current.rigidPoses(blend);
    this.matrices.forEach((matrix, rigid) => put(matrix, placementIn(poses, rigid)));
    this.dropped.show(this.matrices);
    return this.matrices;
  }

  /** World transforms of the scene's parts, by their number, at the moment of `rigids`. */
  parts(blend: number, rigids: readonly Matrix4[]): readonly Matrix4[] {
    return this.placedParts(secondsAt(this.current.steps, blend)).map(({ rigid, ...own }) => {
      const matrix = put(new Matrix4(), own);
      return rigid === undefined ? matrix : matrix.premultiply(rigids[rigid]);
    });
  }

  /** The transform with which the rigid that people move was drawn. */
  handleTransform(): Matrix4 {
    return this.matrices[this.scene.handle!.rigid];
  }

  dispose(): void {
    this.current.dispose();
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

  private replace(next: Simulator, values: Values): void {
    this.current.dispose();
    this.current = next;
    this.start = values;
    this.states.clear();
    this.resetDrag();
  }

  /** Tells rigids where the scene wants them, and sets what follows from their ways. What is asked for so is no input. */
  private guide(): void {
    const { guide, rule } = this.scene;
    if (!guide && !rule) return;
    const sceneState = this.sceneState();
    for (const { rigid, position, rotation } of guide?.(sceneState) ?? []) {
      this.current.moveRigid(rigid, position, rotation);
    }
    if (rule) this.current.set(rule.values(sceneState));
  }

  /**
   * Tells where the parts are in the coming step. The numbers go as the scene has them, and the simulator composes them
   * with its rigids: what three.js computes may differ in the last bit from engine to engine.
   */
  private sendParts(): void {
    if (!this.scene.parts) return;
    const { steps } = this.current;
    const numbers = [steps, steps + 1].flatMap((step) =>
      this.placedParts(step * STEP_SECONDS).flatMap(({ rigid = -1, position, rotation }) => [
        rigid,
        ...position,
        ...rotation,
      ]),
    );
    this.current.placeParts(numbers);
  }

  /** In the space of the rigids that carry them. */
  private placedParts(seconds: number): readonly (Placement & Pick<MovingPart, 'rigid'>)[] {
    return (this.scene.parts ?? []).map(({ rigid, pose }) => ({ rigid, ...pose(seconds) }));
  }

  private sceneState(): MovingSceneState {
    const { current } = this;
    const [then, now] = [current.rigidPoses(0), current.rigidPoses(1)];
    return {
      seconds: (current.steps + 1) * STEP_SECONDS,
      dt: STEP_SECONDS,
      control: (channel) => current.control(channel),
      pose: (rigid) => placementIn(now, rigid),
      before: (rigid) => placementIn(then, rigid),
    };
  }

  private steerHandle({ target }: Drag): void {
    const { min, max, steers } = this.scene.handle!;
    const place = target.toArray();
    steers!.forEach((channel, axis) => {
      const half = (max[axis] - min[axis]) / 2;
      if (half > 0) this.input((simulator) => simulator.inputSteer(channel, (place[axis] - min[axis]) / half - 1));
    });
  }

  private letGoWhenSettled(): void {
    if (this.heldUntil === undefined || this.current.steps < this.heldUntil) return;
    this.input((simulator) => simulator.inputRelease(this.scene.handle!.rigid));
    this.heldUntil = undefined;
  }

  /** A drag that begins where its rigid is. */
  private resetDrag(): void {
    const { handle } = this.scene;
    this.heldUntil = undefined;
    this.dropped.clear();
    if (!handle) return;
    this.drag = new Drag(handle);
    this.drag.target.fromArray(this.current.rigidPoses(1), POSE_FLOATS * handle.rigid);
  }

  private keepState(): void {
    const { steps } = this.current;
    if (steps % STEPS_BETWEEN_STATES !== 0 || this.states.has(steps)) return;
    this.states.add({ step: steps, bytes: this.current.save() });
  }
}

function put(matrix: Matrix4, { position, rotation }: Placement): Matrix4 {
  return matrix.compose(new Vector3(...position), new Quaternion(...rotation), UNSCALED);
}

function placementIn(poses: Float32Array, rigid: number): Placement {
  const [x, y, z, i, j, k, w] = poses.subarray(POSE_FLOATS * rigid);
  return { position: [x, y, z], rotation: [i, j, k, w] };
}

/** The scene's rig as the table has it: optional parameters only, choices by their names. */
function rigValues(scene: Scene): Values {
  const entries = Object.entries(scene.rig).map(([key, number]) => [key, findParameter(key), number] as const);
  return Object.fromEntries(
    entries.flatMap(([key, parameter, number]) => (parameter?.isOptional ? [[key, valueOf(parameter, number)]] : [])),
  );
}
