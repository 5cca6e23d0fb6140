/**
 * `cartoon-smoke/preset`: the parameter table and the codec of share links. It needs neither three.js nor a DOM.
 * Exports only.
 */
export { decode, encode, type Decoded, type State } from './preset/codec.ts';
export { FileError, ParameterError, SmokeError } from './preset/errors.ts';
export { readFile, writeFile, type SmokeFile } from './preset/file.ts';
export type { Notice } from './preset/notice.ts';
export type { ItemIndex, ItemValues, ListValues, PresetName, SingleValues } from './preset/valueTypes.ts';
export type { AnyValues, Reader, ShareLink, Value, Values } from './preset/parameter.ts';
export { presetValues } from './preset/presets.ts';
export { defaults, validate } from './preset/values.ts';
export { itemGroups } from './preset/words/lists.ts';
export { defaultPreset, findPreset, presets, type Preset } from './preset/words/presets.ts';
export { findParameter, groups, table } from './preset/words/table.ts';
export type {
  ChoiceParameter,
  ColorParameter,
  CurveParameter,
  NumberParameter,
  Parameter,
  ParameterDescription,
  RampParameter,
  ToggleParameter,
} from './preset/words/words.ts';
