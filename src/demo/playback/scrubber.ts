import type { Stage } from '../../index.ts';
import { STEP_SECONDS } from '../../internal.ts';

/** A seek to one time. Each request creates a new object. */
export interface Seek {
  /** Target time in simulated seconds. */
  readonly goal: number;
  /** Progress, 0 to 1. */
  share: number;
}

/** Called with the progress of a seek; with undefined at its end. */
type SeekListener = (seek: Seek | undefined) => void;

/** Coalesces seek requests: one seek runs at a time, and of several requests the last one wins. */
export class Scrubber {
  private readonly stage: Stage;
  private readonly listeners: SeekListener[] = [];
  /** The next requested time, and the target of the current seek, in simulated seconds. */
  private goal: number | undefined;
  private heading: number | undefined;
  private controller = new AbortController();
  private isSeeking = false;

  constructor(stage: Stage) {
    this.stage = stage;
  }

  listen(listener: SeekListener): void {
    this.listeners.push(listener);
  }

  /** The requested time in simulated seconds; undefined when idle. */
  get wanted(): number | undefined {
    return this.goal ?? this.heading;
  }

  /** Cancels the seek at its current time. */
  stop(): void {
    this.goal = undefined;
    this.controller.abort();
  }

  /** Resolves when the last requested time is reached. @param seconds simulated seconds; negative values mean 0 */
  async go(seconds: number): Promise<void> {
    this.goal = Math.max(seconds, 0);
    this.controller.abort();
    if (this.isSeeking) return;
    this.isSeeking = true;
    try {
      while (this.goal !== undefined) await this.approach(this.consumeGoal());
    } finally {
      this.isSeeking = false;
      this.heading = undefined;
      this.notify(undefined);
    }
  }

  /** Seeks relative to the current time, or to the target of the current seek. */
  async shift(seconds: number): Promise<void> {
    await this.go((this.wanted ?? this.stage.stats.time) + seconds);
  }

  /** Goes one step back and pauses, like a step forward. */
  async stepBack(): Promise<void> {
    this.stage.pause();
    await this.shift(-STEP_SECONDS);
  }

  private consumeGoal(): number {
    const goal = this.goal!;
    this.heading = goal;
    this.goal = undefined;
    return goal;
  }

  private async approach(goal: number): Promise<void> {
    this.controller = new AbortController();
    const { signal } = this.controller;
    const seek: Seek = { goal, share: 0 };
    const onProgress = (share: number) => {
      seek.share = share;
      this.notify(seek);
    };
    try {
      await this.stage.seek(goal, { signal, onProgress });
    } catch (error) {
      if (!signal.aborted) throw error;
    }
  }

  private notify(seek: Seek | undefined): void {
    for (const listener of this.listeners) listener(seek);
  }
}
