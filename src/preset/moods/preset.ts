import type { Values } from '../parameter.ts';

export interface Preset {
  /** The name in links. */
  readonly name: string;
  /** The name for people. */
  readonly label: string;
  /** One sentence about the mood. */
  readonly text: string;
  readonly values: Values;
}
