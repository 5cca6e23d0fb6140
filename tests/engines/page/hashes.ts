/** Runs in a page: the hashes of presets, without drawing. */
import { findPreset, presetValues } from '../../../src/preset/presets.ts';
import { withDrops } from '../../../src/scenes/drops.ts';
import { sceneNamed } from '../../../src/scenes/scenes.ts';
import { STEP_SECONDS } from '../../../src/sim/clock.ts';
import { loadSimulators } from '../../../src/sim/load.ts';
import { Simulation } from '../../../src/stage/simulation.ts';

/** @returns the hash after so many simulated seconds each, which ascend, by the seconds */
export async function hashesOf(name: string, moments: readonly number[]): Promise<Record<string, string>> {
  const values = presetValues(findPreset(name)!);
  const { load, hasRigids } = sceneNamed(values.scene as string);
  // As `openScene` does: where there is physics, things can be dropped.
  const scene = hasRigids ? withDrops(await load()) : await load();
  const simulation = new Simulation(await loadSimulators({ physics: hasRigids }), scene, values, 0);
  const hashes = moments.map((seconds) => {
    simulation.advance(Math.round(seconds / STEP_SECONDS) - simulation.simulator.steps);
    return [seconds, simulation.simulator.hash()];
  });
  simulation.dispose();
  return Object.fromEntries(hashes) as Record<string, string>;
}
