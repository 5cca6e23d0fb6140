/**
 * What happens to the values of a smoke over time: its timeline, and what people change. This code is loaded when a smoke
 * first has a timeline, or replays a take that changes its look.
 */
import { ParameterError } from '../base/errors.ts';
import type { AnyValues, Value, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { readTimeline, withKeyframes, writeTimeline, type Lane, type Timeline } from '../parameters/timeline.ts';
import { differing } from '../parameters/values.ts';
import { ChangeLog, type Changes } from './changeLog.ts';
import type { PackedLog } from './plainLog.ts';
import { splitState, withMetadata } from './savedState.ts';
import type { Simulator } from './simulator.ts';
import { demandsOf, firstDifference, TimelinePlayer, type PlayOptions } from './timelinePlayer.ts';

export { requireTimeline, writeTimeline } from '../parameters/timeline.ts';

/** The time of a smoke. */
export interface Moment {
  /** Of the simulator. */
  readonly steps: number;
  /** That is drawn, in steps. */
  readonly time: number;
}

/** What a change does. */
export interface Changed {
  readonly after: Values;
  readonly changed: Values;
}

export class Animation {
  log: ChangeLog;
  private player: TimelinePlayer | undefined;
  /** Values of the timeline for the picture. */
  private drawn: AnyValues = {};

  /** @param isReplayed whether the changes are those of a take */
  constructor(changes?: PackedLog, isReplayed?: boolean) {
    this.log = new ChangeLog(changes, isReplayed);
  }

  /** Values that together select all code of the renderer that pictures need. */
  get demands(): Values {
    return demandsOf(this.player?.timeline);
  }

  /**
   * Plays another timeline. Lanes that are new or different apply to all time: earlier changes of their parameters no longer
   * hold.
   * @returns the first step from which it drives the simulator differently; Infinity if it never does
   */
  play(text: string): number {
    const before = this.player?.timeline;
    this.player = text
      ? new TimelinePlayer(readTimeline(text).timeline, (key, time) => this.log.held(key, time))
      : undefined;
    const { timeline } = this.player ?? {};
    for (const { key } of editedLanes(before, timeline)) this.log.forget(key, before === undefined);
    return firstDifference(before, timeline);
  }

  /** Gives the simulator the values and bursts of its next step. */
  prepare(simulator: Simulator, options?: PlayOptions): void {
    this.player?.prepare(simulator, options);
  }

  /** Something else has changed the simulator. */
  reset(): void {
    this.player?.reset();
  }

  /** Whether the timeline gives the simulator a parameter at a step. */
  isDriven(key: string, steps: number): boolean {
    return this.animates(key) && !this.player!.isHeld(key, steps);
  }

  /** The values of the timeline at a time, in steps. */
  valuesAt(time: number): Values {
    return this.player?.valuesAt(time) ?? {};
  }

  /** Those of style, light and camera at the time that was last followed. */
  get shown(): Values {
    return this.drawn;
  }

  /** Follows the timeline to a drawn time, in steps. @returns whether `shown` has changed */
  follow(time: number): boolean {
    const before = this.drawn;
    this.drawn = this.player?.valuesAt(time, true) ?? {};
    const keys = Object.keys(this.drawn);
    return keys.length !== Object.keys(before).length || keys.some((key) => this.drawn[key] !== before[key]);
  }

  /**
   * What a change by a person does.
   * @param given all values after it
   * @param asked those that are set explicitly, also if they were set before
   * @param asKeyframes whether animated parameters get keyframes in place of the values
   * @returns the values after it, and those that change
   */
  changedBy(before: AnyValues, given: AnyValues, asked: AnyValues, now: Moment, asKeyframes: boolean): Changed {
    const changed: AnyValues = { ...this.byHand(asked, now), ...differing(before, given) };
    const isKeyframe = (key: string) => asKeyframes && !('timeline' in changed) && this.animates(key);
    const keys = Object.keys(changed).filter(isKeyframe);
    const timeline = this.keyframed(keys, changed, now);
    if (timeline === undefined) return { after: given, changed };
    const kept = Object.fromEntries(keys.map((key) => [key, before[key]]));
    const others = Object.entries(changed).filter(([key]) => !keys.includes(key));
    return { after: defined({ ...given, ...kept, timeline }), changed: Object.fromEntries(others) };
  }

  /**
   * Records what the simulator does not: style, light, camera, and which of its parameters leave their lanes.
   * @param changes null for what follows the scene or the timeline again
   */
  record(changes: Readonly<Record<string, Value | null>>, now: Moment): void {
    for (const [key, value] of Object.entries(changes)) {
      const { reader } = findParameter(key)!;
      const isLogged = reader === 'simulator' ? this.animates(key) : reader !== 'stage';
      if (isLogged) this.log.add(stepOf(key, now), key, value ?? undefined);
    }
  }

  /** Values that the log changes at a time, in steps; undefined if it changes none. @param start values at the start */
  followLog(values: AnyValues, start: AnyValues, time: number): Values | undefined {
    const changes = this.log.valuesAt(time, start);
    const isSame = Object.entries(changes).every(([key, value]) => values[key] === value);
    return isSame ? undefined : defined({ ...values, ...changes });
  }

  /** Goes back to a step; see `ChangeLog.rewind`. */
  rewind(step: number): void {
    this.log.rewind(step, (key) => this.animates(key));
  }

  /** A saved state of the simulator, with what people hold of the timeline. */
  saved(state: Uint8Array, steps: number): Uint8Array {
    const held = this.player?.held(steps) ?? {};
    return Object.keys(held).length > 0 ? withMetadata(state, { held }) : state;
  }

  /** Takes over what people hold in a saved state. @param values that they hold */
  restore(bytes: Uint8Array, values: AnyValues): void {
    this.log = new ChangeLog();
    const held = Object.entries(splitState(bytes).meta.held ?? {});
    for (const [key, step] of held)
      if (findParameter(key) && Number.isInteger(step)) this.log.add(step as number, key, values[key]);
    this.reset();
  }

  private animates(key: string): boolean {
    return this.player?.animates(key) ?? false;
  }

  /** Explicitly set values that differ from those of the timeline. What `get` gives, with a timeline, has none. */
  private byHand(asked: AnyValues, { time }: Moment): Values {
    if ('timeline' in asked) return {};
    const shown: AnyValues = this.valuesAt(time);
    const keys = Object.keys(asked).filter((key) => this.animates(key) && shown[key] !== asked[key]);
    return Object.fromEntries(keys.map((key) => [key, asked[key]]));
  }

  /** The timeline with keyframes of these values as text; undefined without any, and beyond its limits. */
  private keyframed(keys: readonly string[], values: AnyValues, now: Moment): string | undefined {
    const { player } = this;
    if (!player || keys.length === 0) return undefined;
    try {
      const { timeline } = player;
      return writeTimeline(
        keys.reduce((made, key) => withKeyframes(made, { [key]: values[key] }, stepOf(key, now)), timeline),
      );
    } catch (error) {
      if (error instanceof ParameterError) return undefined;
      throw error;
    }
  }
}

/** The step from which a change takes effect. */
function stepOf(key: string, { steps, time }: Moment): number {
  return findParameter(key)!.reader === 'simulator' ? steps : Math.floor(time + 1e-6);
}

function defined(values: Changes): Values {
  return Object.fromEntries(Object.entries(values).filter(([, value]) => value !== undefined));
}

/** The lanes of a timeline that another one does not have. */
function editedLanes(before: Timeline | undefined, after: Timeline | undefined): readonly Lane[] {
  const known = new Set(before?.lanes.map((lane) => JSON.stringify(lane)));
  return after?.lanes.filter((lane) => !known.has(JSON.stringify(lane))) ?? [];
}

/** {@link Animation.demands} of a timeline. */
export function demandsIn(text: string): Values {
  return demandsOf(readTimeline(text).timeline);
}
