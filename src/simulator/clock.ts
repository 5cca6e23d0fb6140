/** Length of a simulation step in seconds. It is fixed so that takes replay on every machine. */
export const STEP_SECONDS = 1 / 60;

/** Simulated seconds of a frame after `steps` steps, interpolated between the previous step (0) and the latest (1). */
export function secondsAt(steps: number, blend: number): number {
  return Math.max(0, steps - 1 + blend) * STEP_SECONDS;
}

// A machine that cannot keep up shows slow motion instead of falling further and further behind.
const MAX_STEPS_A_TICK = 4;

/** Converts real time to whole steps, and to the interpolation factor between the last two steps. */
export class Clock {
  /** Simulated seconds for each real second; 1 is real time. */
  speed = 1;
  private owed = 0;
  private last: number | undefined;

  /** Interpolation between the previous step (0) and the latest (1). */
  get blend(): number {
    return this.owed;
  }

  /** Whether the clock is paused. No time elapses until the next tick. */
  get isPaused(): boolean {
    return this.last === undefined;
  }

  /**
   * @param now milliseconds, as from requestAnimationFrame
   * @returns number of steps to run before drawing
   */
  tick(now: number): number {
    const elapsed = this.last === undefined ? 0 : Math.max(0, now - this.last) / 1000;
    this.last = now;
    this.owed = Math.min(this.owed + (elapsed * this.speed) / STEP_SECONDS, MAX_STEPS_A_TICK + 0.999);
    const steps = Math.floor(this.owed);
    this.owed -= steps;
    return steps;
  }

  /** Pauses the clock. The time until the next tick is not counted. */
  pause(): void {
    this.last = undefined;
  }

  /** Pauses the clock and sets `blend`. The default is the latest step. */
  settle(blend = 1): void {
    this.pause();
    this.owed = blend;
  }
}
