import type { SmokeError } from '../preset/errors.ts';
import type { Notice } from '../preset/notice.ts';

/** Something about the smoke has changed, or was not taken as it stood. */
export interface StateChange {
  /** Whether the smoke moves; out of sight it counts as moving. */
  readonly playing: boolean;
  /** What was not taken as it stood in the attributes, and what is shown instead; empty otherwise. */
  readonly notices: readonly Notice[];
}

/** What `detail` holds of each event. None of them bubbles. */
export interface SmokeEvents {
  /** The first picture stands. */
  ready: { readonly thread: 'main' | 'worker' | 'frame' };
  /** There is no smoke, or no more: the poster and the fallback are shown. */
  error: { readonly error: SmokeError };
  statechange: StateChange;
}

export type SmokeEvent<Name extends keyof SmokeEvents> = CustomEvent<SmokeEvents[Name]>;
