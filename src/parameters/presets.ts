/** The named presets. Each contains only values that differ from the defaults of the table. */
import { airPresets } from './byScene/air.ts';
import { airplanePresets } from './byScene/airplane.ts';
import { campfirePresets } from './byScene/campfire.ts';
import { cloudscapePresets } from './byScene/cloudscape.ts';
import { dustPresets } from './byScene/dust.ts';
import { geniePresets } from './byScene/genie.ts';
import { lampPresets } from './byScene/lamp.ts';
import { fireworkPresets } from './byScene/firework.ts';
import type { Preset, Values } from './parameter.ts';
import { rocketPresets } from './byScene/rocket.ts';
import { titlePresets } from './byScene/title.ts';
import { trainPresets } from './byScene/train.ts';
import { wispPresets } from './byScene/wisp.ts';
import { ParameterError } from '../base/errors.ts';
import { presetValues as valuesOf } from './values.ts';
import type { PresetName } from './valueTypes.ts';

export type { Preset };

/** Presets grouped by scene. The first one of a scene has the scene's name and is its default look. */
export const presets: readonly Preset[] = [
  ...lampPresets,
  ...airplanePresets,
  ...trainPresets,
  ...campfirePresets,
  ...rocketPresets,
  ...geniePresets,
  ...dustPresets,
  ...cloudscapePresets,
  ...wispPresets,
  ...fireworkPresets,
  ...titlePresets,
  ...airPresets,
];

const byName: ReadonlyMap<string, Preset> = new Map(presets.map((preset) => [preset.name, preset]));

/** Preset for a link without a preset or with an unknown one. */
export const defaultPreset: Preset = presets[0];

/** The preset with this name, or undefined. Safe for untrusted names. */
export function findPreset(name: string): Preset | undefined {
  return byName.get(name);
}

/**
 * Defaults of all parameters that are not optional, overridden by the values of a preset.
 * @throws ParameterError for an unknown name
 */
export function presetValues(preset: PresetName | { readonly values: Values }): Values {
  const found = typeof preset === 'string' ? findPreset(preset) : preset;
  if (typeof found?.values !== 'object')
    throw new ParameterError('preset', preset, `a preset, or its name: ${[...byName.keys()].join(', ')}`);
  return valuesOf(found);
}
