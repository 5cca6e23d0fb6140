import type { Simulator } from '../simulator/simulator.ts';

/** A state is saved once per second: saving one takes about as long as two steps. */
const STEPS_BETWEEN_STATES = 60;

/** A simulation state saved after `step` steps. */
export interface SavedState {
  readonly step: number;
  readonly bytes: Uint8Array;
}

/**
 * Saved states by step, within a memory budget. When the budget is exceeded, states are dropped so that the spacing
 * grows with age: a seek takes steps in proportion to how far back it goes.
 */
export class SavedStates {
  private readonly budget: number;
  private states: SavedState[] = [];
  private size = 0;

  /** @param budget in bytes */
  constructor(budget = 64 * 1024 * 1024) {
    this.budget = budget;
  }

  /** Total size in bytes. */
  get bytes(): number {
    return this.size;
  }

  get count(): number {
    return this.states.length;
  }

  has(step: number): boolean {
    return this.states.some((state) => state.step === step);
  }

  /** Saves the state of a simulator if it is due. */
  keep(simulator: Simulator): void {
    const { steps } = simulator;
    if (steps % STEPS_BETWEEN_STATES === 0 && !this.has(steps)) this.add({ step: steps, bytes: simulator.save() });
  }

  /** Adds a state at a step that has none yet. */
  add(state: SavedState): void {
    const at = this.states.findIndex(({ step }) => step > state.step);
    this.states.splice(at < 0 ? this.states.length : at, 0, state);
    this.size += state.bytes.length;
    while (this.size > this.budget) this.remove(this.indexToDrop());
  }

  /** The latest state at or before `step`. */
  latest(step: number): SavedState | undefined {
    return this.states.findLast((state) => state.step <= step);
  }

  /** Drops the states at `step` or later: an input has changed what follows. */
  dropFrom(step: number): void {
    while ((this.states.at(-1)?.step ?? -1) >= step) this.remove(this.states.length - 1);
  }

  clear(): void {
    this.dropFrom(0);
  }

  private remove(index: number): void {
    this.size -= this.states[index].bytes.length;
    this.states.splice(index, 1);
  }

  /**
   * The state whose removal leaves the smallest gap relative to its age. The latest state is removed only if it is the
   * only one.
   */
  private indexToDrop(): number {
    const last = this.states.length - 1;
    const steps = this.states.map(({ step }) => step);
    let [best, least] = [last, Infinity];
    for (let index = 0; index < last; ++index) {
      const gap = steps[index + 1] - (steps[index - 1] ?? 0);
      const share = gap / (steps[last] - steps[index]);
      if (share < least) [best, least] = [index, share];
    }
    return best;
  }
}
