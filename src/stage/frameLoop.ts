import { Clock } from '../simulator/clock.ts';
import { Governor } from './governor.ts';

/** With a frame rate limit, a frame may be this much early: display timing is not exact to the millisecond. */
const EARLY_MS = 4;

/** Limits frames to a rate. */
export class Pace {
  readonly intervalMs: number;
  private dueAt = 0;

  constructor(framesPerSecond = Infinity) {
    this.intervalMs = 1000 / framesPerSecond;
  }

  /** @param now milliseconds, as from requestAnimationFrame */
  isDue(now: number): boolean {
    if (now < this.dueAt - EARLY_MS) return false;
    this.dueAt = Math.max(this.dueAt + this.intervalMs, now);
    return true;
  }
}

/** Frames of a stage that shares them with other stages of its thread. */
export interface Turns {
  /** Whether no stage of the thread steps or draws in this frame. */
  isClosed(now: number): boolean;
  /** Whether the stage draws in this frame. Asked once for each frame that it plays. */
  takeTurn(now: number): boolean;
}

/** Callbacks of a frame loop. */
export interface FrameTasks {
  /** Whether earlier frames are still being drawn, so that the next frame is skipped. */
  readonly isBehind: boolean;
  /** Takes this many steps (often 0) and draws the result, unless it is not the turn of the stage. */
  frame(steps: number, isDrawn: boolean): void;
  /** Called when a frame throws; the loop is stopped. */
  fail(error: Error): void;
}

/** Plays the simulation: each display frame takes the steps for the elapsed time. */
export class FrameLoop {
  readonly clock = new Clock();
  /** Whether frames are skipped, for example during a seek. */
  isHeld = false;
  private readonly tasks: FrameTasks;
  private readonly turns: Turns | undefined;
  private readonly governor: Governor;
  private readonly pace: Pace;
  private request = 0;
  private isRunning = false;
  private hasViewers = true;

  /**
   * @param frameRate maximum frames per second. Default: the display's refresh rate
   * @param turns decides which frames are drawn. Default: all
   */
  constructor(tasks: FrameTasks, frameRate?: number, turns?: Turns) {
    this.tasks = tasks;
    this.turns = turns;
    this.pace = new Pace(frameRate);
    this.governor = new Governor(this.pace.intervalMs);
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

  private readonly tick = (now: number): void => {
    if (!this.isRunning || !this.hasViewers) return;
    this.request = requestAnimationFrame(this.tick);
    const { turns } = this;
    if (turns?.isClosed(now) || this.tasks.isBehind || !this.pace.isDue(now)) return;
    if (this.isHeld) return this.governor.pause();
    this.governor.tick(now);
    const isFirst = this.clock.isPaused;
    const steps = this.clock.tick(now);
    // No time has passed since playback started. The picture is up to date, and drawing it again would delay the next
    // one.
    if (isFirst && steps === 0) return;
    try {
      this.tasks.frame(steps, turns?.takeTurn(now) ?? true);
    } catch (error) {
      this.stop();
      this.tasks.fail(error as Error);
    }
  };
}
