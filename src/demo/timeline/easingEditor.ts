import { eased, EASING_CURVES, type Easing } from '../../internal.ts';
import { create, createSvg, uniqueId } from '../ui/dom.ts';
import { words } from './words.ts';

const NAMES = ['hold', 'linear', 'ease', 'easeIn', 'easeOut'] as const;
type Named = (typeof NAMES)[number];
type Handles = readonly [x1: number, y1: number, x2: number, y2: number];

/** The drawing: a square for time and way from 0 to 1, with room for handles above and below. */
const [SIDE, ROOM, MARGIN] = [100, 34, 8];
/** Range of handles that the drawing shows. Others stay at its edges. */
const [LOW, HIGH] = [-ROOM / SIDE, 1 + ROOM / SIDE];
const [STEP, LARGE_STEP] = [0.02, 0.1];
/** Samples of a drawn curve. */
const SAMPLES = 32;
const ARROWS: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowDown: [0, -1],
  ArrowUp: [0, 1],
};
const STRAIGHT: Handles = [1 / 3, 1 / 3, 2 / 3, 2 / 3];

export interface EasingListener {
  /** Called on each change, often many times per gesture. */
  change(easing: Easing): void;
  /** Called at the end of a gesture. */
  settle(): void;
}

/** Easings by name, and a curve with two handles that are dragged or moved with the arrow keys. */
export class EasingEditor {
  readonly element: HTMLElement;
  private readonly listener: EasingListener;
  private readonly buttons: ReadonlyMap<Named, HTMLButtonElement>;
  private readonly drawing: SVGSVGElement;
  private readonly curve = createSvg('path', { class: 'easing-curve' });
  private readonly arms = createSvg('path', { class: 'easing-arms' });
  private readonly handles: readonly SVGElement[];
  private easing: Easing | undefined;
  private held: { readonly pointer: number; readonly at: 0 | 1 } | undefined;

  constructor(listener: EasingListener) {
    this.listener = listener;
    this.buttons = new Map(NAMES.map((name) => [name, this.createButton(name)]));
    this.handles = [this.createHandle(0), this.createHandle(1)];
    const box = `${-MARGIN} ${-ROOM} ${SIDE + 2 * MARGIN} ${SIDE + 2 * ROOM}`;
    this.drawing = createSvg('svg', {
      class: 'easing-drawing',
      viewBox: box,
      role: 'group',
      'aria-label': words.curve,
    });
    const plane = createSvg('rect', { class: 'easing-plane', x: 0, y: 0, width: SIDE, height: SIDE });
    this.drawing.append(plane, this.curve, this.arms, ...this.handles);
    this.drawing.addEventListener('pointermove', (event) => this.drag(event));
    this.drawing.addEventListener('pointerup', (event) => this.release(event));
    this.drawing.addEventListener('pointercancel', (event) => this.release(event));
    const id = uniqueId();
    const names = create('div', { class: 'easing-names', role: 'group', 'aria-labelledby': id });
    names.append(...this.buttons.values());
    const title = create('span', { id, class: 'read-aloud' }, words.easing);
    this.element = create('div', { class: 'easing' }, title, names, this.drawing);
  }

  /** @param easing undefined for several different ones */
  show(easing: Easing | undefined): void {
    this.easing = easing;
    for (const [name, button] of this.buttons) button.setAttribute('aria-pressed', String(name === easing));
    const handles = handlesOf(easing);
    this.drawing.classList.toggle('is-mixed', easing === undefined);
    this.curve.setAttribute('d', easing === undefined ? '' : pathOf(easing));
    const places = [
      [handles[0], handles[1]],
      [handles[2], handles[3]],
    ].map(([x, y]) => [x, Math.min(Math.max(y, LOW), HIGH)] as const);
    const isStill = easing === 'hold' || easing === undefined;
    const [first, second] = places.map(([x, y]) => `${SIDE * x} ${SIDE * (1 - y)}`);
    this.arms.setAttribute('d', isStill ? '' : `M0 ${SIDE}L${first}M${SIDE} 0L${second}`);
    this.handles.forEach((handle, at) => {
      const [x, y] = places[at];
      handle.setAttribute('transform', `translate(${SIDE * x} ${SIDE * (1 - y)})`);
      handle.setAttribute('aria-label', words.handle(at + 1, handles[2 * at], handles[2 * at + 1]));
      handle.toggleAttribute('hidden', isStill);
      handle.setAttribute('tabindex', isStill ? '-1' : '0');
      handle.style.display = isStill ? 'none' : '';
    });
  }

