import { ParameterError } from '../base/errors.ts';
import type { AnyValues, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { differing, requireOptional, validate } from '../parameters/values.ts';
import { loaded, timelineText } from '../renderer/extraPasses.ts';
import type { Changes } from './changeLog.ts';
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
  /** Those of the timeline that the picture has. */
  private animated: AnyValues = {};
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
    return { ...this.now, ...simulation.player?.valuesAt(drawnTime) };
  }

  /** See `Stage.set`. @throws ParameterError for an invalid value or another scene; nothing changes then */
  set(given: GivenValues): void {
    const changed = this.requireChangeable(given);
    const shown: AnyValues = this.shown;
    const byHand = Object.entries(changed).filter(([key, value]) => this.animates(key) && shown[key] !== value);
    this.change({ ...this.now, ...changed }, Object.fromEntries(byHand));
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
    this.followers.simulation.unset(keys);
    this.log(Object.fromEntries(keys.map((key) => [key, undefined])));
    const kept = Object.entries(this.now).filter(([key]) => !keys.includes(key));
    this.followers.show(() => this.adoptValues(Object.fromEntries(kept)));
  }

  /** Applies values that the simulator already has. */
  adoptValues(values: Values): void {
    const { simulation, drawnTime } = this.followers;
    this.now = values;
    if (values.timeline !== simulation.startValues.timeline) simulation.play(values.timeline!);
    this.animated = simulation.player?.valuesAt(drawnTime, true) ?? {};
    this.setPicture();
    this.followers.announce();
  }

  /** Applies what the log of a take changed since the last call. */
  applyLog(): void {
    const { simulation, drawnTime } = this.followers;
    const before: AnyValues = this.now;
    const after = simulation.hasAppliedInputs() ? simulation.valuesIn(before) : before;
    const changes = simulation.changes.valuesAt(drawnTime, simulation.startValues);
    const isSame = Object.entries(changes).every(([key, value]) => before[key] === value);
    if (!isSame) this.adoptValues(defined({ ...after, ...changes }));
    else if (after !== before) this.adoptValues(after);
  }

  /** Takes over the camera that the user has moved. The picture has it already. @param before as `OrbitCamera.held` */
  adoptCamera(before: Values): void {
    const { simulation, picture } = this.followers;
    const moved = differing(before, picture.eye.held);
    const { after } = this.recorded({ ...this.now, ...moved }, moved);
    this.now = after;
    if (after.timeline !== simulation.startValues.timeline) simulation.play(after.timeline!);
  }

  /** Plays the timeline of the values, whose code is loaded. */
  playTimeline(): void {
    const { simulation } = this.followers;
    if (!simulation.player) simulation.play(this.now.timeline!);
  }

  /** Lets the picture follow the timeline to the drawn time. */
  followTimeline(): void {
    const { simulation, drawnTime } = this.followers;
    const animated: AnyValues = simulation.player?.valuesAt(drawnTime, true) ?? {};
    const before = this.animated;
    const keys = Object.keys(animated);
    if (keys.length === Object.keys(before).length && keys.every((key) => animated[key] === before[key])) return;
    this.animated = animated;
    this.setPicture();
  }

  /** Draws with these values of style, light and camera in place of the others, which stay, until the next call. */
  showWith(other: Values): void {
    this.other = other;
    this.setPicture();
  }

  private setPicture(): void {
    this.followers.picture.setValues({ ...this.now, ...this.animated, ...this.other });
  }

  /** @param byHand values of parameters that a timeline animates, also if they were set before */
  private change(given: Values, byHand: Values = {}): void {
    const { simulation } = this.followers;
    const before = this.now;
    const { after, changed } = this.recorded(given, { ...differing(before, given), ...byHand });
    const gone = this.without(after);
    simulation.unset(gone);
    this.log(Object.fromEntries(gone.map((key) => [key, undefined])));
    simulation.set(changed);
    const capacity = after['simulation.maxParticles'] as number;
    if (capacity !== before['simulation.maxParticles']) {
      simulation.input((simulator) => simulator.inputCapacity(capacity));
    }
    if (after.seed !== before.seed) simulation.restart(after);
    this.followers.show(() => this.adoptValues(after));
  }

  /**
   * Records a change by a person: as keyframes, or in the log.
   * @returns what it leaves of the change beside the keyframes
   */
  private recorded(given: AnyValues, changed: AnyValues): { after: Values; changed: Values } {
    const { player } = this.followers.simulation;
    const isKeyframe = (key: string) => this.recordsKeyframes && !('timeline' in changed) && this.animates(key);
    const keys = Object.keys(changed).filter(isKeyframe);
    if (keys.length === 0 || !player) return this.logged(given, changed);
    const { withKeyframes, writeTimeline } = loaded.timeline!;
    const now: AnyValues = this.now;
    try {
      const keyframed = keys.reduce(
        (timeline, key) => withKeyframes(timeline, { [key]: changed[key] }, this.stepOf(key)),
        player.timeline,
      );
      const timeline = writeTimeline(keyframed);
      const kept = Object.fromEntries(keys.map((key) => [key, now[key]]));
      const rest = Object.entries(changed).filter(([key]) => !keys.includes(key));
      return this.logged(defined({ ...given, ...kept, timeline }), Object.fromEntries(rest));
    } catch (error) {
      // Beyond the limits of a timeline the values hold.
      if (error instanceof ParameterError) return this.logged(given, changed);
      throw error;
    }
  }

  private logged(after: AnyValues, changed: AnyValues): { after: Values; changed: Values } {
    this.log(changed);
    return { after, changed };
  }

  /** Logs what the simulator does not record: style, light, camera, and which of its parameters leave their lanes. */
  private log(changes: Changes): void {
    const { simulation } = this.followers;
    for (const [key, value] of Object.entries(changes)) {
      const { reader } = findParameter(key)!;
      const isLogged = reader === 'simulator' ? this.animates(key) : reader !== 'stage';
      if (isLogged) simulation.changes.add(this.stepOf(key), key, value);
    }
  }

  /** The step from which a change of a parameter takes effect. */
  private stepOf(key: string): number {
    const { simulation, drawnTime } = this.followers;
    return findParameter(key)!.reader === 'simulator' ? simulation.simulator.steps : Math.floor(drawnTime + 1e-6);
  }

  private animates(key: string): boolean {
    return this.followers.simulation.player?.animates(key) ?? false;
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

function defined(values: Changes): Values {
  return Object.fromEntries(Object.entries(values).filter(([, value]) => value !== undefined));
}
