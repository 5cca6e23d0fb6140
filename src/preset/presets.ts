/** The named presets: each says only what differs from the defaults of the table. */
import { airPresets } from './moods/air.ts';
import { airplanePresets } from './moods/airplane.ts';
import { campfirePresets } from './moods/campfire.ts';
import { cloudscapePresets } from './moods/cloudscape.ts';
import { dustPresets } from './moods/dust.ts';
import { geniePresets } from './moods/genie.ts';
import { lampPresets } from './moods/lamp.ts';
import type { Preset } from './moods/preset.ts';
import { rocketPresets } from './moods/rocket.ts';
import { trainPresets } from './moods/train.ts';
import { wispPresets } from './moods/wisp.ts';

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

/** The preset of this name, or undefined. Safe for names from strangers. */
export function findPreset(name: string): Preset | undefined {
  return byName.get(name);
}
