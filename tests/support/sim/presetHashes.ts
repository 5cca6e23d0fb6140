/**
 * The hash of each preset after some seconds, without rendering. The expected values are in
 * `tests/engines/hashes.json`.
 */
import type { AnyValues } from '../../../src/parameters/parameter.ts';
import { findPreset, presets, presetValues } from '../../../src/parameters/presets.ts';
import { fetchTimelineText } from '../../../src/renderer/extraPasses.ts';
import { withDrops } from '../../../src/scenes/drops.ts';
import { sceneNamed } from '../../../src/scenes/scenes.ts';
import { STEP_SECONDS } from '../../../src/simulator/clock.ts';
import type { SimulatorFactory, Variant } from '../../../src/simulator/load.ts';
import { hasRareForces } from '../../../src/simulator/rareForces.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { Simulation } from '../../../src/stage/simulation.ts';

/** Hashes of 16 hexadecimal digits by simulated seconds, by preset name. */
export type HashList = Record<string, Record<string, string>>;

/** Returns the simulators of a variant. */
type FactoryFor = (variant: Variant['name']) => Promise<SimulatorFactory>;

export const HASH_LIST = new URL('../../engines/hashes.json', import.meta.url);

/** Simulated seconds. */
const MOMENTS = [2, 8, 20];

/** @returns the list of all presets. Those that differ in nothing that the simulator receives are simulated once. */
export async function presetHashes(factoryFor: FactoryFor): Promise<HashList> {
  const known = new Map<string, Record<string, string>>();
  const list: HashList = {};
  for (const { name } of presets) {
    const motion = motionOf(name);
    if (!known.has(motion)) known.set(motion, await hashesOf(name, MOMENTS, factoryFor));
    list[name] = known.get(motion)!;
  }
  return list;
}

/** The variant that a scene needs with values. */
export function variantOf(hasRigids: boolean, values: AnyValues): Variant['name'] {
  return hasRigids ? 'physics' : hasRareForces(values) ? 'meshes' : 'core';
}

/** Everything of a preset that its motion depends on. */
export function motionOf(name: string): string {
  const values = presetValues(findPreset(name)!);
  const { scene, seed, timeline } = values;
  return JSON.stringify([scene, seed, timeline, values['simulation.maxParticles'], simulatorValues(values)]);
}

/** @param moments simulated seconds, ascending */
export async function hashesOf(
  name: string,
  moments: readonly number[],
  factoryFor: FactoryFor,
): Promise<Record<string, string>> {
  const values = await fetchTimelineText(presetValues(findPreset(name)!));
  const { load, hasRigids } = sceneNamed(values.scene as string);
  // As in `openScene`: with physics the scene has drops.
  const scene = hasRigids ? withDrops(await load()) : await load();
  const simulation = new Simulation(await factoryFor(variantOf(hasRigids, values)), scene, values, 0);
  const hashes = moments.map((seconds) => {
    simulation.advance(Math.round(seconds / STEP_SECONDS) - simulation.simulator.steps);
    return [seconds, simulation.simulator.hash()];
  });
  simulation.dispose();
  return Object.fromEntries(hashes) as Record<string, string>;
}
