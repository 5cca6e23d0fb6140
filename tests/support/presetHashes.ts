/** The hash of each named preset after some seconds, without drawing: what `tests/engines/hashes.json` lists. */
import { fileURLToPath } from 'node:url';
import { presets, presetValues } from '../../src/preset/presets.ts';
import { withDrops } from '../../src/scenes/drops.ts';
import { sceneNamed } from '../../src/scenes/scenes.ts';
import { STEP_SECONDS } from '../../src/sim/clock.ts';
import type { SimulatorFactory } from '../../src/sim/load.ts';
import { Simulation } from '../../src/stage/simulation.ts';

/** Hashes of 16 hexadecimal digits by simulated seconds, by the name of the preset. */
export type HashList = Record<string, Record<string, string>>;

export const HASH_LIST = fileURLToPath(new URL('../engines/hashes.json', import.meta.url));

/** Simulated seconds. */
const MOMENTS = [2, 8, 20];

/** @param factoryFor gives the simulators with physics, or those without */
export async function presetHashes(factoryFor: (physics: boolean) => Promise<SimulatorFactory>): Promise<HashList> {
  const list: HashList = {};
  for (const preset of presets) {
    const values = presetValues(preset);
    const { load, hasRigids } = sceneNamed(values.scene as string);
    // As `openScene` does: where there is physics, things can be dropped.
    const scene = hasRigids ? withDrops(await load()) : await load();
    const simulation = new Simulation(await factoryFor(hasRigids), scene, values, 0);
    const hashes = MOMENTS.map((seconds) => {
      simulation.advance(Math.round(seconds / STEP_SECONDS) - simulation.simulator.steps);
      return [seconds, simulation.simulator.hash()];
    });
    list[preset.name] = Object.fromEntries(hashes);
    simulation.dispose();
  }
  return list;
}
