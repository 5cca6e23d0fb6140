/** How much coarser the grid of a mesh can be. Deviations are in metres. */
import { cos } from '../../simulator/exact/sine.ts';

/** Every n-th number from 0, and the last one. */
export function every(stride: number, last: number): number[] {
  return [...Array.from({ length: Math.ceil(last / stride) }, (_, index) => stride * index), last];
}

/** The largest stride along the segments of a circle whose chords deviate from it by at most this. At least four stay. */
export function strideWithin(deviation: number, radius: number, segments: number): number {
  return largest(segments / 4, (stride) => radius * (1 - cos((Math.PI * stride) / segments)) <= deviation);
}

/** The largest whole number above 1 for which this and all smaller ones hold, up to a limit; else 1. */
export function largest(limit: number, holds: (number: number) => boolean): number {
  let number = 1;
  while (number + 1 <= limit && holds(number + 1)) number++;
  return number;
}
