import { whyNotAnimated, writeTimeline, type Timeline } from '../../internal.ts';
import { findParameter, type AnyValues, type Value } from '../../preset.ts';
import type { Changes, Recorder } from '../editor/editor.ts';
import { recorded, type Sample } from './model.ts';

/** What a recorder reads. */
export interface Recorded {
  readonly timeline: Timeline;
  /** The present step of the timeline. */
  readonly step: number;
  /** The values of the state, animated parameters as if nothing were animated. */
  readonly values: AnyValues;
  /** The value of a parameter in effect. */
  inEffect(key: string): Value | undefined;
}

/** A parameter that a gesture changes. */
interface Recording {
  /** The value of the state, which it has again when the gesture is over. */
  readonly base: Value | undefined;
  /** The value in effect. */
  readonly before: Value;
  /** By step. A timeline that starts again begins another part. */
  readonly parts: Map<number, Value>[];
}

/**
 * Makes keyframes of changes. During a gesture the values are set as by hand, so that the smoke follows; at its end they
 * become keyframes, with the same undo step.
 */
export class KeyframeRecorder implements Recorder {
  isOn = false;
  private readonly source: Recorded;
  private readonly recordings = new Map<string, Recording>();

  constructor(source: Recorded) {
    this.source = source;
  }

  change(changes: Changes, isGesture: boolean): Changes {
    if (!this.isOn) return changes;
    for (const [key, value] of Object.entries(changes)) {
      if (value !== undefined && this.isRecorded(key)) this.note(key, value);
    }
    return isGesture ? changes : { ...changes, ...this.settle() };
  }

  /** Goes on recording the values that a gesture holds. Called with each frame. */
  hold(): void {
    for (const { parts } of this.recordings.values()) this.sample(parts, [...parts.at(-1)!.values()].at(-1)!);
  }

  settle(): Changes {
    if (this.recordings.size === 0) return {};
    let { timeline } = this.source;
    const bases: Record<string, Value | undefined> = {};
    for (const [key, { base, before, parts }] of this.recordings) {
      for (const part of parts) timeline = recorded(timeline, key, samplesOf(part), before).timeline;
      bases[key] = base;
    }
    this.recordings.clear();
    return { ...bases, timeline: writeTimeline(timeline) };
  }

  cancel(): void {
    this.recordings.clear();
  }

  /** An item that is only being added has no value before, and gets no keyframes. */
  private isRecorded(key: string): boolean {
    if (whyNotAnimated(key) !== undefined) return false;
    return this.recordings.has(key) || this.source.inEffect(key) !== undefined;
  }

  private note(key: string, value: Value): void {
    const { source, recordings } = this;
    if (!recordings.has(key)) {
      const before = source.inEffect(key) ?? findParameter(key)!.default;
      recordings.set(key, { base: source.values[key], before, parts: [new Map()] });
    }
    this.sample(recordings.get(key)!.parts, value);
  }

  private sample(parts: Map<number, Value>[], value: Value): void {
    const { step } = this.source;
    const last = [...parts.at(-1)!.keys()].at(-1) ?? step;
    if (step < last) parts.push(new Map());
    parts.at(-1)!.set(step, value);
  }
}

function samplesOf(part: ReadonlyMap<number, Value>): readonly Sample[] {
  return [...part].map(([step, value]) => ({ step, value }));
}
