import { defaultPreset, encode, findPreset, presetValues, type State } from '../../preset.ts';
import { isOfLook } from '../../internal.ts';
import { puffCode } from '../effects/code.ts';

/** A call of `puff()` with the look of a state. */
export async function puffCall({ preset, values }: State): Promise<string> {
  const own = presetValues(findPreset(preset) ?? defaultPreset);
  const changed = Object.entries(own).filter(([key, value]) => isOfLook(key) && values[key] !== value);
  const look = Object.fromEntries(changed.map(([key]) => [key, values[key]]));
  const named = changed.length === 0 ? preset : await encode({ preset, values: { ...own, ...look } });
  return `import { puff } from 'cartoon-smoke/puff';\n${puffCode('button', { preset: named })}`;
}
