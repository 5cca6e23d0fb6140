import type { PuffOptions } from '../../puff.ts';
import { defaultPreset, encode, findPreset, presetValues, type AnyValues, type State } from '../../preset.ts';
import { isOfLook } from '../../internal.ts';

/** The line of code of a call with these options. @param target as an expression */
export function puffCode(target: string, options: PuffOptions): string {
  const given = Object.entries(options).filter(([, value]) => value !== undefined);
  if (given.length === 0) return `puff(${target});`;
  const pairs = given.map(([name, value]) => `${name}: ${typeof value === 'string' ? quoted(value) : value}`);
  return `puff(${target}, { ${pairs.join(', ')} });`;
}

function quoted(text: string): string {
  return `'${text.replace(/[\\']/g, '\\$&')}'`;
}

/** A call of `puff()` with the look of a state. */
export async function puffCall(state: State): Promise<string> {
  const { preset } = state;
  const [own, values]: AnyValues[] = [presetValues(findPreset(preset) ?? defaultPreset), state.values];
  const changed = Object.keys(own).filter((key) => isOfLook(key) && values[key] !== own[key]);
  const look = Object.fromEntries(changed.map((key) => [key, values[key]]));
  const named = changed.length === 0 ? preset : await encode({ preset, values: { ...own, ...look } });
  return `import { puff } from 'cartoon-smoke/puff';\n${puffCode('button', { preset: named })}`;
}
