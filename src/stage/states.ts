/** A simulation saved after so many steps. */
export interface SavedState {
  readonly step: number;
  readonly bytes: Uint8Array;
}

/**
 * Saved states by step, within a budget. When it is spent, states go so that those that stay lie ever farther apart
 * the longer ago they are: a seek to any moment then steps on from one that is near for how far back it is.
 */
export class SavedStates {
  private readonly budget: number;
  private states: SavedState[] = [];
  private size = 0;

  /** @param budget in bytes */
  constructor(budget: number) {
    this.budget = budget;
  }

  /** How many bytes they have together. */
  get bytes(): number {
    return this.size;
  }

  get count(): number {
    return this.states.length;
  }

  has(step: number): boolean {
    return this.states.some((state) => state.step === step);
  }

  /** Keeps a state at a step that has none. */
  add(state: SavedState): void {
    const at = this.states.findIndex(({ step }) => step > state.step);
    this.states.splice(at < 0 ? this.states.length : at, 0, state);
    this.size += state.bytes.length;
    while (this.size > this.budget) this.remove(this.indexToDrop());
  }

  /** The latest state that is not later than `step`. */
  latest(step: number): SavedState | undefined {
    return this.states.findLast((state) => state.step <= step);
  }

  /** Drops what was saved at `step` or later: from there on things went otherwise. */
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

  /** The state without which the gap is smallest, compared with how long ago it is. The last goes only by itself. */
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
