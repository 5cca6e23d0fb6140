/** `cartoon-smoke` with warnings. */
import * as production from '../index.ts';
import type { RemoteStage, Stage } from '../index.ts';
import './smoke.ts';
import { STAGE_MEMBERS, warnOfError, warnUnawaited } from './warn.ts';

/** A function that opens a stage, with warnings about a missing `await` and about what stops the stage. */
function watched<Given extends unknown[], Kind extends Stage | RemoteStage>(
  about: string,
  open: (...given: Given) => Promise<Kind>,
): (...given: Given) => Promise<Kind> {
  const watch = (stage: Kind) => {
    stage.on('error', (error) => warnOfError(about, error));
    return stage;
  };
  return (...given) => warnUnawaited(about, open(...given).then(watch), STAGE_MEMBERS);
}

export * from '../index.ts';
export const createStage = watched('createStage()', production.createStage);
export const openStage = watched('openStage()', production.openStage);
export const connectFrame = watched('connectFrame()', production.connectFrame);
