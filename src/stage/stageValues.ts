import { ParameterError } from '../base/errors.ts';
import type { Values } from '../parameters/parameter.ts';
import { differing, requireOptional, validate } from '../parameters/values.ts';
import type { Picture } from './picture.ts';
import type { Simulation } from './simulation.ts';

/** What follows the values. */
interface Followers {
  readonly simulation: Simulation;
  readonly picture: Picture;
  /** Applies a change and redraws, unless the next frame does. */
  show(change: () => void): void;
  /** Called after the picture follows new values. */
  announce(): void;
}

/**
 * The values of a stage, by flat key. Optional parameters appear only when they are set. Changes go to the simulation,
 * which records them, and to the picture; those that a take replays come from the simulation.
 */
export class StageValues {
  private readonly followers: Followers;
  private now: Values;

  constructor(values: Values, followers: Followers) {
    this.now = values;
    this.followers = followers;
  }

  get all(): Values {
    return this.now;
  }

  /** See `Stage.set`. @throws ParameterError for an invalid value or another scene; nothing changes then */
  set(changed: Values): void {
    this.requireChangeable(changed);
    this.change({ ...this.now, ...changed });
  }

  /** See `Stage.replace`. @throws ParameterError as `set`, and for a missing value that is not optional */
  replace(after: Values): void {
    this.requireChangeable(after);
    this.without(after).forEach(requireOptional);
    this.change(after);
  }

  /** See `Stage.unset`. @throws ParameterError for a key that is not optional */
  unset(keys: readonly string[]): void {
    keys.forEach(requireOptional);
    const { simulation } = this.followers;
    const kept = Object.fromEntries(Object.entries(this.now).filter(([key]) => !keys.includes(key)));
    simulation.set(simulation.unsetValues(keys), kept);
    this.followers.show(() => this.adoptValues(kept));
  }

  /** Applies values that the simulator already has. */
  adoptValues(values: Values): void {
    this.now = values;
    this.followers.picture.setValues(values);
    this.followers.announce();
  }

  /** Applies values that the log of a take changed since the last call. */
  applyLog(): void {
    const { simulation } = this.followers;
    if (simulation.hasAppliedInputs()) this.adoptValues(simulation.valuesIn(this.now));
  }

  /** Takes over the camera that the user has moved. The picture has it already. */
  adoptCamera(): void {
    this.now = { ...this.now, ...this.followers.picture.eye.held };
  }

  private change(after: Values): void {
    const { simulation } = this.followers;
    const before = this.now;
    // At once, because the simulator may reject them: at most 15 looks.
    simulation.set({ ...simulation.unsetValues(this.without(after)), ...differing(before, after) }, after);
    const capacity = after['simulation.maxParticles'] as number;
    if (capacity !== before['simulation.maxParticles']) {
      simulation.input((simulator) => simulator.inputCapacity(capacity));
    }
    if (after.seed !== before.seed) simulation.restart(after);
    this.followers.show(() => this.adoptValues(after));
  }

  private without(after: Values): string[] {
    return Object.keys(this.now).filter((key) => !(key in after));
  }

  private requireChangeable(values: Values): void {
    validate(values);
    const { scene } = this.now;
    if ((values.scene ?? scene) !== scene)
      throw new ParameterError('scene', values.scene, `${scene} (or call enter())`);
  }
}
