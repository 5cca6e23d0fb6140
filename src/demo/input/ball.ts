import type { Stage } from '../../index.ts';

const METRES_PER_SECOND = 0.9;
// A tap moves the ball at once. Slow frames move it by a limited distance.
const FIRST_SECONDS = 1 / 30;
const LONGEST_SECONDS = 0.1;

/** Moves the stage's rigid along the screen axes while keys are down. */
export class BallKeys {
  private readonly stage: Stage;
  private direction = [0, 0, 0];
  private request = 0;
  private last = 0;

  constructor(stage: Stage) {
    this.stage = stage;
  }

  /** @param right, up, near -1, 0 or 1 each; all 0 stops */
  push(right: number, up: number, near: number): void {
    const wasResting = this.request === 0;
    this.direction = [right, up, near];
    if (!wasResting || !this.isPushed) return;
    this.move(FIRST_SECONDS);
    this.last = performance.now();
    this.request = requestAnimationFrame(this.tick);
  }

  private get isPushed(): boolean {
    return this.direction.some((part) => part !== 0);
  }

  private readonly tick = (now: number): void => {
    this.request = this.isPushed ? requestAnimationFrame(this.tick) : 0;
    if (this.request === 0) return;
    this.move(Math.min(Math.max(now - this.last, 0) / 1000, LONGEST_SECONDS));
    this.last = now;
  };

  private move(seconds: number): void {
    const metres = METRES_PER_SECOND * seconds;
    const [right, up, near] = this.direction.map((part) => part * metres);
    const azimuth = this.stage.camera.azimuth();
    const [cosine, sine] = [Math.cos(azimuth), Math.sin(azimuth)];
    this.stage.nudge({ dx: right * cosine + near * sine, dy: up, dz: near * cosine - right * sine });
  }
}
