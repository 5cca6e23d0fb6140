/** Plays a timeline on a simulator. */
import { ParameterError } from '../base/errors.ts';
import type { AnyValues, Value, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import {
  EMPTY_TIMELINE,
  timeIn,
  valueAt,
  type Lane,
  type Timeline,
  type TimelineBurst,
} from '../parameters/timeline.ts';
import type { Simulator } from './simulator.ts';
import { simulatorValues } from './simulatorValues.ts';

/** When a person last changed a parameter at or before a time, in steps; undefined if nobody did. */
type LastChange = (key: string, time: number) => number | undefined;

/** How a smoke takes what its timeline plays. */
export interface PlayOptions {
  /** Whether also values that the simulator already has are set, because something else sets them in each step. */
  readonly isWhole?: boolean;
  /** Sets values that the simulator reads, in place of the simulator itself. */
  readonly put?: (values: Values) => void;
  /** Whether an emitter has no effect, also in bursts. */
  readonly isSilent?: (emitter: number) => boolean;
}

/** No numbers: births are added to an emitter as it is. */
const NO_NUMBERS = new Float64Array(0);

/**
 * Evaluates a timeline. A change by a person holds until the next keyframe of its lane. What it gives depends on the time and
 * these changes only, so that it is the same after a seek.
 */
export class TimelinePlayer {
  readonly timeline: Timeline;
  private readonly driven: readonly Lane[];
  private readonly drawn: readonly Lane[];
  private readonly lanes: ReadonlyMap<string, Lane>;
  private readonly bursts = new Map<number, readonly TimelineBurst[]>();
  private readonly lastChange: LastChange;
  /** Values that the simulator has from the timeline, after the step that it was last prepared for. */
  private readonly given = new Map<string, Value>();
  private inputsDone = 0;

  constructor(timeline: Timeline, lastChange: LastChange) {
    this.timeline = timeline;
    this.lastChange = lastChange;
    this.lanes = new Map(timeline.lanes.map((lane) => [lane.key, lane]));
    this.driven = timeline.lanes.filter(isDriven);
    this.drawn = timeline.lanes.filter((lane) => !isDriven(lane));
    for (const burst of timeline.bursts) this.bursts.set(burst.step, [...(this.bursts.get(burst.step) ?? []), burst]);
  }

  /** Whether a parameter has keyframes. */
  animates(key: string): boolean {
    return this.lanes.has(key);
  }

  /** Whether a parameter has the value that a person gave it, in place of that of its lane. */
  isHeld(key: string, time: number): boolean {
    const since = this.lastChange(key, time);
    return since !== undefined && time < this.nextKeyframe(key, since);
  }

  /** When the lanes of these values were last changed by a person whose value still holds, by key, in steps. */
  held(time: number): Record<string, number> {
    const keys = [...this.lanes.keys()].filter((key) => this.isHeld(key, time));
    return Object.fromEntries(keys.map((key) => [key, this.lastChange(key, time)!]));
  }

  /**
   * The values of lanes but those that a person holds.
   * @param time simulated, in steps; may be a fraction
   * @param isDrawn whether without the parameters of the simulator
   */
  valuesAt(time: number, isDrawn = false): Values {
    const at = timeIn(this.timeline, time);
    const lanes = isDrawn ? this.drawn : this.timeline.lanes;
    const free = lanes.filter(({ key }) => !this.isHeld(key, time));
    return Object.fromEntries(free.map((lane) => [lane.key, valueAt(lane, at)]));
  }

  /** Something else has changed the simulator: in its next step it gets all values. */
  reset(): void {
    this.given.clear();
  }

  /** Gives the simulator the values and bursts of its next step. */
  prepare(simulator: Simulator, { isWhole = false, put, isSilent }: PlayOptions = {}): void {
    const { steps, inputsDone } = simulator;
    if (isWhole || inputsDone !== this.inputsDone) this.reset();
    this.inputsDone = inputsDone;
    const changed = this.changedAt(steps);
    if (changed) attempt(() => (put ? put(changed) : simulator.set(this.numbersOf(changed))));
    const { length, loops } = this.timeline;
    const at = loops ? steps % length : steps;
    if (at >= length) return;
    for (const { emitter, count } of this.bursts.get(at) ?? [])
      if (!isSilent?.(emitter)) attempt(() => simulator.setEmitter(emitter, NO_NUMBERS, count));
  }

  /** Numbers are the simulator's as they are. */
  private numbersOf(changed: AnyValues): Record<string, number> {
    const isPlain = Object.values(changed).every((value) => typeof value === 'number');
    return isPlain ? (changed as Record<string, number>) : simulatorValues(changed);
  }

  private changedAt(steps: number): AnyValues | undefined {
    const at = timeIn(this.timeline, steps);
    let changed: Record<string, Value> | undefined;
    for (const lane of this.driven) {
      const { key } = lane;
      if (this.isHeld(key, steps)) this.given.delete(key);
      else {
        const value = valueAt(lane, at);
        if (this.given.get(key) === value) continue;
        this.given.set(key, value);
        (changed ??= {})[key] = value;
      }
    }
    return changed;
  }

  /** The first step after another at which a lane has a keyframe; Infinity if there is none. */
  private nextKeyframe(key: string, step: number): number {
    const { length, loops } = this.timeline;
    const steps = this.lanes.get(key)?.keyframes.map((keyframe) => keyframe.step) ?? [];
    if (!loops) return steps.find((each) => each > step && each <= length) ?? Infinity;
    const start = step - (step % length);
    const next = steps.find((each) => start + each > step && each < length);
    if (next !== undefined) return start + next;
    return steps[0] < length ? start + length + steps[0] : Infinity;
  }
}

/**
 * Acts on the simulator. What it rejects has no effect: a burst of an emitter that the smoke does not have, and a tint that
 * would be a sixteenth look.
 */
function attempt(act: () => void): void {
  try {
    act();
  } catch (error) {
    if (!(error instanceof ParameterError)) throw error;
  }
}

/** Keys whose values select code of the renderer, with the values that select most of it. */
const DEMANDING: Readonly<Record<string, (values: readonly Value[]) => Value>> = {
  'emission.glow': (values) => values.find((value) => /:(?!0(,|$|\.0*(,|$)))/.test(String(value))) ?? values[0],
  'light.kind': (values) => (values.includes('lamp') ? 'lamp' : values[0]),
  ...Object.fromEntries(
    ['light.decay', 'style.simplify', 'style.form', 'style.strokes', 'style.outlines', 'style.shading'].map((key) => [
      key,
      (values: readonly Value[]) => Math.max(...values.map(Number)),
    ]),
  ),
};

/** Values of a timeline that together select all code of the renderer that its pictures need. */
export function demandsOf({ lanes } = EMPTY_TIMELINE): Values {
  const entries = lanes.flatMap(({ key, keyframes }) => {
    const most = Object.hasOwn(DEMANDING, key) ? DEMANDING[key] : undefined;
    return most ? [[key, most(keyframes.map(({ value }) => value))] as const] : [];
  });
  return Object.fromEntries(entries);
}

/** Whether the simulator reads the parameter of a lane. */
function isDriven({ key }: Pick<Lane, 'key'>): boolean {
  return findParameter(key)!.reader === 'simulator';
}

/**
 * The first step from which two timelines drive a simulator differently; Infinity if they never do.
 */
export function firstDifference(before = EMPTY_TIMELINE, after = EMPTY_TIMELINE): number {
  const keys = new Set([...before.lanes, ...after.lanes].map(({ key }) => key));
  const driven = [...keys].filter((key) => isDriven({ key }));
  const laneOf = ({ lanes }: Timeline, key: string) => lanes.find((lane) => lane.key === key)?.keyframes ?? [];
  const steps = driven.map((key) => {
    const [a, b] = [laneOf(before, key), laneOf(after, key)];
    const at = firstUnequal(a, b);
    if (at === undefined) return Infinity;
    const isSameUntil = a[at]?.step === b[at]?.step && a[at]?.value === b[at]?.value;
    if (isSameUntil) return a[at].step;
    // Up to the keyframe before, the values are the same. Before the first one they are those of the first one.
    return at === 0 ? 0 : a[at - 1].step;
  });
  const burst = firstUnequal(before.bursts, after.bursts);
  const ofBurst = burst === undefined ? Infinity : Math.min(stepAt(before.bursts, burst), stepAt(after.bursts, burst));
  const isSameEnd = before.length === after.length && before.loops === after.loops;
  const hasEnd = !isSameEnd && driven.length + before.bursts.length + after.bursts.length > 0;
  return Math.min(...steps, ofBurst, hasEnd ? Math.min(before.length, after.length) : Infinity);
}

function stepAt(bursts: readonly TimelineBurst[], at: number): number {
  return bursts.length > at ? bursts[at].step : Infinity;
}

function firstUnequal(a: readonly object[], b: readonly object[]): number | undefined {
  const most = Math.max(a.length, b.length);
  for (let at = 0; at < most; ++at) if (JSON.stringify(a[at]) !== JSON.stringify(b[at])) return at;
  return undefined;
}
