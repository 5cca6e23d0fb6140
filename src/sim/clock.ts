/** Length of a simulation step in seconds; the same everywhere, so that takes replay. */
export const STEP_SECONDS = 1 / 60;

/** Simulated seconds of a picture after so many steps, between the previous one (0) and the latest (1). */
export function secondsAt(steps: number, blend: number): number {
  return Math.max(0, steps - 1 + blend) * STEP_SECONDS;
}

// A machine that cannot keep up shows slow motion instead of falling ever further behind.
const MAX_STEPS_A_TICK = 4;

/** Turns real time into whole steps and the fraction of a step that the picture stands beyond the last but one. */
export class Clock {
  /** Simulated seconds for each real second; 1 is real time. */
  speed = 1;
  private owed = 0;
  private last: number | undefined;

  /** Between the previous step (0) and the latest (1). */
  get blend(): number {
    return this.owed;
  }

  /** Whether the next tick is the first: no time passes until it. */
  get isResting(): boolean {
    return this.last === undefined;
  }

  /**
   * @param now milliseconds, as from requestAnimationFrame
   * @returns how many steps to take before drawing
   */
  tick(now: number): number {
    const elapsed = this.last === undefined ? 0 : Math.max(0, now - this.last) / 1000;
    this.last = now;
    this.owed = Math.min(this.owed + (elapsed * this.speed) / STEP_SECONDS, MAX_STEPS_A_TICK + 0.999);
    const steps = Math.floor(this.owed);
    this.owed -= steps;
    return steps;
  }

  /** Forgets the time that passes until the next tick: after a pause nothing is caught up. */
  rest(): void {
    this.last = undefined;
  }

  /** Puts the picture exactly on the latest step, or between the previous one (0) and it (1). */
  settle(blend = 1): void {
    this.rest();
    this.owed = blend;
  }
}
