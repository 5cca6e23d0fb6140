/** Exports of `cartoon-smoke/puff`. No module of the library imports this file. */
export {
  ContextError,
  LoadError,
  ParameterError,
  SimulatorError,
  SmokeError,
  UnsupportedError,
} from './base/errors.ts';
export type { Effect, PuffOptions, WipeOptions } from './page/puff/options.ts';
export { puff, type OwnPuff, type Puff } from './page/puff/puff.ts';
export type { PuffTarget } from './page/puff/target.ts';
