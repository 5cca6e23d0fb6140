/** Runs in a page: the hashes of presets, with the simulators that the page loads. */
import { loadSimulators } from '../../../src/simulator/load.ts';
import { MESHES } from '../../../src/simulator/meshes.ts';
import { hashWithMeshes } from '../../support/sim/hashFixture.ts';
import { modelHashes } from '../../support/sim/modelHashes.ts';
import { hashesOf } from '../../support/sim/presetHashes.ts';
import { timelineHashes, timelineValues } from '../../support/sim/timelineHashes.ts';

/** @param moments simulated seconds, ascending @returns the hashes by seconds */
export function hashesInPage(name: string, moments: readonly number[]): Promise<Record<string, string>> {
  return hashesOf(name, moments, (variant) =>
    loadSimulators({ physics: variant === 'meshes' ? MESHES : variant === 'physics' }),
  );
}

export async function hashOfMeshes(fixture: string): Promise<string> {
  return hashWithMeshes(await loadSimulators({ physics: MESHES }), fixture);
}

export async function modelsInPage(): Promise<Record<string, string>> {
  return modelHashes(await loadSimulators({ physics: MESHES }));
}

/** Hashes and values of a timeline. */
export async function timelineInPage(): Promise<{ hashes: Record<string, string>; values: string }> {
  return { hashes: await timelineHashes(await loadSimulators({ physics: false })), values: timelineValues() };
}
