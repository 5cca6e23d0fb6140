/** Exports of `cartoon-smoke/puff`. No module of the library imports this file. */
export {
  ContextError,
  LoadError,
  ParameterError,
  SimulatorError,
  SmokeError,
  UnsupportedError,
} from './preset/errors.ts';
export type { Effect, PuffOptions } from './puff/options.ts';
export { puff, type OwnPuff, type Puff } from './puff/puff.ts';
export type { PuffTarget } from './puff/target.ts';
