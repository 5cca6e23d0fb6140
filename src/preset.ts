/**
 * `cartoon-smoke/preset`: the parameter table and the codec of share links. It needs neither three.js nor a DOM.
 * Exports only.
 */
export { decode, encode, type Decoded, type State } from './preset/codec.ts';
export { FileError, ParameterError, SmokeError } from './preset/errors.ts';
export { readFile, writeFile, type SmokeFile } from './preset/file.ts';
export type { Notice } from './preset/notice.ts';
export type { ItemIndex, ItemValues, ListValues, PresetName, SingleValues } from './preset/valueTypes.ts';
export type {
  AnyValues,
  ChoiceParameter,
  ColorParameter,
  CurveParameter,
  NumberParameter,
  Parameter,
  ParameterDescription,
  RampParameter,
  Reader,
  ShareLink,
  ToggleParameter,
  Value,
  Values,
} from './preset/parameter.ts';
export { defaultPreset, findPreset, presets, presetValues, type Preset } from './preset/presets.ts';
export { findParameter, groups, itemGroups, table } from './preset/table.ts';
export { defaults, validate } from './preset/values.ts';
