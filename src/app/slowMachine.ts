import type { Stage } from '../stage/stage.ts';
import type { Notices } from './notices.ts';
import { strings } from './strings.ts';

/** The governor has seen by then that it is no passing load. */
const FRAMES = 8;

/** Says once when this machine keeps up with the smoke by fewer pixels only, and what would help. */
export function notifyOfSlowMachine(stage: Stage, notices: Notices): void {
  let frames = 0;
  const stop = stage.on('frame', ({ scale }) => {
    // What somebody has asked for by `?quality=` is no news.
    if (scale === 1 || stage.quality !== 'auto') return;
    frames += 1;
    if (frames < FRAMES) return;
    stop();
    notices.whisper(strings.notices.slow);
  });
}
