import { whyNotAnimated, writeTimeline, type Timeline } from '../../internal.ts';
import { findParameter, type AnyValues, type Value } from '../../preset.ts';
import type { Changes, Recorder } from '../editor/editor.ts';
import { recorded, type Sample } from './model.ts';

/** What a recorder needs. */
export interface Recorded {
  readonly timeline: Timeline;
  /** The present step of the timeline. */
  readonly step: number;
  /** The values of the state, as if nothing were animated. */
  readonly values: AnyValues;
  /** The value of a parameter in effect. */
  inEffect(key: string): Value | undefined;
  /** Makes values that are those of the state take effect in place of animated ones. */
  holdSame(changes: Changes): void;
}

/** A parameter that a gesture changes. */
interface Recording {
  /** The value in effect before. */
  readonly before: Value;
  /** Values by step. A timeline that starts again begins another part. */
  readonly parts: Map<number, Value>[];
  /** The value of the state, which it has again after a gesture that has changed it. */
  readonly base: Value | undefined;
  /** Whether the gesture changes the value of the state, as drags of the camera do. */
  readonly isByHand: boolean;
}

/** Makes keyframes of changes. What a gesture holds while the smoke plays becomes a lane, with as few keyframes as it needs. */
export class KeyframeRecorder implements Recorder {
  isOn = false;
  private readonly source: Recorded;
  private readonly recordings = new Map<string, Recording>();
  /** The timeline before the gesture. */
  private before: Timeline | undefined;

  constructor(source: Recorded) {
    this.source = source;
  }

  replace(changes: Changes): Changes {
    if (!this.isOn) this.source.holdSame(changes);
    const entries = Object.entries(changes).filter((entry): entry is [string, Value] => this.isRecorded(...entry));
    if (entries.length === 0) return changes;
    for (const [key, value] of entries) this.sample(key, value, false);
    const rest = Object.entries(changes).filter(([key]) => !entries.some(([recordedKey]) => recordedKey === key));
    return { ...Object.fromEntries(rest), timeline: this.text() };
  }

  note(changes: Changes): void {
    for (const [key, value] of Object.entries(changes)) {
      if (this.isRecorded(key, value)) this.sample(key, value!, true);
    }
  }

  settle(): Changes {
    const byHand = [...this.recordings].filter(([, { isByHand }]) => isByHand);
    const bases = Object.fromEntries(byHand.map(([key, { base }]) => [key, base]));
    const completing = byHand.length > 0 ? { ...bases, timeline: this.text() } : {};
    this.recordings.clear();
    this.before = undefined;
    return completing;
  }

  /**
   * Goes on recording the values that a gesture holds. Called with each frame while the smoke plays.
   * @returns the timeline as text; undefined without a gesture
   */
  hold(): string | undefined {
    if (this.recordings.size === 0) return undefined;
    for (const [key, { parts, isByHand }] of this.recordings) {
      this.sample(key, [...parts.at(-1)!.values()].at(-1)!, isByHand);
    }
    return [...this.recordings.values()].every(({ isByHand }) => isByHand) ? undefined : this.text();
  }

  /** An item that is only being added has no value before, and gets no keyframes. */
  private isRecorded(key: string, value: Value | undefined): boolean {
    if (!this.isOn || value === undefined || whyNotAnimated(key) !== undefined) return false;
    return this.recordings.has(key) || this.source.inEffect(key) !== undefined;
  }

  private sample(key: string, value: Value, isByHand: boolean): void {
    const { source, recordings } = this;
    const { step } = source;
    this.before ??= source.timeline;
    if (!recordings.has(key)) {
      const base = source.values[key];
      // The stage has the first value of a gesture on it already.
      const before = (isByHand ? base : undefined) ?? source.inEffect(key) ?? findParameter(key)!.default;
      recordings.set(key, { before, parts: [new Map()], base, isByHand });
    }
    const { parts } = recordings.get(key)!;
    const last = [...parts.at(-1)!.keys()].at(-1) ?? step;
    if (step < last) parts.push(new Map());
    parts.at(-1)!.set(step, value);
  }

  private text(): string {
    let timeline = this.before!;
    for (const [key, { before, parts }] of this.recordings) {
      for (const part of parts) timeline = recorded(timeline, key, samplesOf(part), before).timeline;
    }
    return writeTimeline(timeline);
  }
}

function samplesOf(part: ReadonlyMap<number, Value>): readonly Sample[] {
  return [...part].map(([step, value]) => ({ step, value }));
}
