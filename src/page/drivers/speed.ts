/** Speeds of what moves in CSS pixels, as values from 0 to 1. */
import { requireInRange } from './driver.ts';

/** Default speed that counts as 1, in CSS pixels per second. */
const FULL_SPEED = 2000;

/** @throws ParameterError for an invalid speed */
export function requireSpeed(fullSpeed: unknown = FULL_SPEED): number {
  requireInRange('fullSpeed', fullSpeed, 1, 100_000, 'CSS pixels per second');
  return fullSpeed as number;
}

export class Speed {
  private readonly full: number;
  private distance = 0;
  private value = 0;

  /** @param full speed that counts as 1 */
  constructor(full: number) {
    this.full = full;
  }

  /** Whether the last value was not 0: no event tells the end of a movement. */
  get isMoving(): boolean {
    return this.value > 0;
  }

  /** @param pixels of a movement */
  add(pixels: number): void {
    this.distance += pixels;
  }

  /** The speed since the last call. @param seconds since then */
  over(seconds: number): number {
    this.value = this.distance / seconds / this.full;
    this.distance = 0;
    return this.value;
  }
}
