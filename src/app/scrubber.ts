import { STEP_SECONDS } from '../sim/clock.ts';
import type { Stage } from '../stage/stage.ts';

/** Goes to moments as fast as people ask for them: one way at a time, and of several goals the last counts. */
export class Scrubber {
  /** Told on the way where the smoke is, in simulated seconds. */
  onWay: (seconds: number) => void = () => undefined;
  private readonly stage: Stage;
  private goal: number | undefined;
  private controller = new AbortController();
  private isOnWay = false;

  constructor(stage: Stage) {
    this.stage = stage;
  }

  /** Settled when nobody wants to be elsewhere any more. @param seconds simulated; below 0 is the start */
  async go(seconds: number): Promise<void> {
    this.goal = Math.max(seconds, 0);
    this.controller.abort();
    if (this.isOnWay) return;
    this.isOnWay = true;
    try {
      while (this.goal !== undefined) await this.approach(this.takeGoal());
    } finally {
      this.isOnWay = false;
    }
  }

  /** Goes on or back by so many seconds from where it is, or from where it is going. */
  async shift(seconds: number): Promise<void> {
    await this.go((this.goal ?? this.stage.stats.time) + seconds);
  }

  /** One step back, then stillness, as a step forward is. */
  async stepBack(): Promise<void> {
    this.stage.pause();
    await this.shift(-STEP_SECONDS);
  }

  private takeGoal(): number {
    const goal = this.goal!;
    this.goal = undefined;
    return goal;
  }

  private async approach(goal: number): Promise<void> {
    this.controller = new AbortController();
    const { signal } = this.controller;
    try {
      await this.stage.seek(goal, { signal, onProgress: () => this.onWay(this.stage.stats.time) });
    } catch (error) {
      if (!signal.aborted) throw error;
    }
  }
}
