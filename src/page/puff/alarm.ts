import type { StageStats } from '../../stage/contract.ts';

/** Shortest interval in which the simulated time is read, milliseconds. */
const MIN_INTERVAL_MS = 80;
/** Lowest expected speed of the simulation, relative to real time. */
const MIN_SPEED = 0.5;

/** Waits for simulated times, and reads the time only when it expects one. Simulated time starts at 0. */
export class Alarm {
  /** Ends the wait. */
  wake = () => {};
  private readonly read: () => Promise<StageStats>;
  private now = 0;
  private readAt = performance.now();
  private speed = 1;

  constructor(read: () => Promise<StageStats>) {
    this.read = read;
  }

  /**
   * @param time simulated; Infinity waits for `wake`
   * @returns the statistics at about that time; undefined after `wake`
   */
  async wait(time: number): Promise<StageStats | undefined> {
    const { now, readAt, speed } = this;
    const expected = readAt + Math.max(MIN_INTERVAL_MS, (1000 * (time - now)) / speed);
    if (!(await this.sleep(expected - performance.now()))) return undefined;
    const stats = await this.read();
    this.now = stats.time;
    this.readAt = performance.now();
    this.speed = Math.min(1, Math.max(MIN_SPEED, (1000 * (this.now - now)) / (this.readAt - readAt)));
    return stats;
  }

  private async sleep(milliseconds: number): Promise<boolean> {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const isOver = await new Promise<boolean>((resolve) => {
      this.wake = () => resolve(false);
      if (milliseconds < Infinity) timer = setTimeout(() => resolve(true), milliseconds);
    });
    clearTimeout(timer);
    return isOver;
  }
}
