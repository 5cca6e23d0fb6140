/** The named presets. Each contains only values that differ from the defaults of the table. */
import { ParameterError } from '../base/errors.ts';
import { presets as air } from './byScene/air.ts';
import { presets as airplane } from './byScene/airplane.ts';
import { presets as campfire } from './byScene/campfire.ts';
import { presets as cloudscape } from './byScene/cloudscape.ts';
import { presets as dragon } from './byScene/dragon.ts';
import { presets as dust } from './byScene/dust.ts';
import { presets as firework } from './byScene/firework.ts';
import { presets as genie } from './byScene/genie.ts';
import { presets as lamp } from './byScene/lamp.ts';
import { presets as rocket } from './byScene/rocket.ts';
import { presets as teapot } from './byScene/teapot.ts';
import { presets as title } from './byScene/title.ts';
import { presets as train } from './byScene/train.ts';
import { presets as wisp } from './byScene/wisp.ts';
import { presets as wispLooks } from './byScene/wispLooks.ts';
import type { Preset, Values } from './parameter.ts';
import { presetValues as valuesOf } from './values.ts';
import type { PresetName } from './valueTypes.ts';

export type { Preset };

/** Presets grouped by scene. The first one of a scene has the scene's name and is its default look. */
export const presets: readonly Preset[] = [
  ...lamp,
  ...airplane,
  ...train,
  ...campfire,
  ...rocket,
  ...genie,
  ...dust,
  ...cloudscape,
  ...wisp,
  ...wispLooks,
  ...firework,
  ...title,
  ...dragon,
  ...teapot,
  ...air,
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
