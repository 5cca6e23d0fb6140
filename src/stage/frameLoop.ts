import { Clock } from '../sim/clock.ts';
import { Governor } from './governor.ts';

/** A frame of a capped loop may come so much earlier than it is due: screens do not keep time to the millisecond. */
const EARLY_MS = 4;

/** What a loop calls on. */
export interface FrameTasks {
  /** Whether frames before are still being drawn, so that the next one had better come later. */
  readonly isBehind: boolean;
  /** Takes so many steps, often 0, and shows what is then. */
  frame(steps: number): void;
  /** A frame has failed, and the loop has stopped. */
  fail(error: Error): void;
}

/** Plays: with each picture that the screen shows come the steps for the time that has passed. */
export class FrameLoop {
  readonly clock = new Clock();
  /** Whether frames are left out, as while a seek goes its way. */
  isHeld = false;
  private readonly tasks: FrameTasks;
  private readonly governor: Governor;
  private readonly intervalMs: number;
  private request = 0;
  private dueAt = 0;
  private isRunning = false;
  private hasViewers = true;

  /** @param frameRate most frames a second; as many as the screen shows when left out */
  constructor(tasks: FrameTasks, frameRate = Infinity) {
    this.tasks = tasks;
    this.intervalMs = 1000 / frameRate;
    this.governor = new Governor(this.intervalMs);
  }

  get isPlaying(): boolean {
    return this.isRunning;
  }

  /** Whether anybody can see the frames. While nobody can, none come and no time passes, though it goes on playing. */
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

  /** Share of the pixel ratio that frames come in time with. Where pictures must come again the same, it is 1. */
  get scale(): number {
    return this.isRunning && !this.isHeld ? this.governor.scale : 1;
  }

  /** Whether that changed something; likewise below. */
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

  /** What passes until the next frames means nothing: pictures have another size now. */
  restGovernor(): void {
    this.governor.rest();
  }

  private begin(): void {
    this.clock.rest();
    this.governor.rest();
    this.request = requestFrame(this.tick);
  }

  private end(): void {
    cancelFrame(this.request);
    this.clock.rest();
  }

  private isDue(now: number): boolean {
    if (now < this.dueAt - EARLY_MS) return false;
    this.dueAt = Math.max(this.dueAt + this.intervalMs, now);
    return true;
  }

  private readonly tick = (now: number): void => {
    if (!this.isRunning || !this.hasViewers) return;
    this.request = requestFrame(this.tick);
    if (this.tasks.isBehind || !this.isDue(now)) return;
    if (this.isHeld) return this.governor.rest();
    this.governor.tick(now);
    const isFirst = this.clock.isResting;
    const steps = this.clock.tick(now);
    // No time has passed since playing began: what is shown is right, and drawing it again would hold the next picture up.
    if (isFirst && steps === 0) return;
    try {
      this.tasks.frame(steps);
    } catch (error) {
      this.stop();
      this.tasks.fail(error as Error);
    }
  };
}

/** The screen's next frame, on pages and in workers. */

const INTERVAL_MS = 1000 / 60;

/** Some browsers give workers a canvas but no frames; a timer stands in for them. */
function requestFrame(callback: (now: number) => void): number {
  if ('requestAnimationFrame' in globalThis) return requestAnimationFrame(callback);
  const now = performance.now();
  return Number(setTimeout(() => callback(performance.now()), INTERVAL_MS - (now % INTERVAL_MS)));
}

function cancelFrame(request: number): void {
  if ('cancelAnimationFrame' in globalThis) cancelAnimationFrame(request);
  else clearTimeout(request);
}
