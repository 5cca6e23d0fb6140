/** The source of a trail, frame by frame. */
import type { Placement } from './placement.ts';
import type { ScenePoint } from './slots.ts';
import type { Source, TargetBox } from './target.ts';

/** Moves below this length are not sent, metres. */
const STILL = 0.001;

/** An emitter that follows a source. */
export interface Follower {
  readonly from: ScenePoint;
  /** Whether the emitter still belongs to the call. */
  readonly isOwn: () => boolean;
  /** Moves the emitter along a line. Resolves when the stage has it. */
  readonly move: (from: ScenePoint, to: ScenePoint) => Promise<void>;
}

/**
 * Moves an emitter with an element or with the pointer.
 * @returns a function that stops
 */
export function follow(placement: Placement, source: Source, { from, isOwn, move }: Follower): () => void {
  const end = new AbortController();
  const { signal } = end;
  const placeOf = source.followsPointer ? pointerPlace(source, signal) : () => source.box();
  let before = from;
  let wasMoving = false;
  let isBehind = false;
  const step = () => {
    if (signal.aborted || !isOwn()) return end.abort();
    requestAnimationFrame(step);
    if (isBehind) return;
    const box = placeOf();
    const now = box ? placement.pointOf(box) : before;
    const isMoving = Math.max(Math.abs(now.x - before.x), Math.abs(now.y - before.y)) > STILL;
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
function pointerPlace(source: Source, signal: AbortSignal): () => TargetBox | undefined {
  let pointer: TargetBox | undefined;
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
