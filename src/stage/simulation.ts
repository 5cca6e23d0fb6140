import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Values } from '../preset/parameter.ts';
import { findParameter } from '../preset/table.ts';
import type { Scene } from '../scenes/scene.ts';
import type { SimulatorFactory } from '../sim/load.ts';
import { POSE_FLOATS } from '../sim/rows.ts';
import type { Simulator } from '../sim/simulator.ts';
import { Drag } from './drag.ts';
import { simulatorValues, valueOf } from './simulatorValues.ts';

const UNSCALED = new Vector3(1, 1, 1);

/** A scene's simulator, set up from its rig and the values, with the rigid that people move. */
export class Simulation {
  /** Milliseconds of the latest step. */
  stepMs = 0;
  drag: Drag | undefined;
  private readonly factory: SimulatorFactory;
  private readonly scene: Scene;
  private readonly matrices: Matrix4[];
  private current: Simulator;

  constructor(factory: SimulatorFactory, scene: Scene, values: Values) {
    this.factory = factory;
    this.scene = scene;
    this.matrices = scene.rigids.map(() => new Matrix4());
    this.current = this.create(values);
  }

  /** Another one after each restart. */
  get simulator(): Simulator {
    return this.current;
  }

  /** Begins again from the first step. */
  restart(values: Values): void {
    this.current.dispose();
    this.current = this.create(values);
  }

  /** Hands on what the simulator reads of `changed`. */
  set(changed: Values): void {
    this.current.set(simulatorValues(changed));
  }

  /** Lets optional parameters go back to what the scene has, or to their defaults. */
  unset(keys: readonly string[]): void {
    this.set(Object.fromEntries(keys.map((key) => [key, this.rig[key] ?? findParameter(key)!.default])));
  }

  /** What the scene sets of the optional parameters. */
  get rig(): Values {
    const entries = Object.entries(this.scene.rig).map(([key, number]) => [key, findParameter(key), number] as const);
    return Object.fromEntries(
      entries.flatMap(([key, parameter, number]) => (parameter?.isOptional ? [[key, valueOf(parameter, number)]] : [])),
    );
  }

  advance(steps: number): void {
    if (steps === 0) return;
    const started = performance.now();
    for (let taken = 0; taken < steps; ++taken) {
      if (this.drag) this.current.moveRigid(this.scene.handle!.rigid, this.drag.target.toArray());
      this.current.step();
    }
    this.stepMs = (performance.now() - started) / steps;
  }

  /** Steps for some milliseconds, but not beyond a goal. */
  advanceFor(milliseconds: number, goal: number): void {
    const until = performance.now() + milliseconds;
    while (this.current.steps < goal && performance.now() < until) this.advance(1);
  }

  /** World transforms of the rigids, by their number, between the previous step (0) and now (1). */
  rigids(blend: number): readonly Matrix4[] {
    const poses = this.current.rigidPoses(blend);
    const [place, turn] = [new Vector3(), new Quaternion()];
    this.matrices.forEach((matrix, rigid) => {
      const at = POSE_FLOATS * rigid;
      matrix.compose(place.fromArray(poses, at), turn.fromArray(poses, at + 3), UNSCALED);
    });
    return this.matrices;
  }

  /** Where the rigid that people move was drawn. */
  handlePlace(): Vector3 {
    return new Vector3().setFromMatrixPosition(this.matrices[this.scene.handle!.rigid]);
  }

  dispose(): void {
    this.current.dispose();
  }

  private create(values: Values): Simulator {
    const capacity = values['simulation.maxParticles'] as number;
    const simulator = this.factory.create({ capacity, seed: values.seed as number });
    simulator.set({ ...this.scene.rig, ...simulatorValues(values) });
    for (const rigid of this.scene.rigids) simulator.addRigid(rigid);
    this.drag = this.scene.handle && new Drag(this.scene.handle);
    return simulator;
  }
}
