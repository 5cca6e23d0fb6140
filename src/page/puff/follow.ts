/** The source of a trail, frame by frame. */
import type { Box, Triple } from '../plane.ts';
import type { Placement } from './placement.ts';
import type { Source } from './target.ts';

/** Moves below this length are not sent, metres. */
const STILL = 0.001;

/**
 * Follows an element or the pointer.
 * @param from the place of the source
 * @param move called with a line that the source has moved along. The next one waits until it resolves
 * @returns a function that stops
 */
export function follow(
  placement: Placement,
  source: Source,
  from: Triple,
  move: (from: Triple, to: Triple) => Promise<void>,
): () => void {
  const end = new AbortController();
  const { signal } = end;
  const placeOf = source.followsPointer ? pointerPlace(source, signal) : () => source.box();
  let before = from;
  let wasMoving = false;
  let isBehind = false;
  const step = () => {
    if (signal.aborted) return;
    requestAnimationFrame(step);
    if (isBehind) return;
    const box = placeOf();
    const now = box ? placement.rectangleOf(box).middle : before;
    const isMoving = now.some((metres, axis) => Math.abs(metres - before[axis]) > STILL);
    // A source that has stopped needs one more call, which ends the line.
    if (!isMoving && !wasMoving) return;
    wasMoving = isMoving;
    isBehind = true;
    const done = () => (isBehind = false);
    // Rejects when the stage has ended, and then nothing follows.
    move(before, now).then(done, done);
    before = now;
  };
  requestAnimationFrame(step);
  return () => end.abort();
}

/** @returns a function for the place of the pointer; undefined if neither the pointer nor the page has moved since */
function pointerPlace(source: Source, signal: AbortSignal): () => Box | undefined {
  let pointer: Box | undefined;
  // Places are not read in every frame, because that can cost a layout.
  let hasMoved = false;
  const given = { signal, capture: true, passive: true };
  const view = source.inside?.ownerDocument.defaultView ?? window;
  view.addEventListener(
    'pointermove',
    ({ clientX, clientY }) => {
      pointer = source.fromView({ left: clientX, top: clientY, width: 0, height: 0 });
      hasMoved = true;
    },
    given,
  );
  addEventListener('scroll', () => (hasMoved = true), given);
  return () => {
    if (!hasMoved) return undefined;
    hasMoved = false;
    return pointer ?? source.box();
  };
}
