/** Values of the presets in links of version 1. Links of that version keep their look when a preset changes. */
import type { Values } from './parameter.ts';

/** Values of all presets of version 1. */
const ALL: Values = {};

/** Values of single presets of version 1, where they differ from the current ones. */
const OWN: Readonly<Record<string, Values>> = {};

/** @param preset name of a preset; one that version 1 does not have keeps its current values */
export function valuesOfVersion1(preset: string): Values {
  return { ...ALL, ...OWN[preset] };
}
