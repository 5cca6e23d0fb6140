import { defaultPreset, encode, findPreset, presetValues, type AnyValues, type State } from '../../preset.ts';
import { isOfLook } from '../../internal.ts';
import { puffCode } from '../effects/code.ts';

/** A call of `puff()` with the look of a state. */
export async function puffCall(state: State): Promise<string> {
  const { preset } = state;
  const [own, values]: AnyValues[] = [presetValues(findPreset(preset) ?? defaultPreset), state.values];
  const changed = Object.keys(own).filter((key) => isOfLook(key) && values[key] !== own[key]);
  const look = Object.fromEntries(changed.map((key) => [key, values[key]]));
  const named = changed.length === 0 ? preset : await encode({ preset, values: { ...own, ...look } });
  return `import { puff } from 'cartoon-smoke/puff';\n${puffCode('button', { preset: named })}`;
}
