import type { Values } from '../parameter.ts';
import type { PresetName } from '../valueTypes.ts';

export interface Preset {
  /** Name in links: the scene's name, followed by a dash and the look if it is not the scene's first preset. */
  readonly name: PresetName;
  /** Display name. */
  readonly label: string;
  /** One sentence about the look. */
  readonly text: string;
  readonly values: Values;
}
