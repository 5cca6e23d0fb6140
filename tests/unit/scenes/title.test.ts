/** The title: letters move in the clouds of the timeline, and each is where it was twelve seconds earlier. */
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { readTimeline } from '../../../src/parameters/timeline.ts';
import { title } from '../../../src/scenes/title.ts';

const { parts = [] } = title();
const { timeline, problems } = readTimeline(presetValues(findPreset('title')!).timeline!);
const UPRIGHT = [0, 0, 0, 1];

/** The steps at which a letter starts to rise and to fall, and its steps upright and at rest. */
function moves(letter: number): { rise: number; fall: number } {
  const heights = Array.from({ length: timeline.length }, (_, step) => parts[letter].pose(step / 60).position[1]);
  const hidden = Math.min(...heights);
  const rise = heights.findIndex((height) => height > hidden + 1e-9) - 1;
  const fall = heights.findLastIndex((height) => height >= 0);
  return { rise, fall };
}

test('each letter rises and falls in a cloud of its emitter', () => {
  expect(problems).toEqual([]);
  for (const letter of parts.keys()) {
    const { rise, fall } = moves(letter);
    const bursts = timeline.bursts.filter(({ emitter }) => emitter === letter).map(({ step }) => step);
    expect(Math.abs(bursts[0] - rise)).toBeLessThanOrEqual(1);
    // The cloud has a moment to cover the letter.
    expect(fall - bursts.at(-1)!).toBeGreaterThanOrEqual(3);
    expect(fall - bursts.at(-1)!).toBeLessThan(20);
  }
});

test('all letters stand upright from the fifth second to the eighth, and the sequence repeats', () => {
  for (const { pose } of parts) {
    for (const seconds of [4.5, 5.4, 7, 7.9]) {
      pose(seconds).rotation.forEach((part, axis) => expect(part).toBeCloseTo(UPRIGHT[axis], 2));
      expect(pose(seconds).position[1]).toBeCloseTo(0, 2);
    }
    for (const seconds of [0, 1.7, 3.3, 5.7, 9.9]) {
      const [now, later] = [pose(seconds).position, pose(seconds + timeline.length / 60).position];
      now.forEach((along, axis) => expect(later[axis]).toBeCloseTo(along, 6));
    }
  }
});
