import { ParameterError } from '../base/errors.ts';
import type { AnyValues, Values } from '../parameters/parameter.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { differing, requireOptional, validate } from '../parameters/values.ts';
import { timelineText } from '../renderer/extraPasses.ts';
import type { Picture } from './picture.ts';
import type { Simulation } from './simulation.ts';

/** What follows the values. */
interface Followers {
  readonly simulation: Simulation;
  readonly picture: Picture;
  /** The simulated time that is drawn, in steps. */
  readonly drawnTime: number;
  /** Applies a change and redraws, unless the next frame does. */
  show(change: () => void): void;
  /** Called after the picture follows new values. */
  announce(): void;
}

/**
 * The values of a stage, by flat key. Optional parameters appear only when they are set. Changes go to the simulation,
 * which records them, and to the picture; those that a take replays come from the simulation. A timeline replaces values in
 * the simulation and in the picture, but not here.
 */
export class StageValues {
  /** See `Stage.recordsKeyframes`. */
  recordsKeyframes = false;
  private readonly followers: Followers;
  private now: Values;
  private other: Values = {};

  constructor(values: Values, followers: Followers) {
    this.now = values;
    this.followers = followers;
  }

  get all(): Values {
    return this.now;
  }

  /** All values, those of the timeline as they are at the drawn time. */
  get shown(): Values {
    const { simulation, drawnTime } = this.followers;
    return { ...this.now, ...simulation.animation?.valuesAt(drawnTime) };
  }

  /** See `Stage.set`. @throws ParameterError for an invalid value or another scene; nothing changes then */
  set(given: GivenValues): void {
    const changed = this.requireChangeable(given);
    this.change({ ...this.now, ...changed }, changed);
  }

  /** See `Stage.replace`. @throws ParameterError as `set`, and for a missing value that is not optional */
  replace(given: GivenValues): void {
    const after = this.requireChangeable(given);
    this.without(after).forEach(requireOptional);
    this.change(after);
  }

  /** See `Stage.unset`. @throws ParameterError for a key that is not optional */
  unset(keys: readonly string[]): void {
    keys.forEach(requireOptional);
    const kept = Object.fromEntries(Object.entries(this.now).filter(([key]) => !keys.includes(key)));
    this.apply(keys, {}, kept);
    this.followers.show(() => this.adoptValues(kept));
  }

  /** Applies values that the simulator already has. */
  adoptValues(values: Values): void {
    this.now = values;
    this.followTimeline(true);
    this.followers.announce();
  }

  /** Applies values that the log of a take changed since the last call. */
  applyLog(): void {
    const { simulation, drawnTime } = this.followers;
    const { animation, startValues } = simulation;
    const after = simulation.hasAppliedInputs() ? simulation.valuesIn(this.now) : this.now;
    const values = animation?.followLog(after, startValues, drawnTime) ?? after;
    if (values !== this.now) this.adoptValues(values);
  }

  /** Takes over the camera that the user has moved. The picture has it already. @param before as `OrbitCamera.held` */
  adoptCamera(before: Values): void {
    const moved = differing(before, this.followers.picture.eye.held);
    const { after, changed } = this.changedBy({ ...this.now, ...moved }, moved);
    this.followers.simulation.record(changed, this.followers.drawnTime);
    this.now = after;
    this.playTimeline();
  }

  /** Plays the timeline of the values if it is another one, or if its code was missing. */
  playTimeline(): void {
    const { simulation } = this.followers;
    const { animation, isAnimated, startValues } = simulation;
    const { timeline } = this.now;
    if (timeline !== startValues.timeline || (isAnimated && !animation)) simulation.play(timeline);
  }

  /** Lets the picture follow the timeline to the drawn time. @param isChanged whether also other values have changed */
  followTimeline(isChanged = false): void {
    const { simulation, drawnTime } = this.followers;
    this.playTimeline();
    const isOther = simulation.animation?.follow(drawnTime);
    if (isOther || isChanged) this.setPicture();
  }

  /** Draws with these values of style, light and camera in place of the others, which stay, until the next call. */
  showWith(other: Values): void {
    this.other = other;
    this.setPicture();
  }

  private setPicture(): void {
    const { simulation, picture } = this.followers;
    picture.setValues({ ...this.now, ...simulation.animation?.shown, ...this.other });
  }

  /** @param asked values that are set explicitly */
  private change(given: Values, asked: Values = {}): void {
    const { simulation } = this.followers;
    const before = this.now;
    const { after, changed } = this.changedBy(given, asked);
    this.apply(this.without(after), changed, after);
    const capacity = after['simulation.maxParticles'] as number;
    if (capacity !== before['simulation.maxParticles']) {
      simulation.input((simulator) => simulator.inputCapacity(capacity));
    }
    if (after.seed !== before.seed) simulation.restart(after);
    this.followers.show(() => this.adoptValues(after));
  }

  private changedBy(given: Values, asked: Values): { after: Values; changed: Values } {
    const { simulation, drawnTime: time } = this.followers;
    const { animation, simulator } = simulation;
    return (
      animation?.changedBy(this.now, given, asked, { steps: simulator.steps, time }, this.recordsKeyframes) ?? {
        after: given,
        changed: differing(this.now, given),
      }
    );
  }

  /**
   * Gives the simulation a change at once, because the simulator may reject it: at most 15 looks.
   * @param unset keys that follow the scene again
   * @param after all values after the change
   */
  private apply(unset: readonly string[], changed: Values, after: Values): void {
    const { simulation, drawnTime } = this.followers;
    simulation.set({ ...simulation.unsetValues(unset), ...changed }, after);
    simulation.record({ ...Object.fromEntries(unset.map((key) => [key, null])), ...(changed as AnyValues) }, drawnTime);
  }

  private without(after: Values): string[] {
    return Object.keys(this.now).filter((key) => !(key in after));
  }

  private requireChangeable(given: GivenValues): Values {
    const values = timelineText(given);
    validate(values);
    const { scene } = this.now;
    if ((values.scene ?? scene) !== scene)
      throw new ParameterError('scene', values.scene, `${scene} (or call enter())`);
    return values;
  }
}
