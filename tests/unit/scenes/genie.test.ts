/** The genie: at every called position his chest follows him and his tail connects him to the lamp without a gap. */
import { Vector3 } from 'three';
import { beforeAll, expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { genie } from '../../../src/scenes/genie.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Drag } from '../../../src/stage/drag.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const scene = genie();
const { min, max, start } = scene.handle!;
const values = presetValues(findPreset('genie')!);
let factory: SimulatorFactory;

beforeAll(async () => {
  factory = await loadVariant('physics');
});

/** Six seconds after he is called to a position. */
function calledTo(place: readonly number[], changed: Record<string, number> = {}): Simulation {
  const simulation = new Simulation(factory, scene, values, 1e6);
  simulation.simulator.set(changed);
  simulation.advance(30);
  new Drag(simulation, scene.handle!).moveTo(new Vector3(...place));
  simulation.advance(360);
  return simulation;
}

/** The largest vertical gap between spout and waist that no puff covers, metres. */
function gapInTail(simulation: Simulation): number {
  const { y, size } = readParticles(simulation.simulator);
  const waist = simulation.simulator.rigidPoses(1)[1] + scene.rig['attractors.0.position.y'];
  const spans = Array.from(y, (at, i) => [at - 0.5 * size[i], at + 0.5 * size[i]]).toSorted((a, b) => a[0] - b[0]);
  let [reached, widest] = [scene.rig['emitters.0.position.y'], 0];
  for (const [low, high] of [...spans, [waist, waist]]) {
    if (low > waist) continue;
    widest = Math.max(widest, low - reached);
    reached = Math.max(reached, high);
  }
  return widest;
}

test.each([
  ['where he begins', start],
  ['far to one side', min],
  ['far to the other', max],
])('moved %s, he arrives in one piece', (_, place) => {
  const simulation = calledTo(place);
  const [x, y, z] = simulation.simulator.rigidPoses(1);
  // He sways around the position.
  expect(Math.hypot(x - place[0], y - place[1], z - place[2])).toBeLessThan(0.25);
  expect(gapInTail(simulation)).toBeLessThan(0.02);
  const particles = readParticles(simulation.simulator);
  const chest = [...particles.y.keys()].filter((i) => particles.y[i] > y - 0.25);
  const mean = chest.reduce((sum, i) => sum + particles.x[i], 0) / chest.length;
  expect(chest.length).toBeGreaterThan(60);
  expect(Math.abs(mean - x)).toBeLessThan(0.15);
  simulation.dispose();
});

test('the attractor at his waist pulls the tail to it', () => {
  const simulation = calledTo(max, { 'attractors.0.acceleration': 0 });
  expect(gapInTail(simulation)).toBeGreaterThan(0.2);
  simulation.dispose();
});

test('no smoke covers his face', () => {
  const simulation = calledTo(start);
  const [x, y, z] = simulation.simulator.rigidPoses(1);
  const { x: px, y: py, z: pz } = readParticles(simulation.simulator);
  const nearest = Math.min(...px.map((at, i) => Math.hypot(at - x, py[i] - y - 0.72, pz[i] - z - 0.06)));
  expect(nearest).toBeGreaterThan(0.4);
  simulation.dispose();
});
