/** Dropped objects: which one falls, where it lands, and its replay in a take. */
import { Vector3 } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { withDrops } from '../../../src/scenes/drops.ts';
import type { Scene } from '../../../src/scenes/scene.ts';
import { sceneEntries } from '../../../src/scenes/scenes.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { POSE_FLOATS } from '../../../src/simulator/layout.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const withPhysics = Object.keys(sceneEntries).filter((name) => sceneEntries[name].hasRigids);
let factory: SimulatorFactory;

beforeAll(async () => {
  factory = await loadVariant('physics');
});

async function begin(name: string): Promise<{ simulation: Simulation; scene: Scene }> {
  const scene = withDrops(await sceneEntries[name].load());
  return { scene, simulation: new Simulation(factory, scene, presetValues(findPreset(name)!), 1e8) };
}

function placesOf({ simulator }: Simulation, rigids: readonly number[]): Vector3[] {
  const poses = simulator.rigidPoses(1);
  return rigids.map((rigid) => new Vector3().fromArray(poses, POSE_FLOATS * rigid));
}

describe.each(withPhysics)('in the scene %s', (name) => {
  test('drops the farthest object, which falls freely; after all of them the first one is dropped again', async () => {
    const { simulation, scene } = await begin(name);
    const drops = scene.drops!;
    expect(simulation.dropCount).toBe(drops.length);
    simulation.advance(30);
    for (let count = 0; count <= drops.length; count++) {
      const place = new Vector3(0.5 * count - 1.5, 5, 0.2);
      const before = placesOf(simulation, drops).map((at) => at.distanceTo(place));
      const farthest = before.indexOf(Math.max(...before));
      simulation.drop(place);
      simulation.advance(12);
      const fallen = placesOf(simulation, drops)[farthest].sub(place);
      expect(Math.hypot(fallen.x, fallen.z)).toBeLessThan(0.02);
      expect(fallen.y).toBeCloseTo((-9.81 * 0.2 ** 2) / 2, 1);
      simulation.advance(20);
    }
    if (scene.name !== 'dust') expect(placesOf(simulation, drops).every(({ y }) => y > -60)).toBe(true);
    simulation.dispose();
  });

  test('a take repeats it with the same hash, also after seeking back', async () => {
    const { simulation } = await begin(name);
    simulation.advance(20);
    simulation.drop(new Vector3(0.3, 2, 0));
    const before = simulation.simulator.hash();
    simulation.advance(40);
    simulation.drop(new Vector3(-0.3, 2.2, 0.3));
    simulation.advance(80);
    const [hash, take] = [simulation.simulator.hash(), simulation.simulator.take('')];
    simulation.approach(20);
    simulation.advance(140 - simulation.simulator.steps);
    expect(simulation.simulator.hash()).toBe(hash);
    const { simulation: other } = await begin(name);
    other.replay(take, presetValues(findPreset(name)!));
    other.advance(20);
    expect(other.simulator.hash()).toBe(before);
    other.advance(120);
    expect(other.simulator.hash()).toBe(hash);
    other.dispose();
    simulation.dispose();
  });
});

test('an object dropped while paused is drawn at its start until the next step', async () => {
  const { simulation, scene } = await begin('lamp');
  simulation.advance(10);
  for (const x of [0.5, 0.7, 0.9]) simulation.drop(new Vector3(x, 2, 0));
  const shown = simulation.rigids(1);
  const places = scene.drops!.map((rigid) => new Vector3().setFromMatrixPosition(shown[rigid]).x);
  const put = places.filter((x) => x > 0.4).map((x) => x.toFixed(1));
  expect(put.toSorted()).toEqual(['0.5', '0.7', '0.9']);
  simulation.approach(0);
  expect(placesOf(simulation, scene.drops!).every(({ y }) => y < -400)).toBe(true);
  simulation.dispose();
});

test('objects come to rest on the ground of each scene that has one', async () => {
  for (const name of ['lamp', 'train', 'rocket', 'genie']) {
    const { simulation, scene } = await begin(name);
    simulation.advance(2);
    simulation.drop(new Vector3(1.1, -3, 1));
    simulation.advance(100);
    const lying = placesOf(simulation, scene.drops!).filter(({ y }) => y > -50);
    expect(lying, name).toHaveLength(1);
    expect(lying[0].y, name).toBeGreaterThan(0.1);
    expect(lying[0].y, name).toBeLessThan(0.7);
    simulation.dispose();
  }
});
