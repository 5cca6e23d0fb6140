/** Wheels and keys have no end event. Their gesture ends after this time without input, in milliseconds. */
export const QUIET_MS = 300;

/** Detects the end of a camera gesture, so that the whole gesture is one undo step. */
export class GestureEnd {
  private readonly notify: () => void;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param notify called at the end of each gesture */
  constructor(notify: () => void) {
    this.notify = notify;
  }

  /** Restarts the timeout, for input without an end event. */
  postpone(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.now(), QUIET_MS);
  }

  /** Ends the gesture now. */
  now(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.notify();
  }
}
