import { Clock } from '../sim/clock.ts';
import { Governor } from './governor.ts';

/** What a loop calls on. */
export interface FrameTasks {
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
  private readonly governor = new Governor();
  private request = 0;
  private isRunning = false;

  constructor(tasks: FrameTasks) {
    this.tasks = tasks;
  }

  get isPlaying(): boolean {
    return this.isRunning;
  }

  /** Share of the pixel ratio that frames come in time with. Where pictures must come again the same, it is 1. */
  get scale(): number {
    return this.isRunning && !this.isHeld ? this.governor.scale : 1;
  }

  /** Whether that changed something; likewise below. */
  play(): boolean {
    if (this.isRunning) return false;
    this.isRunning = true;
    this.clock.rest();
    this.governor.rest();
    this.request = requestAnimationFrame(this.tick);
    return true;
  }

  stop(): boolean {
    if (!this.isRunning) return false;
    this.isRunning = false;
    cancelAnimationFrame(this.request);
    this.clock.rest();
    return true;
  }

  /** What passes until the next frames means nothing: pictures have another size now. */
  restGovernor(): void {
    this.governor.rest();
  }

  private readonly tick = (now: number): void => {
    if (!this.isRunning) return;
    this.request = requestAnimationFrame(this.tick);
    if (this.isHeld) return this.governor.rest();
    this.governor.tick(now);
    try {
      this.tasks.frame(this.clock.tick(now));
    } catch (error) {
      this.stop();
      this.tasks.fail(error as Error);
    }
  };
}