  private createButton(name: Named): HTMLButtonElement {
    const drawing = createSvg('svg', { viewBox: '-3 -3 30 30', class: 'easing-icon', 'aria-hidden': 'true' });
    drawing.append(createSvg('path', { d: pathOf(name, 24) }));
    const label = create('span', {}, words.easings[name]);
    const button = create('button', { type: 'button', class: 'easing-name' }, drawing, label);
    button.addEventListener('click', () => {
      this.listener.change(name);
      this.listener.settle();
    });
    return button;
  }

  private createHandle(at: 0 | 1): SVGElement {
    const dot = createSvg('circle', { class: 'easing-dot', r: 7 });
    const reach = createSvg('circle', { class: 'easing-reach', r: 18 });
    const handle = createSvg('g', { class: 'easing-handle', role: 'button', tabindex: 0 }, reach, dot);
    handle.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      this.held = { pointer: event.pointerId, at };
      this.drawing.setPointerCapture(event.pointerId);
      handle.focus();
      event.preventDefault();
    });
    handle.addEventListener('keydown', (event) => {
      const way = ARROWS[event.key];
      if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      const step = event.shiftKey ? LARGE_STEP : STEP;
      const handles = handlesOf(this.easing);
      this.moveTo(at, handles[2 * at] + step * way[0], handles[2 * at + 1] + step * way[1]);
    });
    handle.addEventListener('keyup', () => this.listener.settle());
    return handle;
  }

  private drag({ pointerId, clientX, clientY }: PointerEvent): void {
    if (pointerId !== this.held?.pointer) return;
    const box = this.drawing.getBoundingClientRect();
    const scale = Math.min(box.width / (SIDE + 2 * MARGIN), box.height / (SIDE + 2 * ROOM));
    const x = (clientX - (box.left + box.width / 2)) / scale / SIDE + 0.5;
    const y = ((box.top + box.bottom) / 2 - clientY) / scale / SIDE + 0.5;
    this.moveTo(this.held.at, x, y);
  }

  private release({ pointerId }: PointerEvent): void {
    if (pointerId !== this.held?.pointer) return;
    this.held = undefined;
    this.listener.settle();
  }

  private moveTo(at: 0 | 1, x: number, y: number): void {
    const handles = [...handlesOf(this.easing)];
    handles[2 * at] = rounded(Math.min(Math.max(x, 0), 1));
    handles[2 * at + 1] = rounded(Math.min(Math.max(y, LOW), HIGH));
    this.listener.change(handles as unknown as Handles);
  }
}

function handlesOf(easing: Easing | undefined): Handles {
  if (easing === undefined || easing === 'linear' || easing === 'hold') return STRAIGHT;
  return typeof easing === 'string' ? EASING_CURVES[easing] : easing;
}

/** The curve from the bottom left to the top right of a square. */
function pathOf(easing: Easing, side: number = SIDE): string {
  if (easing === 'hold') return `M0 ${side}H${side}V0`;
  const points = Array.from({ length: SAMPLES + 1 }, (_, at) => at / SAMPLES);
  return points.map((at, place) => `${place === 0 ? 'M' : 'L'}${side * at} ${side * (1 - eased(easing, at))}`).join('');
}

function rounded(value: number): number {
  return Number(value.toFixed(2));
}
