import { Clock } from '../simulator/clock.ts';
import { Governor } from './governor.ts';

/** With a frame rate limit, a frame may be this much early: display timing is not exact to the millisecond. */
const EARLY_MS = 4;

/** Callbacks of a frame loop. */
export interface FrameTasks {
  /** Whether earlier frames are still being drawn, so that the next frame is skipped. */
  readonly isBehind: boolean;
  /** Takes this many steps (often 0) and draws the result. */
  frame(steps: number): void;
  /** Called when a frame throws; the loop is stopped. */
  fail(error: Error): void;
}

/** Plays the simulation: each display frame takes the steps for the elapsed time. */
export class FrameLoop {
  readonly clock = new Clock();
  /** Whether frames are skipped, for example during a seek. */
  isHeld = false;
  private readonly tasks: FrameTasks;
  private readonly governor: Governor;
  private readonly intervalMs: number;
  private request = 0;
  private dueAt = 0;
  private isRunning = false;
  private hasViewers = true;

  /** @param frameRate maximum frames per second. Default: the display's refresh rate */
  constructor(tasks: FrameTasks, frameRate = Infinity) {
    this.tasks = tasks;
    this.intervalMs = 1000 / frameRate;
    this.governor = new Governor(this.intervalMs);
  }

  get isPlaying(): boolean {
    return this.isRunning;
  }

  /**
   * Whether the canvas is visible. While it is not, no frames are requested and no time passes, but `isPlaying` stays
   * true.
   */
  get isSeen(): boolean {
    return this.hasViewers;
  }

  set isSeen(isSeen: boolean) {
    if (isSeen === this.hasViewers) return;
    this.hasViewers = isSeen;
    if (!this.isRunning) return;
    if (isSeen) this.begin();
    else this.end();
  }

  /**
   * Fraction of the pixel ratio at which frames keep their budget; 1 when not playing or while held, so that pictures
   * are reproducible.
   */
  get scale(): number {
    return this.isRunning && !this.isHeld ? this.governor.scale : 1;
  }

  /** @returns whether the state changed, as `stop` does */
  play(): boolean {
    if (this.isRunning) return false;
    this.isRunning = true;
    if (this.hasViewers) this.begin();
    return true;
  }

  stop(): boolean {
    if (!this.isRunning) return false;
    this.isRunning = false;
    this.end();
    return true;
  }

  /** Resets the governor's measurement after the picture size changes. */
  pauseGovernor(): void {
    this.governor.pause();
  }

  private begin(): void {
    this.clock.pause();
    this.governor.pause();
    this.request = requestAnimationFrame(this.tick);
  }

  private end(): void {
    cancelAnimationFrame(this.request);
    this.clock.pause();
  }

  private isDue(now: number): boolean {
    if (now < this.dueAt - EARLY_MS) return false;
    this.dueAt = Math.max(this.dueAt + this.intervalMs, now);
    return true;
  }

  private readonly tick = (now: number): void => {
    if (!this.isRunning || !this.hasViewers) return;
    this.request = requestAnimationFrame(this.tick);
    if (this.tasks.isBehind || !this.isDue(now)) return;
    if (this.isHeld) return this.governor.pause();
    this.governor.tick(now);
    const isFirst = this.clock.isPaused;
    const steps = this.clock.tick(now);
    // No time has passed since playback started. The picture is up to date, and drawing it again would delay the next
    // one.
    if (isFirst && steps === 0) return;
    try {
      this.tasks.frame(steps);
    } catch (error) {
      this.stop();
      this.tasks.fail(error as Error);
    }
  };
}
