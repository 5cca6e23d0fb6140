import type { Values } from '../parameter.ts';
import type { PresetName } from '../valueTypes.ts';

/** A named preset. Its label and text are in `words/presets.ts`. */
export interface Preset {
  /** Name in links: the scene's name, followed by a dash and the look if it is not the scene's first preset. */
  readonly name: PresetName;
  readonly values: Values;
}
