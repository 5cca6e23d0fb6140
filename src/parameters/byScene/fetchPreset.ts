/** Loads the presets of one scene on demand. */
import { fetched } from '../../base/timeout.ts';
import type { Preset } from '../parameter.ts';

const byScene: Readonly<Record<string, () => Promise<readonly Preset[]>>> = {
  lamp: async () => (await import('./lamp.ts')).lampPresets,
  airplane: async () => (await import('./airplane.ts')).airplanePresets,
  train: async () => (await import('./train.ts')).trainPresets,
  campfire: async () => (await import('./campfire.ts')).campfirePresets,
  rocket: async () => (await import('./rocket.ts')).rocketPresets,
  genie: async () => (await import('./genie.ts')).geniePresets,
  dust: async () => (await import('./dust.ts')).dustPresets,
  cloudscape: async () => (await import('./cloudscape.ts')).cloudscapePresets,
  wisp: async () => (await import('./wisp.ts')).wispPresets,
  firework: async () => (await import('./firework.ts')).fireworkPresets,
  title: async () => (await import('./title.ts')).titlePresets,
  air: async () => (await import('./air.ts')).airPresets,
};

/** Name of the default preset. */
export const FIRST_PRESET = 'lamp';

/**
 * Loads the preset with this name. Returns undefined if there is none. Safe for untrusted names.
 * @throws LoadError if the download fails or times out
 */
export async function fetchPreset(name: string): Promise<Preset | undefined> {
  const [scene] = name.split('-', 1);
  if (!Object.hasOwn(byScene, scene)) return undefined;
  const presets = await fetched(`The preset ${name}`, byScene[scene]());
  return presets.find((preset) => preset.name === name);
}
