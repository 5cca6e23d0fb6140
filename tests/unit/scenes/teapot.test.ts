/** The teapot: its steam writes the word of its preset, from the spout, and lets it go. */
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { readOutline } from '../../../src/page/outline/outline.ts';
import { teapot } from '../../../src/scenes/teapot.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const values = presetValues(findPreset('teapot')!);

/** Whether a place of the sheet is in an odd number of lines. */
function isInside(x: number, y: number): boolean {
  const lines = readOutline(values['shapes.0.outline']!).flat();
  const crossings = lines.flatMap((line) =>
    line.filter(([ax, ay], at) => {
      const [bx, by] = line[(at + 1) % line.length];
      return ay <= y !== by <= y && ax + ((y - ay) / (by - ay)) * (bx - ax) < x;
    }),
  );
  return crossings.length % 2 === 1;
}

/** The part of the steam that is in the word or nearer to it than 4 units of the sheet. */
function partInWord(simulation: Simulation): number {
  const { x, y } = readParticles(simulation.simulator);
  const points = readOutline(values['shapes.0.outline']!).flat(2);
  const [left, right, top, bottom] = [0, 1].flatMap((axis) => {
    const places = points.map((point) => point[axis]);
    return [Math.min(...places), Math.max(...places)];
  });
  const perMetre = (right - left) / values['shapes.0.size']!;
  const inWord = [...x].filter((along, index) => {
    const column = (left + right) / 2 + (along - values['shapes.0.position.x']!) * perMetre;
    const row = (top + bottom) / 2 - (y[index] - values['shapes.0.position.y']!) * perMetre;
    return [[0, 0], [4, 0], [-4, 0], [0, 4], [0, -4]].some(([across, down]) => isInside(column + across, row + down)); // prettier-ignore
  });
  return inWord.length / x.length;
}

test('steam is in the letters after five seconds, and leaves them afterwards', async () => {
  const simulation = new Simulation(await loadVariant('meshes'), teapot(), values, 0);
  simulation.advance(300);
  expect(simulation.simulator.alive).toBeGreaterThan(500);
  expect(partInWord(simulation)).toBeGreaterThan(0.93);
  simulation.advance(210);
  expect(simulation.simulator.alive).toBeGreaterThan(100);
  // About the share of the area around the letters.
  expect(partInWord(simulation)).toBeLessThan(0.8);
  simulation.dispose();
});
