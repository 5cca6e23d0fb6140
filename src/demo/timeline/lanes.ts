import type { Stage } from '../../index.ts';
import { MAX_STEP } from '../../internal.ts';
import { pauseWhileDragging } from '../playback/transport.ts';
import { create, setAttributes } from '../ui/dom.ts';
import { Axis } from './axis.ts';
import { LaneGestures } from './laneGestures.ts';
import { LaneRow } from './laneRow.ts';
import { burstLane, emitterOf, laneNames, onGrid, placeOf, snapped, STEPS_PER_SECOND, type Mark } from './model.ts';
import type { Session } from './session.ts';
import { timeText, words } from './words.ts';

/** The lanes of the timeline with the ruler, the playhead and the end. */
export class Lanes {
  readonly element = create('div', { class: 'timeline-scroll', tabindex: -1 });
  readonly axis: Axis;
  readonly gestures: LaneGestures;
  private readonly sheet = create('div', { class: 'timeline-sheet' });
  private readonly body = create('div', { class: 'timeline-lanes', role: 'group', 'aria-label': words.lanes });
  private readonly ruler = create('div', { class: 'timeline-ruler', role: 'slider', tabindex: 0 });
  private readonly end = create('div', { class: 'timeline-end', role: 'slider', tabindex: 0, title: words.end });
  private readonly session: Session;
  private readonly stage: Stage;
  private readonly rows = new Map<string, LaneRow>();
  private shownStep = -1;

  constructor(session: Session, stage: Stage) {
    this.session = session;
    this.stage = stage;
    this.axis = new Axis(this.element, this.sheet, session);
    const head = create('div', { class: 'timeline-playhead-head', 'aria-hidden': 'true' });
    const line = create('div', { class: 'timeline-playhead', 'aria-hidden': 'true' });
    const rest = create('div', { class: 'timeline-rest', 'aria-hidden': 'true' });
    this.ruler.append(this.axis.labels, head);
    const corner = create('div', { class: 'timeline-corner' });
    const top = create('div', { class: 'timeline-top' }, corner, this.ruler, this.end);
    this.sheet.append(top, this.body, rest, line);
    this.element.append(this.sheet);
    setAttributes(this.ruler, { 'aria-label': words.playhead, 'aria-valuemin': 0 });
    setAttributes(this.end, { 'aria-label': words.end, 'aria-valuemin': 0, 'aria-valuemax': MAX_STEP });
    this.scrub();
    this.dragEnd();
    this.gestures = new LaneGestures(this.element, this.body, session, this.axis);
    stage.on('frame', () => this.showNow());
    // On a phone what is selected shows up over the lanes.
    new ResizeObserver(() => this.revealSelected()).observe(this.element);
  }

  /** The lanes in the order in which they are shown: without bursts, there is an empty lane for them. */
  get names(): readonly string[] {
    const names = laneNames(this.session.timeline);
    if (this.session.isEmpty || names.some((lane) => emitterOf(lane) !== undefined)) return names;
    return [...names, burstLane(0)];
  }

  show(): void {
    const { names, session } = this;
    for (const [lane, row] of this.rows) {
      if (names.includes(lane)) continue;
      row.element.remove();
      this.rows.delete(lane);
    }
    names.forEach((lane, at) => {
      if (!this.rows.has(lane)) this.rows.set(lane, new LaneRow(lane, session));
      const { element } = this.rows.get(lane)!;
      if (this.body.children[at] !== element) this.body.insertBefore(element, this.body.children[at] ?? null);
      this.rows.get(lane)!.show();
    });
    const { length } = session.timeline;
    setAttributes(this.end, { 'aria-valuenow': length, 'aria-valuetext': timeText(length, session.grid) });
    this.axis.show();
    this.shownStep = -1;
    this.showNow();
  }

