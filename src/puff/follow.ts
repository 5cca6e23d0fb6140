/** The source of a trail, frame by frame. */
import type { RemoteStage } from '../remote/contract.ts';
import type { Placement } from './placement.ts';
import { lineValues, type ScenePoint } from './slots.ts';
import type { Source } from './target.ts';

/** Moves below this length are not sent, metres. */
const STILL = 0.001;

/** An emitter that follows a source. */
export interface Follower {
  /** Index of the emitter. */
  readonly index: number;
  readonly from: ScenePoint;
  /** Whether the emitter still belongs to the call. */
  readonly isOwn: () => boolean;
}

/**
 * Moves an emitter with an element or with the pointer.
 * @returns a function that stops
 */
export function follow(
  stage: RemoteStage,
  placement: Placement,
  source: Source,
  { index, from, isOwn }: Follower,
): () => void {
  const end = new AbortController();
  const { signal } = end;
  let pointer: { left: number; top: number } | undefined;
  if (source.followsPointer) {
    const move = ({ clientX, clientY }: PointerEvent) => (pointer = { left: clientX, top: clientY });
    addEventListener('pointermove', move, { signal, capture: true, passive: true });
  }
  let before = from;
  let wasMoving = false;
  let isBehind = false;
  const step = () => {
    if (signal.aborted || !isOwn()) return end.abort();
    requestAnimationFrame(step);
    const box = pointer ? { ...pointer, width: 0, height: 0 } : source.box();
    if (isBehind || !box) return;
    const now = placement.pointOf(box);
    const isMoving = Math.max(Math.abs(now.x - before.x), Math.abs(now.y - before.y)) > STILL;
    // A source that has stopped needs one more call, which ends the line.
    if (!isMoving && !wasMoving) return;
    wasMoving = isMoving;
    isBehind = true;
    const done = () => (isBehind = false);
    // Rejects when the stage has ended, and then nothing follows.
    stage.set(lineValues(index, before, now)).then(done, done);
    before = now;
  };
  requestAnimationFrame(step);
  return () => end.abort();
}
