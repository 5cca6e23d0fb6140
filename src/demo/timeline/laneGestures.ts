import { create } from '../ui/dom.ts';
import type { Axis } from './axis.ts';
import { boxed, emitterOf, marksOf, placeOf, snapped, type Mark } from './model.ts';
import type { Session } from './session.ts';
import { timeText } from './words.ts';

/** Movement in CSS pixels from which a press is a drag. */
const DRAG_PIXELS = 4;
/** Distance from a keyframe in CSS pixels within which a press grabs it. */
const REACH = { mouse: 11, touch: 22 };
/** Width of the edges that scroll during a drag, and pixels per frame. */
const [EDGE, EDGE_SPEED] = [36, 12];

/** A press on the lanes. */
interface Press {
  readonly pointer: number;
  readonly x: number;
  readonly y: number;
  /** The keyframe that it grabbed; otherwise it draws a box. */
  readonly mark: Mark | undefined;
  /** What is added to by the box. */
  readonly marks: ReadonlySet<Mark>;
  /** Time under the pointer at its start. */
  readonly time: number;
  readonly adds: boolean;
  readonly copies: boolean;
  isDrag: boolean;
}

/** Pointers on the lanes: select, drag, draw a box, add by a double click; wheel and pinch zoom. */
export class LaneGestures {
  /** Whether touch draws boxes and adds to the selection instead of scrolling. */
  selectsByTouch = false;
  private readonly scroller: HTMLElement;
  private readonly body: HTMLElement;
  private readonly session: Session;
  private readonly axis: Axis;
  private readonly box = create('div', { class: 'timeline-box', hidden: true });
  private readonly bubble = create('div', { class: 'timeline-bubble', hidden: true, 'aria-hidden': 'true' });
  private press: Press | undefined;
  private latest: { clientX: number; clientY: number } = { clientX: 0, clientY: 0 };

