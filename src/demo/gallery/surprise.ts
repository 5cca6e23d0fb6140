import { presets, presetValues, type State, type Value } from '../../preset.ts';
import type { Editor } from '../editor/editor.ts';

/**
 * A random look: the scene and the motion of one preset in the style of another.
 *
 * @param current name of the preset that is shown; the scene is that of another one
 * @param random returns a number from 0 to below 1
 */
export function mixedState(current: string, random: () => number = Math.random): State {
  const pick = (from: typeof presets) => from[Math.floor(random() * from.length)];
  const base = pick(presets.filter(({ name }) => name !== current));
  const model = pick(presets.filter(({ name }) => name !== base.name));
  const values: Record<string, Value> = { ...presetValues(base) };
  for (const key of Object.keys(values)) if (isStyle(key)) delete values[key];
  const style = Object.entries(presetValues(model)).filter(([key]) => isStyle(key));
  return { preset: base.name, values: { ...values, ...Object.fromEntries(style) } };
}

/** Shows a mixed look. Can be undone. */
export function surprise(editor: Editor): void {
  editor.load(mixedState(editor.state.preset));
}

function isStyle(key: string): boolean {
  return key.startsWith('style.');
}
