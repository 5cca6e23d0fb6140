/** The named presets: each says only what differs from the defaults of the table. */
import { airPresets } from './byScene/air.ts';
import { airplanePresets } from './byScene/airplane.ts';
import { campfirePresets } from './byScene/campfire.ts';
import { cloudscapePresets } from './byScene/cloudscape.ts';
import { dustPresets } from './byScene/dust.ts';
import { geniePresets } from './byScene/genie.ts';
import { lampPresets } from './byScene/lamp.ts';
import type { Preset } from './byScene/preset.ts';
import { rocketPresets } from './byScene/rocket.ts';
import { trainPresets } from './byScene/train.ts';
import { wispPresets } from './byScene/wisp.ts';

export { presetValues } from './values.ts';
export type { Preset };

/** Those of a scene follow each other; the first of them has the scene's name and is how it wants to be seen. */
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
  ...airPresets,
];

const byName: ReadonlyMap<string, Preset> = new Map(presets.map((preset) => [preset.name, preset]));

/** The preset of a link that names none, or one that is not there. */
export const defaultPreset: Preset = presets[0];

/** The preset of this name, or undefined. Safe for untrusted names. */
export function findPreset(name: string): Preset | undefined {
  return byName.get(name);
}
