const MAX_ENTRIES = 200;

/**
 * Undo and redo over complete states. A gesture (dragging a slider, typing a number) counts as one change: it starts
 * with the first change with its name and ends with `settle` or with a change with another name.
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

  /** Stores the state before a change. */
  record(before: State, gesture?: string): void {
    if (gesture !== undefined && gesture === this.gesture) return;
    this.gesture = gesture;
    this.past.push(before);
    this.past.splice(0, this.past.length - MAX_ENTRIES);
    this.future = [];
  }

  /** Ends a gesture. A gesture that returned to its start leaves no undo step. */
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