  constructor(scroller: HTMLElement, body: HTMLElement, session: Session, axis: Axis) {
    this.scroller = scroller;
    this.body = body;
    this.session = session;
    this.axis = axis;
    body.parentElement!.append(this.box, this.bubble);
    scroller.addEventListener('pointerdown', (event) => this.begin(event));
    scroller.addEventListener('pointermove', (event) => this.move(event));
    scroller.addEventListener('pointerup', (event) => this.end(event, true));
    scroller.addEventListener('pointercancel', (event) => this.end(event, false));
    scroller.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.press) return;
      event.stopPropagation();
      this.finish(false);
    });
    // The browser would move the focus, and select text.
    body.addEventListener('mousedown', (event) => {
      if (this.press) event.preventDefault();
    });
    scroller.addEventListener('dblclick', (event) => this.add(event));
    scroller.addEventListener('wheel', (event) => this.zoom(event), { passive: false });
    this.pinch();
  }

  private begin(event: PointerEvent): void {
    if (event.button !== 0 || this.press) return;
    const row = rowOf(event.target);
    const isOnLanes = (event.target as Element).closest('.timeline-track, .timeline-scroll') !== null;
    if (!isOnLanes || (event.target as Element).closest('.timeline-name, .timeline-top')) return;
    const isTouch = event.pointerType === 'touch';
    const mark = row ? this.nearest(row, event.clientX, isTouch ? REACH.touch : REACH.mouse) : undefined;
    // Empty lanes scroll by touch.
    if (isTouch && !mark && !this.selectsByTouch) return;
    const adds = event.shiftKey || event.ctrlKey || event.metaKey || (isTouch && this.selectsByTouch);
    const { session } = this;
    const { clientX: x, clientY: y, pointerId: pointer } = event;
    const time = this.axis.timeAt(x);
    this.press = { pointer, x, y, mark, marks: session.marks, time, adds, copies: event.altKey, isDrag: false };
    if (mark && !adds && !session.marks.has(mark)) session.select(new Set([mark]), mark);
    ((mark && this.elementOf(mark)) ?? this.scroller).focus({ preventScroll: true });
    this.scroller.setPointerCapture(pointer);
  }

  private move(event: PointerEvent): void {
    const { press } = this;
    if (event.pointerId !== press?.pointer) return;
    this.latest = event;
    if (!press.isDrag) {
      if (Math.hypot(event.clientX - press.x, event.clientY - press.y) < DRAG_PIXELS) return;
      this.beginDrag(press);
    }
    this.drag(press);
  }

  private beginDrag(press: Press): void {
    const { session } = this;
    press.isDrag = true;
    if (press.mark) {
      if (!session.marks.has(press.mark)) session.select(new Set([...session.marks, press.mark]), press.mark);
      session.beginDrag(press.copies);
      this.axis.hold(true);
    }
    this.scrollAtEdges();
  }

  private drag(press: Press): void {
    const { clientX, clientY } = this.latest;
    const time = this.axis.timeAt(clientX);
    if (!press.mark) return this.drawBox(press, time, clientY);
    const { step } = placeOf(press.mark);
    // The grabbed keyframe snaps, the others keep their distances.
    this.session.drag(snapped(step + time - press.time, this.session.grid) - step);
    this.showBubble(clientY);
  }

  private showBubble(clientY: number): void {
    const { focused, grid } = this.session;
    const { left, top } = this.body.parentElement!.getBoundingClientRect();
    this.bubble.hidden = focused === undefined;
    if (focused === undefined) return;
    this.bubble.textContent = timeText(placeOf(focused).step, grid);
    this.bubble.style.left = `${this.latest.clientX - left}px`;
    this.bubble.style.top = `${clientY - top}px`;
  }

  private drawBox(press: Press, time: number, clientY: number): void {
    const { left, top } = this.body.parentElement!.getBoundingClientRect();
    const { clientX } = this.latest;
    // The start scrolls with the lanes.
    const startX = clientX + (press.time - time) * this.axis.pixels;
    const [x, y] = [Math.min(startX, clientX), Math.min(press.y, clientY)];
    const [width, height] = [Math.abs(clientX - startX), Math.abs(clientY - press.y)];
    Object.assign(this.box.style, {
      left: `${x - left}px`,
      top: `${y - top}px`,
      width: `${width}px`,
      height: `${height}px`,
    });
    this.box.hidden = false;
    const lanes = [...this.body.children].filter((row) => {
      const box = row.getBoundingClientRect();
      return box.bottom > y && box.top < y + height;
    });
    const names = lanes.map((row) => (row as HTMLElement).dataset.lane!);
    const found = boxed(this.session.timeline, names, press.time, time);
    this.session.select(press.adds ? new Set([...press.marks, ...found]) : found, [...found][0]);
  }

  private end(event: PointerEvent, isKept: boolean): void {
    if (event.pointerId === this.press?.pointer) this.finish(isKept);
  }

  private finish(isKept: boolean): void {
    const press = this.press!;
    this.press = undefined;
    this.box.hidden = true;
    this.bubble.hidden = true;
    const { session } = this;
    this.axis.hold(false);
    if (press.isDrag && press.mark) session.endDrag(isKept);
    else if (press.isDrag) session.announceSelection();
    else if (!isKept) return;
    else if (!press.mark) session.select(press.adds ? press.marks : new Set());
    else if (press.adds) session.toggleSelected(press.mark);
    else session.select(new Set([press.mark]), press.mark);
  }

  /** A double click on a lane adds a keyframe or a burst there. */
  private add(event: MouseEvent): void {
    // The target is what has captured the pointer.
    const target = document.elementFromPoint(event.clientX, event.clientY);
    const row = rowOf(target);
    if (!row || target!.closest('.timeline-name, .timeline-top')) return;
    const lane = row.dataset.lane!;
    const step = snapped(this.axis.timeAt(event.clientX), this.session.grid);
    if (this.nearest(row, event.clientX, REACH.mouse)) return;
    const emitter = emitterOf(lane);
    if (emitter === undefined) this.session.toggleKeyframe(lane, step);
    else this.session.addBurst(emitter, step);
  }

  /** The keyframe of a lane within reach of the pointer. */
  private nearest(row: HTMLElement, clientX: number, reach: number): Mark | undefined {
    const time = this.axis.timeAt(clientX);
    const marks = marksOf(this.session.timeline, row.dataset.lane!);
    const away = marks.map((mark) => Math.abs(placeOf(mark).step - time) * this.axis.pixels);
    const nearest = away.indexOf(Math.min(...away));
    return away[nearest] <= reach ? marks[nearest] : undefined;
  }

  private elementOf(mark: Mark): HTMLElement | null {
    return this.body.querySelector(`[data-mark="${CSS.escape(mark)}"]`);
  }

  /** Scrolls while a drag is at the left or the right edge. */
  private scrollAtEdges(): void {
    const { press, scroller } = this;
    if (!press?.isDrag) return;
    requestAnimationFrame(() => this.scrollAtEdges());
    const { left, right } = scroller.getBoundingClientRect();
    const names = scroller.querySelector('.timeline-corner')!.getBoundingClientRect().width;
    const { clientX } = this.latest;
    const way = clientX > right - EDGE ? 1 : clientX < left + names + EDGE ? -1 : 0;
    const before = scroller.scrollLeft;
    if (way !== 0) scroller.scrollLeft += way * EDGE_SPEED;
    if (scroller.scrollLeft !== before) this.drag(press);
  }

  private zoom(event: WheelEvent): void {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    this.axis.zoom(Math.exp(-event.deltaY / (event.deltaMode === 0 ? 200 : 8)), event.clientX);
  }

  /** Two fingers zoom. */
  private pinch(): void {
    let span: number | undefined;
    const spanOf = ({ touches: [a, b] }: TouchEvent) => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    this.scroller.addEventListener('touchstart', (event) => {
      span = event.touches.length === 2 ? spanOf(event) : undefined;
      if (span !== undefined && this.press) this.finish(false);
    });
    this.scroller.addEventListener(
      'touchmove',
      (event) => {
        if (event.touches.length !== 2 || span === undefined) return;
        if (event.cancelable) event.preventDefault();
        const now = spanOf(event);
        const [a, b] = event.touches;
        this.axis.zoom(now / Math.max(1, span), (a.clientX + b.clientX) / 2);
        span = now;
      },
      { passive: false },
    );
  }
}

function rowOf(target: EventTarget | null): HTMLElement | null {
  return target instanceof Element ? target.closest<HTMLElement>('.timeline-row') : null;
}
