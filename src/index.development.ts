/** `cartoon-smoke` with warnings. */
import * as production from './index.ts';
import { watched } from './stage/remote/warnings.ts';
import './three/warnings.ts';

export * from './index.ts';
export const createStage = watched('createStage()', production.createStage);
export const openStage = watched('openStage()', production.openStage);
export const connectFrame = watched('connectFrame()', production.connectFrame);
