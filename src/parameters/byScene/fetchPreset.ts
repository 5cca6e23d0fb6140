/** Loads the presets of one scene on demand. */
import { fetched } from '../../base/timeout.ts';
import type { Preset } from '../parameter.ts';

/** @param look what follows the dash in the name of a preset */
type Load = (look?: string) => Promise<{ presets: readonly Preset[] }>;

const byScene: Readonly<Record<string, Load>> = {
  lamp: () => import('./lamp.ts'),
  airplane: () => import('./airplane.ts'),
  train: () => import('./train.ts'),
  campfire: () => import('./campfire.ts'),
  rocket: () => import('./rocket.ts'),
  genie: () => import('./genie.ts'),
  dust: () => import('./dust.ts'),
  cloudscape: () => import('./cloudscape.ts'),
  wisp: (look) => (look ? import('./wispLooks.ts') : import('./wisp.ts')),
  firework: () => import('./firework.ts'),
  title: () => import('./title.ts'),
  dragon: () => import('./dragon.ts'),
  teapot: () => import('./teapot.ts'),
  air: () => import('./air.ts'),
};

/** Name of the default preset. */
export const FIRST_PRESET = 'lamp';

/**
 * Loads the preset with this name. Returns undefined if there is none. Safe for untrusted names.
 * @throws LoadError if the download fails or times out
 */
export async function fetchPreset(name: string): Promise<Preset | undefined> {
  const [scene, look] = name.split('-');
  if (!Object.hasOwn(byScene, scene)) return undefined;
  const { presets } = await fetched(`The preset ${name}`, byScene[scene](look));
  return presets.find((preset) => preset.name === name);
}
