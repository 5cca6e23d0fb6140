/** Fractions of the pixel ratio that the governor selects from. Each step draws about a third fewer pixels. */
export const SCALES: readonly number[] = [1, 0.84, 0.71, 0.59, 0.5];
const PIXELS = SCALES.map((scale) => scale * scale);

/** Milliseconds between frames that still look smooth: the interval of a 50 Hz display, plus some slack. */
const BUDGET_MS = 22;
/** Slack for a limited frame rate. */
const SLACK = 1.3;
// The first frames compile shader programs and create buffers.
const WARM_UP_MS = 200;
const WARM_UP_FRAMES = 3;
// A window has a minimum duration, and enough frames for its median to ignore a pause. More frames would take long to
// arrive on a machine that draws two a second.
const WINDOW_MS = 500;
const WINDOW_FRAMES = 3;
/** Consecutive slow windows before the scale drops, so that a short load spike has no effect. */
const SLOW_WINDOWS = 2;
/** Milliseconds without a slow window before the scale is raised. Each failed attempt doubles the delay. */
const RETRY_DELAY_MS = 4_000;
const MAX_RETRY_DELAY_MS = 120_000;
/** If a quarter of the pixels takes more than this fraction of the time, the pixel count is not the bottleneck. */
const FUTILE = 0.9;
const FUTILE_REST_MS = 300_000;

/**
 * Adaptive resolution: keeps a time budget per frame by drawing fewer pixels, never fewer particles. It measures the
 * median time between frames over half a second, so one long frame (such as a garbage collection) has no effect. The
 * scale drops after two slow windows in a row and rises one step at a time; the delay doubles after each failed
 * attempt. If fewer pixels do not help, as with a slow CPU or a 30 Hz display, it returns to full scale.
 */
export class Governor {
  /** Index of the selected share of the work. */
  level = 0;
  private readonly budgetMs: number;
  private readonly shares: readonly number[];
  private last: number | undefined;
  private warmUpMs = 0;
  private warmUpFrames = 0;
  private times: number[] = [];
  private windowMs = 0;
  private slowWindows = 0;
  private calmMs = 0;
  private retryDelayMs = RETRY_DELAY_MS;
  private hasClimbed = false;
  /** Median frame time when the scale was last lowered from 1. */
  private fullScaleMs = 0;
  private restMs = 0;

  /**
   * @param intervalMs minimum time between frames, when the frame rate is limited
   * @param shares fractions of the work of a frame that it selects from, from 1 down. Default: of the pixels
   */
  constructor(intervalMs = 0, shares = PIXELS) {
    this.shares = shares;
    this.budgetMs = Math.max(BUDGET_MS, SLACK * intervalMs);
  }

  /** Fraction of the pixel ratio to draw with, one of `SCALES`. */
  get scale(): number {
    return SCALES[this.level];
  }

  /**
   * Records the start of a frame.
   * @param now milliseconds, as from requestAnimationFrame
   */
  tick(now: number): void {
    const elapsed = this.last === undefined ? 0 : now - this.last;
    this.last = now;
    if (this.isCold) {
      this.warmUpMs += elapsed;
      this.warmUpFrames += 1;
      return;
    }
    this.times.push(elapsed);
    this.windowMs += elapsed;
    this.restMs = Math.max(0, this.restMs - elapsed);
    if (this.times.length >= WINDOW_FRAMES && this.windowMs >= WINDOW_MS) this.judge();
  }

  /** Discards the measurement when frames pause or change size. The scale is kept. */
  pause(): void {
    this.last = undefined;
    this.warmUpMs = 0;
    this.warmUpFrames = 0;
    this.slowWindows = 0;
    this.calmMs = 0;
    this.clearWindow();
  }

  private get isCold(): boolean {
    return this.warmUpMs < WARM_UP_MS || this.warmUpFrames < WARM_UP_FRAMES;
  }

  private judge(): void {
    const median = [...this.times].sort((a, b) => a - b)[this.times.length >> 1];
    if (median > this.budgetMs) this.fallBehind(median);
    else this.raiseWhenCalm();
    this.clearWindow();
  }

  private clearWindow(): void {
    this.times = [];
    this.windowMs = 0;
  }

  private fallBehind(median: number): void {
    this.calmMs = 0;
    this.slowWindows += 1;
    if (this.slowWindows < SLOW_WINDOWS || this.restMs > 0) return;
    if (this.level === this.shares.length - 1) this.resetIfFutile(median);
    else this.descend(median);
  }

  private descend(median: number): void {
    if (this.level === 0) this.fullScaleMs = median;
    if (!this.hasClimbed) return this.moveTo(this.levelFor(median), false);
    this.retryDelayMs = Math.min(2 * this.retryDelayMs, MAX_RETRY_DELAY_MS);
    this.moveTo(this.level + 1, false);
  }

  /** The first lower level that fits the budget if frame time is proportional to the work. */
  private levelFor(median: number): number {
    const wanted = this.shares[this.level] * (this.budgetMs / median);
    const fitting = this.shares.findIndex((share, level) => level > this.level && share <= wanted);
    return fitting < 0 ? this.shares.length - 1 : fitting;
  }

  private resetIfFutile(median: number): void {
    if (median < FUTILE * this.fullScaleMs) return;
    this.moveTo(0, false);
    this.restMs = FUTILE_REST_MS;
  }

  private raiseWhenCalm(): void {
    this.slowWindows = 0;
    this.calmMs += this.windowMs;
    if (this.calmMs < this.retryDelayMs) return;
    // The raised scale kept its budget.
    if (this.hasClimbed) this.retryDelayMs = RETRY_DELAY_MS;
    this.moveTo(Math.max(0, this.level - 1), this.level > 0);
  }

  private moveTo(level: number, isClimb: boolean): void {
    this.level = level;
    this.hasClimbed = isClimb;
    this.calmMs = 0;
    this.slowWindows = 0;
  }
}