  /** Moves the focus to a mark, and shows it. */
  focus(mark: Mark): void {
    const { lane, step } = placeOf(mark);
    this.axis.reveal(step);
    this.rows.get(lane)?.elementOf(mark)?.focus();
    this.rows.get(lane)?.element.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }

  private revealSelected(): void {
    const { focused, marks } = this.session;
    if (!focused || !marks.has(focused)) return;
    this.rows.get(placeOf(focused).lane)?.element.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }

  focusRuler(): void {
    this.ruler.focus();
  }

  private showNow(): void {
    if (!this.element.checkVisibility()) return;
    const { session } = this;
    const time = Math.min(session.time, MAX_STEP);
    this.sheet.style.setProperty('--now', String(time));
    if (this.stage.playing) this.axis.follow(time);
    if (session.step === this.shownStep) return;
    this.shownStep = session.step;
    setAttributes(this.ruler, {
      'aria-valuenow': session.step,
      'aria-valuemax': Math.max(session.step, session.timeline.length),
      'aria-valuetext': timeText(session.step, session.grid),
    });
    const { effective } = session;
    for (const row of this.rows.values()) row.showNow(effective);
  }

  /** The ruler moves the playhead. */
  private scrub(): void {
    const { ruler, session } = this;
    const goTo = ({ clientX }: PointerEvent) => void session.go(snapped(this.axis.timeAt(clientX), session.grid));
    let isHeld = false;
    pauseWhileDragging(ruler, this.stage, (held) => (isHeld = held));
    ruler.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      ruler.setPointerCapture(event.pointerId);
      goTo(event);
    });
    ruler.addEventListener('pointermove', (event) => isHeld && goTo(event));
    ruler.addEventListener('keydown', (event) => {
      const to = this.keyTarget(event, session.step);
      if (to !== undefined) void session.go(to);
      else if (event.key === 'PageUp') session.goToMark(-1);
      else if (event.key === 'PageDown') session.goToMark(1);
      else return;
      consume(event);
    });
  }

  /** The end is dragged along the ruler. */
  private dragEnd(): void {
    const { end, session } = this;
    const setTo = (step: number) => session.setLength(Math.min(Math.max(1, step), MAX_STEP));
    let pointer: number | undefined;
    /** From the pointer to the end, in steps. */
    let grip = 0;
    end.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      event.stopPropagation();
      pointer = event.pointerId;
      grip = session.timeline.length - this.axis.timeAt(event.clientX);
      this.axis.hold(true);
      end.setPointerCapture(pointer);
    });
    end.addEventListener('pointermove', ({ pointerId, clientX }) => {
      if (pointerId === pointer) setTo(snapped(this.axis.timeAt(clientX) + grip, session.grid));
    });
    const release = ({ pointerId }: PointerEvent) => {
      if (pointerId !== pointer) return;
      pointer = undefined;
      session.settle();
      this.axis.hold(false);
    };
    end.addEventListener('pointerup', release);
    end.addEventListener('pointercancel', release);
    end.addEventListener('keydown', (event) => {
      const to = this.keyTarget(event, session.timeline.length);
      if (to === undefined) return;
      setTo(to);
      consume(event);
    });
    end.addEventListener('keyup', () => session.settle());
  }

  /** Where an arrow key moves something on the ruler. */
  private keyTarget({ key, shiftKey, ctrlKey, metaKey, altKey }: KeyboardEvent, from: number): number | undefined {
    if (ctrlKey || metaKey || altKey) return undefined;
    const way = key === 'ArrowRight' || key === 'ArrowUp' ? 1 : key === 'ArrowLeft' || key === 'ArrowDown' ? -1 : 0;
    if (way !== 0) return shiftKey ? from + way * STEPS_PER_SECOND : onGrid(from, way, this.session.grid);
    if (key === 'Home') return 0;
    return key === 'End' ? this.session.timeline.length : undefined;
  }
}

/** The page has shortcuts with the same keys. */
export function consume(event: KeyboardEvent): void {
  event.preventDefault();
  event.stopPropagation();
}
