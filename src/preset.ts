/**
 * `cartoon-smoke/preset`: the parameter table and the codec of share links. It needs neither three.js nor a DOM.
 * Exports only.
 */
export { decode, encode, type Decoded, type State } from './parameters/codec.ts';
export { FileError, ParameterError, SmokeError } from './base/errors.ts';
export { readFile, writeFile, type ModelFile, type SmokeFile } from './parameters/file.ts';
export type { Notice } from './parameters/notice.ts';
export type {
  ItemIndex,
  ItemValues,
  ListValues,
  PresetName,
  ScopeValues,
  SingleValues,
} from './parameters/valueTypes.ts';
export type { AnyValues, Reader, ShareLink, Value, Values } from './parameters/parameter.ts';
export { presetValues } from './parameters/presets.ts';
export {
  EMPTY_TIMELINE,
  readTimeline,
  valueAt,
  whyNotAnimated,
  withKeyframes,
  writeTimeline,
  type Easing,
  type Keyframe,
  type Lane,
  type Timeline,
  type TimelineBurst,
} from './parameters/timeline.ts';
export { defaults, validate } from './parameters/values.ts';
export { itemGroups } from './parameters/words/lists.ts';
export { defaultPreset, findPreset, presets, type Preset } from './parameters/words/presets.ts';
export { findParameter, groups, table } from './parameters/words/table.ts';
export type {
  ChoiceParameter,
  ColorParameter,
  CurveParameter,
  DrawingParameter,
  OutlineParameter,
  NumberParameter,
  Parameter,
  ParameterDescription,
  PathParameter,
  RampParameter,
  TimelineParameter,
  ToggleParameter,
} from './parameters/words/words.ts';
