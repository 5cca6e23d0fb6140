/** Runs in a page: the hashes of presets, with the simulators that the page loads. */
import { loadSimulators } from '../../../src/simulator/load.ts';
import { hashesOf } from '../../support/sim/presetHashes.ts';

/** @param moments simulated seconds, ascending @returns the hashes by seconds */
export function hashesInPage(name: string, moments: readonly number[]): Promise<Record<string, string>> {
  return hashesOf(name, moments, (physics) => loadSimulators({ physics }));
}
