import { STEP_SECONDS } from '../../sim/clock.ts';
import type { Stage } from '../../stage/stage.ts';

/** A seek to one moment; another one for each that people ask for. */
export interface Seek {
  /** Where it leads, simulated seconds. */
  readonly goal: number;
  /** How far it has come, 0 to 1. */
  share: number;
}

/** Called with each part of a seek; with nothing when it has ended. */
type SeekListener = (seek: Seek | undefined) => void;

/** Goes to moments as fast as people ask for them: one seek at a time, and of several goals the last counts. */
export class Scrubber {
  private readonly stage: Stage;
  private readonly listeners: SeekListener[] = [];
  /** Where people want to be next, and where it is going now. */
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

  /** Where people want to be, simulated seconds; undefined while nothing seeks. */
  get wanted(): number | undefined {
    return this.goal ?? this.heading;
  }

  /** Stays where it has come to. */
  stop(): void {
    this.goal = undefined;
    this.controller.abort();
  }

  /** Settled when nobody wants to be elsewhere any more. @param seconds simulated; below 0 is the start */
  async go(seconds: number): Promise<void> {
    this.goal = Math.max(seconds, 0);
    this.controller.abort();
    if (this.isSeeking) return;
    this.isSeeking = true;
    try {
      while (this.goal !== undefined) await this.approach(this.takeGoal());
    } finally {
      this.isSeeking = false;
      this.heading = undefined;
      this.notify(undefined);
    }
  }

  /** Goes on or back by so many seconds from where it is, or from where it is going. */
  async shift(seconds: number): Promise<void> {
    await this.go((this.wanted ?? this.stage.stats.time) + seconds);
  }

  /** One step back, then stillness, as a step forward is. */
  async stepBack(): Promise<void> {
    this.stage.pause();
    await this.shift(-STEP_SECONDS);
  }

  private takeGoal(): number {
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
