import { keyOf } from '../../internal.ts';
import { burstLane, emitterOf, laneNames, marksOf, onGrid, placeOf, STEPS_PER_SECOND, type Mark } from './model.ts';
import { consume, type Lanes } from './lanes.ts';
import type { Session } from './session.ts';

const WAYS: Readonly<Record<string, 1 | -1>> = { ArrowLeft: -1, ArrowRight: 1 };

/** Keys on the lanes: they move keyframes and the focus between them. */
export function listenOnLanes(lanes: Lanes, session: Session, edit: () => void): void {
  const { element } = lanes;
  element.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if ((event.target as Element).closest('.timeline-name')) return;
    if (act(event, lanes, session, edit)) consume(event);
  });
  element.addEventListener('keyup', ({ key }) => {
    if (key in WAYS) session.settle();
  });
}

/** @returns whether the key does something */
function act(event: KeyboardEvent, lanes: Lanes, session: Session, edit: () => void): boolean {
  const { shiftKey } = event;
  const key = keyOf(event);
  const current = session.focused;
  if (key === '+' || key === '=') lanes.axis.zoomIn();
  else if (key === '-') lanes.axis.zoomOut();
  else if (key === 'Escape' && session.marks.size > 0) session.select(new Set());
  else if (key === 'k') setHere(session, current);
  else if (!current) return false;
  else if (WAYS[key]) moveBy(WAYS[key], shiftKey, session, current, lanes);
  else if (key === 'Enter') edit();
  else {
    const next = nextMark(key, session, current);
    if (!next) return key in GOES;
    session.select(new Set(shiftKey ? [...session.marks, next] : [next]), next);
    lanes.focus(next);
  }
  return true;
}

/** A keyframe or a burst at the playhead, in the lane that has the focus. */
function setHere(session: Session, current: Mark | undefined): void {
  const lane = current ? placeOf(current).lane : (laneNames(session.timeline)[0] ?? burstLane(0));
  const emitter = emitterOf(lane);
  if (emitter === undefined) session.toggleKeyframe(lane);
  else session.addBurst(emitter);
}

function moveBy(way: 1 | -1, bySecond: boolean, session: Session, current: Mark, lanes: Lanes): void {
  if (!session.marks.has(current)) session.select(new Set([current]), current);
  const { step } = placeOf(current);
  session.move(bySecond ? way * STEPS_PER_SECOND : onGrid(step, way, session.grid) - step);
  if (session.focused) lanes.focus(session.focused);
}

/** Where keys move the focus. */
const GOES: Readonly<Record<string, (marks: readonly Mark[], at: number) => Mark | undefined>> = {
  PageUp: (marks, at) => marks[at - 1],
  PageDown: (marks, at) => marks[at + 1],
  Home: (marks) => marks[0],
  End: (marks) => marks.at(-1),
  ArrowUp: () => undefined,
  ArrowDown: () => undefined,
};

function nextMark(key: string, session: Session, current: Mark): Mark | undefined {
  const { lane, step } = placeOf(current);
  const { timeline } = session;
  if (key !== 'ArrowUp' && key !== 'ArrowDown') {
    const marks = marksOf(timeline, lane);
    return GOES[key]?.(marks, marks.indexOf(current));
  }
  const names = laneNames(timeline);
  const other = names[names.indexOf(lane) + (key === 'ArrowUp' ? -1 : 1)];
  if (other === undefined) return undefined;
  const marks = marksOf(timeline, other);
  const away = marks.map((mark) => Math.abs(placeOf(mark).step - step));
  return marks[away.indexOf(Math.min(...away))];
}
