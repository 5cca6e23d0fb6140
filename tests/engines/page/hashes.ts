/** Runs in a page: the hashes of presets, with the simulators that the page loads. */
import { loadSimulators } from '../../../src/sim/load.ts';
import { hashesOf } from '../../support/presetHashes.ts';

/** @returns the hash after so many simulated seconds each, which ascend, by the seconds */
export function hashesInPage(name: string, moments: readonly number[]): Promise<Record<string, string>> {
  return hashesOf(name, moments, (physics) => loadSimulators({ physics }));
}
