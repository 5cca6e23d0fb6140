import type { FrameView } from '../../gpu/frameView.ts';

/** A box in pixels around the pictures of balls. */
export class PixelBox {
  left = 0;
  low = 0;
  right = 0;
  high = 0;
  private readonly isPerspective: boolean;
  private readonly near: number;
  private readonly width: number;
  private readonly height: number;
  /** Pixels for each unit of slope, or for each metre of an orthographic camera, and pixel of the view axis. */
  private readonly scaleX: number;
  private readonly scaleY: number;
  private readonly axisX: number;
  private readonly axisY: number;

  constructor({ uniforms }: FrameView) {
    const e = uniforms.clipFromView.value.elements;
    const { x, y } = uniforms.viewport.value;
    this.isPerspective = e[11] !== 0;
    this.near = uniforms.near.value;
    [this.width, this.height] = [x, y];
    [this.scaleX, this.scaleY] = [0.5 * x * e[0], 0.5 * y * e[5]];
    this.axisX = 0.5 * x * (1 + (this.isPerspective ? -e[8] : e[12]));
    this.axisY = 0.5 * y * (1 + (this.isPerspective ? -e[9] : e[13]));
  }

  clear(): void {
    this.left = this.low = Infinity;
    this.right = this.high = -Infinity;
  }

  /** Whether the box has no pixels of the picture. */
  get isEmpty(): boolean {
    return !(this.left < this.width && this.right > 0 && this.low < this.height && this.high > 0);
  }

  /** Extends the box by a ball in view space, metres; the part behind the near plane does not count. */
  extend(x: number, y: number, distance: number, radius: number): void {
    const far = distance + radius;
    if (far <= this.near) return;
    const close = this.isPerspective ? Math.max(distance - radius, this.near) : 1;
    const away = this.isPerspective ? far : 1;
    this.left = Math.min(this.left, this.axisX + this.scaleX * slope(x - radius, away, close));
    this.low = Math.min(this.low, this.axisY + this.scaleY * slope(y - radius, away, close));
    this.right = Math.max(this.right, this.axisX + this.scaleX * slope(x + radius, close, away));
    this.high = Math.max(this.high, this.axisY + this.scaleY * slope(y + radius, close, away));
  }

  /** Reduces the box to the picture. */
  crop(): void {
    this.left = Math.max(0, this.left);
    this.low = Math.max(0, this.low);
    this.right = Math.min(this.width, this.right);
    this.high = Math.min(this.height, this.high);
  }
}

function slope(aside: number, distanceIfPositive: number, distanceIfNegative: number): number {
  return aside / (aside > 0 ? distanceIfPositive : distanceIfNegative);
}
