import type { SmokeError } from '../../base/errors.ts';
import type { Notice } from '../../parameters/notice.ts';

/** Detail of `statechange`: playback or an attribute's effective value has changed. */
export interface StateChange {
  /** Whether the smoke plays. Out of view it counts as playing. */
  readonly playing: boolean;
  /** Attribute values that were corrected or ignored, with the values in effect; otherwise empty. */
  readonly notices: readonly Notice[];
}

/** `detail` of each event. The events do not bubble. */
export interface SmokeEvents {
  /** The first frame is rendered. */
  ready: { readonly thread: 'main' | 'worker' | 'frame' };
  /** The smoke failed to start or stopped. The poster and the fallback are shown. */
  error: { readonly error: SmokeError };
  statechange: StateChange;
}

export type SmokeEvent<Name extends keyof SmokeEvents> = CustomEvent<SmokeEvents[Name]>;
