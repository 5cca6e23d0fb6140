/** Dust: a harder impact on the sand raises more of it, and without motion there is none. */
import { Vector3 } from 'three';
import { beforeAll, expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { dust } from '../../../src/scenes/dust.ts';
import { BY_HIT, DUST_RATE, POWER } from '../../../src/scenes/dustRule.ts';
import type { Scene, Vector } from '../../../src/scenes/scene.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { POSE_FLOATS } from '../../../src/simulator/layout.ts';
import { Drag } from '../../../src/stage/drag.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const preset = presetValues(findPreset('dust')!);
const values = { ...preset, 'emission.lifetime': 60, 'forces.turbulence': 0 };
const [BALL, CRATE, MOLE] = [0, 1, 4];
let factory: SimulatorFactory;

beforeAll(async () => {
  factory = await loadVariant('physics');
});

/** The scene with one toy; the others and the mole are far away. */
function alone(toy: number, position: Vector, restitution = 0): Simulation {
  const scene = dust();
  const rigids = scene.rigids.map((rigid, index): Scene['rigids'][number] => {
    if (index === toy) return { ...rigid, position, rotation: [0, 0, 0, 1], restitution };
    return index <= MOLE ? { ...rigid, position: [0, -500, 0], kind: 'fixed' } : { ...rigid, restitution: 0 };
  });
  return new Simulation(factory, { ...scene, guide: undefined, rigids }, values, 1e6);
}

/** Puffs that an impact raises within half a second, and the impact speed (m/s). */
function fall(toy: number, size: number, metres: number): { puffs: number; speed: number } {
  const simulation = alone(toy, [0, size + metres, 0]);
  const seconds = Math.sqrt((2 * metres) / 9.81);
  simulation.advance(Math.round(60 * (seconds + 0.5)));
  const puffs = simulation.simulator.alive;
  simulation.dispose();
  return { puffs, speed: 9.81 * seconds };
}

test.each([
  ['ball', BALL, 0.42],
  ['crate', CRATE, 0.34],
] as const)('a %s that hits harder raises more dust, by the law of the scene', (_, toy, size) => {
  const falls = [0.1, 0.4, 1, 2].map((metres) => fall(toy, size, metres));
  for (const [index, { puffs, speed }] of falls.entries()) {
    const expected = BY_HIT * speed ** POWER;
    // Tolerance: one step of the fall, and the fraction of a puff that is still due.
    expect(puffs).toBeGreaterThan(0.9 * expected - 1);
    expect(puffs).toBeLessThan(1.1 * expected + 1);
    if (index > 0) expect(puffs).toBeGreaterThan(1.5 * falls[index - 1].puffs);
  }
});

test('dust rises where the ball hits, and none while it is in the air', () => {
  const simulation = alone(BALL, [1.2, 2.42, 0.4]);
  simulation.advance(36);
  expect(simulation.simulator.alive).toBe(0);
  simulation.advance(8);
  const { x, z } = readParticles(simulation.simulator);
  expect(x.length).toBeGreaterThan(10);
  for (const [i, at] of x.entries()) expect(Math.hypot(at - 1.2, z[i] - 0.4)).toBeLessThan(0.8);
  simulation.dispose();
});

test('a bouncing ball raises less dust at each hit', () => {
  const simulation = alone(BALL, [0, 2.4, 0], 0.9);
  const spawned: number[] = [];
  let alive = 0;
  for (let step = 0; step < 150; step++) {
    simulation.advance(1);
    if (simulation.simulator.alive > alive) spawned.push(simulation.simulator.alive - alive);
    alive = simulation.simulator.alive;
  }
  expect(spawned.length).toBeGreaterThanOrEqual(3);
  const [first, second, third] = spawned;
  expect(second).toBeLessThan(first);
  expect(third).toBeLessThan(second);
  simulation.dispose();
});

test('a rolling ball leaves a trail, and resting objects raise no dust', () => {
  const still = alone(BALL, [0, 0.42, 0]);
  still.advance(120);
  expect(still.simulator.alive).toBe(0);
  const drag = new Drag(still, still.scene.handle!);
  drag.moveTo(new Vector3(1.5, 0.45, 0));
  still.advance(6);
  drag.letGo();
  still.advance(50);
  const { x } = readParticles(still.simulator);
  expect(Math.max(...x) - Math.min(...x)).toBeGreaterThan(0.8);
  still.dispose();
});

test('the preset has the rate that the rule assumes', () => {
  expect(preset['emission.rate']).toBe(DUST_RATE);
});

test('a thrown ball keeps its velocity', () => {
  const simulation = new Simulation(factory, dust(), values, 1e6);
  simulation.advance(10);
  const drag = new Drag(simulation, simulation.scene.handle!);
  for (let step = 0; step < 20; step++) {
    drag.moveTo(new Vector3(-1 + 0.1 * step, 2.5, 0));
    simulation.advance(1);
  }
  drag.letGo();
  simulation.advance(2);
  const [before] = simulation.simulator.rigidPoses(1);
  simulation.advance(10);
  expect(simulation.simulator.rigidPoses(1)[0] - before).toBeGreaterThan(0.3);
  simulation.dispose();
});

test('a ball dragged while paused moves there before it falls', () => {
  const simulation = alone(BALL, [0, 0.42, 0]);
  simulation.advance(10);
  const drag = new Drag(simulation, simulation.scene.handle!);
  drag.moveTo(new Vector3(1, 2, 0));
  drag.letGo();
  simulation.advance(29);
  const [x, y] = simulation.simulator.rigidPoses(1);
  expect(Math.hypot(x - 1, y - 2)).toBeLessThan(0.05);
  simulation.advance(30);
  expect(simulation.simulator.rigidPoses(1)[1]).toBeLessThan(1.5);
  simulation.dispose();
});

test('the mole kicks each toy within a minute, and toys that fall off return', () => {
  const simulation = new Simulation(factory, dust(), preset, 1e6);
  const kicked = new Set<number>();
  let lowest = 0;
  const before = [0, 0, 0, 0];
  for (let step = 0; step < 3600; step++) {
    simulation.advance(1);
    const poses = simulation.simulator.rigidPoses(1);
    for (const toy of [0, 1, 2, 3]) {
      const y = poses[POSE_FLOATS * toy + 1];
      if (60 * (y - before[toy]) > 2 && y < 1.2) kicked.add(toy);
      before[toy] = y;
      lowest = Math.min(lowest, y);
    }
  }
  expect(kicked.size).toBe(4);
  expect(lowest).toBeGreaterThan(-7);
  simulation.dispose();
});

test('links do not contain values set by the rule', () => {
  const simulation = new Simulation(factory, dust(), preset, 1e6);
  simulation.advance(60);
  expect(Object.keys(simulation.valuesIn(preset)).filter((key) => key.startsWith('emitters.'))).toEqual([]);
  simulation.dispose();
});

test('ten seconds of its smoke fit into the capacity', () => {
  const simulation = new Simulation(factory, dust(), preset, 1e6);
  let most = 0;
  for (let step = 0; step < 600; step++) {
    simulation.advance(1);
    expect(simulation.simulator.waiting).toBe(0);
    most = Math.max(most, simulation.simulator.alive);
  }
  expect(most).toBeGreaterThan(100);
  simulation.dispose();
});
