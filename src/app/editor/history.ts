const MAX_ENTRIES = 200;

/**
 * Undo and redo over whole states. A gesture (a slider on its way, a number being typed) counts as one change: it opens
 * with the first change that names it and closes with `settle` or with a change of another name.
 */
export class History<State> {
  private past: State[] = [];
  private future: State[] = [];
  private gesture: string | undefined;

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** Remembers what stood before a change. */
  record(before: State, gesture?: string): void {
    if (gesture !== undefined && gesture === this.gesture) return;
    this.gesture = gesture;
    this.past.push(before);
    this.past.splice(0, this.past.length - MAX_ENTRIES);
    this.future = [];
  }

  /** Ends a gesture; one that came back to where it began leaves nothing to undo. */
  settle(now: State, isSame: (a: State, b: State) => boolean): void {
    if (this.gesture !== undefined && isSame(this.past[this.past.length - 1], now)) this.past.pop();
    this.gesture = undefined;
  }

  undo(now: State): State | undefined {
    return this.move(this.past, this.future, now);
  }

  redo(now: State): State | undefined {
    return this.move(this.future, this.past, now);
  }

  private move(from: State[], to: State[], now: State): State | undefined {
    this.gesture = undefined;
    const state = from.pop();
    if (state !== undefined) to.push(now);
    return state;
  }
}
