/** A wheel and keys say when they turn, not when they are done: after so long without, they are. */
export const QUIET_MS = 300;

/** Finds out when a gesture that moves the eye has ended, so that all of it is undone together. */
export class GestureEnd {
  private readonly notify: () => void;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param notify called with each end */
  constructor(notify: () => void) {
    this.notify = notify;
  }

  /** Something moved that does not say when it ends. */
  postpone(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.now(), QUIET_MS);
  }

  /** It has ended, or another one begins. */
  now(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.notify();
  }
}
