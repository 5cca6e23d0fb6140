const MAX_ENTRIES = 200;

/**
 * Undo and redo over complete states. A gesture (dragging a slider, typing a number) counts as one change: it starts
 * with the first change with its name and ends with `settle` or with a change with another name.
 */
export class History<State> {
  private past: State[] = [];
  private current: State;
  private future: State[] = [];
  private gesture: string | undefined;

  constructor(present: State) {
    this.current = present;
  }

  get present(): State {
    return this.current;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  record(next: State, gesture?: string): void {
    const continues = gesture !== undefined && gesture === this.gesture;
    if (!continues) {
      this.past.push(this.current);
      this.past.splice(0, this.past.length - MAX_ENTRIES);
      this.future = [];
    }
    this.gesture = gesture;
    this.current = next;
  }

  /** Ends a gesture. A gesture that returned to its start leaves no undo step. */
  settle(isSame: (a: State, b: State) => boolean): void {
    if (this.gesture !== undefined && isSame(this.past[this.past.length - 1], this.current)) this.past.pop();
    this.gesture = undefined;
  }

  undo(): void {
    this.move(this.past, this.future);
  }

  redo(): void {
    this.move(this.future, this.past);
  }

  private move(from: State[], to: State[]): void {
    this.gesture = undefined;
    const state = from.pop();
    if (state === undefined) return;
    to.push(this.current);
    this.current = state;
  }
}
