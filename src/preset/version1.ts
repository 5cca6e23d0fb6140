/** Values of the presets in links of version 1. Links of that version keep their look when a preset changes. */
import type { Values } from './parameter.ts';

/** The presets of version 1. */
const NAMES: ReadonlySet<string> = new Set(
  (
    'lamp lamp-noir lamp-sunset lamp-ghost lamp-ember lamp-storm lamp-blueprint lamp-newspaper lamp-candy lamp-papercut ' +
    'airplane airplane-ukiyo-e train train-night-mail campfire rocket genie genie-sumi-e dust cloudscape ' +
    'cloudscape-gouache wisp wisp-matcha air'
  ).split(' '),
);

/** Values of all presets of version 1. */
const ALL: Values = {
  'puff.turn': 0,
  'puff.stretch': 1,
  'puff.billow': 0,
  'style.simplify': 0,
  'style.strokes': 0,
};

/** Values of single presets of version 1, where they differ from the current ones. */
const OWN: Readonly<Record<string, Values>> = {
  'lamp-sunset': { 'style.rim': 0.25 },
  'lamp-candy': { 'style.rim': 0.2 },
  'train-night-mail': { 'style.rim': 0.3 },
};

/** Values of a preset that differ from the current ones: none of a preset that version 1 does not have. */
export function valuesOfVersion1(preset: string): Values {
  return NAMES.has(preset) ? { ...ALL, ...OWN[preset] } : {};
}
