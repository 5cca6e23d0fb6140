import { nextTask } from '../work.ts';
import type { SeekOptions } from './contract.ts';
import type { Simulation } from './simulation.ts';

// Long seeks yield to the event loop this often, milliseconds.
const SLICE_MS = 30;

/**
 * Steps until `goal` is reached, in time slices, so that the page stays responsive.
 * @param isEnded called after each slice: whether the stage has been disposed
 */
export async function advanceTo(
  goal: number,
  simulation: Simulation,
  { onProgress, signal }: SeekOptions,
  isEnded: () => boolean,
): Promise<void> {
  const first = simulation.simulator.steps;
  while (simulation.simulator.steps < goal) {
    simulation.advanceFor(SLICE_MS, goal);
    onProgress?.((simulation.simulator.steps - first) / (goal - first));
    await nextTask();
    signal?.throwIfAborted();
    if (isEnded()) return;
  }
}
