import { describe, expect, it } from 'vitest';
import { Clock, STEP_SECONDS } from '../../../src/simulator/clock.ts';

const FRAME = 1000 / 60;

/** Time of the picture, in steps, after each of `frames` ticks of `interval` milliseconds. */
function pictureTimes(speed: number, interval: number, frames: number): number[] {
  const clock = new Clock();
  clock.speed = speed;
  let steps = 0;
  return Array.from({ length: frames }, (_, frame) => {
    steps += clock.tick(1000 + frame * interval);
    return steps - 1 + clock.blend;
  });
}

function gaps(times: number[]): number[] {
  return times.slice(1).map((time, index) => time - times[index]);
}

describe('Clock', () => {
  it('advances the picture by one step per frame in real time at 60 Hz', () => {
    for (const gap of gaps(pictureTimes(1, FRAME, 100))) expect(gap).toBeCloseTo(1, 6);
  });

  it('advances the picture by half a step per frame at half speed, and at 120 Hz', () => {
    for (const gap of gaps(pictureTimes(0.5, FRAME, 100))) expect(gap).toBeCloseTo(0.5, 6);
    for (const gap of gaps(pictureTimes(1, FRAME / 2, 100))) expect(gap).toBeCloseTo(0.5, 6);
  });

  it('falls into slow motion instead of catching up when a frame takes long', () => {
    const clock = new Clock();
    clock.tick(0);
    expect(clock.tick(5000)).toBe(4);
    expect(clock.tick(5000 + FRAME)).toBeLessThanOrEqual(2);
  });

  it('does not count time in which it rests', () => {
    const clock = new Clock();
    clock.tick(0);
    clock.pause();
    expect(clock.tick(60_000)).toBe(0);
    expect(clock.tick(60_000 + 1.01 * STEP_SECONDS * 1000)).toBe(1);
  });

  it('settles on the latest step', () => {
    const clock = new Clock();
    clock.settle();
    expect(clock.blend).toBe(1);
    expect(clock.tick(0)).toBe(1);
    expect(clock.blend).toBe(0);
  });
});
