/** Exports of `cartoon-smoke/clip`. No module of the library imports this file. */
export {
  ContextError,
  LoadError,
  ParameterError,
  SimulatorError,
  SmokeError,
  UnsupportedError,
} from './base/errors.ts';
export { clip } from './page/clip/clip.ts';
export type { ClipFormat } from './page/clip/clipFile.ts';
export type { ClipOptions, ClippedSmoke } from './page/clip/options.ts';
