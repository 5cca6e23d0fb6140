import type { Values } from '../parameter.ts';

export interface Preset {
  /** The name in links: its scene's, and behind a dash its own. */
  readonly name: string;
  /** The name for people. */
  readonly label: string;
  /** One sentence about the look. */
  readonly text: string;
  readonly values: Values;
}
