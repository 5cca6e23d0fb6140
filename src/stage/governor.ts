/** Shares of the pixel ratio that the governor chooses among; each step leaves out about a third of the pixels. */
export const SCALES: readonly number[] = [1, 0.84, 0.71, 0.59, 0.5];

/** Milliseconds between frames that are still smooth: those of a 50 Hz screen, and some slack. */
const BUDGET_MS = 22;
/** Slack of frames that are meant to come more rarely. */
const SLACK = 1.3;
// Programs are compiled and buffers are made in the first frames.
const WARM_UP_FRAMES = 12;
// A window ends when it is long enough and holds enough frames for its median to ignore a pause or two.
const WINDOW_MS = 500;
const WINDOW_FRAMES = 8;
/** So many slow windows one after the other are no passing load. */
const SLOW_WINDOWS = 2;
/** Calm milliseconds after which more pixels are tried. Each attempt that fails doubles the wait for the next. */
const RETRY_DELAY_MS = 4_000;
const MAX_RETRY_DELAY_MS = 120_000;
/** Where a quarter of the pixels takes more than this share of the time, pixels are not what takes it. */
const FUTILE = 0.9;
const FUTILE_REST_MS = 300_000;

/**
 * Holds a budget of time for each frame by drawing fewer pixels, never less smoke. It looks at the median time between
 * frames over half a second: one long frame, as of a garbage collection, means nothing. Down it goes after two slow
 * windows in a row, up one step at a time and ever more rarely where that has failed. Where fewer pixels do not help,
 * as with a slow processor or a screen of 30 Hz, it gives all pixels back.
 */
export class Governor {
  private readonly budgetMs: number;
  private level = 0;
  private last: number | undefined;
  private framesToIgnore = WARM_UP_FRAMES;
  private times: number[] = [];
  private windowMs = 0;
  private slowWindows = 0;
  private calmMs = 0;
  private retryDelayMs = RETRY_DELAY_MS;
  private hasClimbed = false;
  /** Median of the frames that the way down from full scale began with. */
  private fullScaleMs = 0;
  private restMs = 0;

  /** @param intervalMs shortest time between frames, where somebody wants fewer than the screen shows */
  constructor(intervalMs = 0) {
    this.budgetMs = Math.max(BUDGET_MS, SLACK * intervalMs);
  }

  /** Share of the pixel ratio to draw with, one of `SCALES`. */
  get scale(): number {
    return SCALES[this.level];
  }

  /** A frame begins. @param now milliseconds, as from requestAnimationFrame */
  tick(now: number): void {
    const elapsed = this.last === undefined ? 0 : now - this.last;
    this.last = now;
    if (this.framesToIgnore > 0) {
      this.framesToIgnore -= 1;
      return;
    }
    this.times.push(elapsed);
    this.windowMs += elapsed;
    this.restMs = Math.max(0, this.restMs - elapsed);
    if (this.times.length >= WINDOW_FRAMES && this.windowMs >= WINDOW_MS) this.judge();
  }

  /** Frames pause or change their size: what passes until the next ones means nothing. The scale stays. */
  rest(): void {
    this.last = undefined;
    this.framesToIgnore = WARM_UP_FRAMES;
    this.slowWindows = 0;
    this.calmMs = 0;
    this.clearWindow();
  }

  private judge(): void {
    const median = [...this.times].sort((a, b) => a - b)[this.times.length >> 1];
    if (median > this.budgetMs) this.fallBehind(median);
    else this.keepUp();
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
    if (this.level === SCALES.length - 1) this.giveBackIfFutile(median);
    else this.descend(median);
  }

  private descend(median: number): void {
    if (this.level === 0) this.fullScaleMs = median;
    if (!this.hasClimbed) return this.moveTo(this.levelFor(median), false);
    this.retryDelayMs = Math.min(2 * this.retryDelayMs, MAX_RETRY_DELAY_MS);
    this.moveTo(this.level + 1, false);
  }

  /** The first lower level that fits the budget if time follows pixels. */
  private levelFor(median: number): number {
    const wanted = this.scale * Math.sqrt(this.budgetMs / median);
    const fitting = SCALES.findIndex((scale, level) => level > this.level && scale <= wanted);
    return fitting < 0 ? SCALES.length - 1 : fitting;
  }

  private giveBackIfFutile(median: number): void {
    if (median < FUTILE * this.fullScaleMs) return;
    this.moveTo(0, false);
    this.restMs = FUTILE_REST_MS;
  }

  private keepUp(): void {
    this.slowWindows = 0;
    this.calmMs += this.windowMs;
    if (this.calmMs < this.retryDelayMs) return;
    // What was climbed to has held.
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
