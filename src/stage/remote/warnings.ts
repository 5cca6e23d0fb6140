/** Warnings about stages: a missing `await`, and what stops the stage. */
import { warnOfError, warnUnawaited } from '../../base/warn.ts';
import type { Stage } from '../stage.ts';
import type { RemoteStage } from './contract.ts';
import { methodNames } from './methods.ts';

/** What programs use of a stage. */
export const STAGE_MEMBERS = [...methodNames, 'ready', 'camera', 'on', 'emit', 'dispose'];

/** @returns a function that opens a stage as the given one does, with warnings */
export function watched<Given extends unknown[], Kind extends Stage | RemoteStage>(
  about: string,
  open: (...given: Given) => Promise<Kind>,
): (...given: Given) => Promise<Kind> {
  const watch = (stage: Kind) => {
    stage.on('error', (error) => warnOfError(about, error));
    return stage;
  };
  return (...given) => warnUnawaited(about, open(...given).then(watch), STAGE_MEMBERS);
}
