import type { AnyValues, RampParameter } from '../../preset.ts';
import { MAX_COLORS, MIN_COLORS, readRamp, writeRamp, type RampStop } from '../../internal.ts';
import type { Control, ControlListener } from './controlTypes.ts';
import { create, createSvg, textButton, uniqueId } from '../ui/dom.ts';
import { strings } from '../strings.ts';

const [WIDTH, HEIGHT, MARGIN] = [240, 28, 8];
const STEP = 0.02;
/** Minimum distance between stops: the precision of the ramp's text format, so that two stops can make a hard step. */
const MIN_GAP = 0.001;
/** Toggles that blend the colours of ramps, by the ends of their keys. Other ramps are always blended. */
const BLENDED_BY: Readonly<Record<string, string>> = {
  ramp: 'style.rampBlend',
  ageRamp: 'style.softColors',
  heatRamp: 'style.softColors',
  colors: 'style.rampBlend',
  ageColors: 'style.softColors',
  heatColors: 'style.softColors',
};
/** Initial stops after a press on the bar of an empty ramp. */
const FIRST_STOPS: readonly RampStop[] = [
  { at: 0, color: '#6a6a8c' },
  { at: 0.5, color: '#ffffff' },
];

const ARROWS: Readonly<Record<string, number>> = {
  ArrowLeft: -STEP,
  ArrowDown: -STEP,
  ArrowRight: STEP,
  ArrowUp: STEP,
};

/** Bubbles from the panel when the user wants to take all colours from a file. */
export const PALETTE_EVENT = 'openpalette';

/**
 * Ramp editor: a bar of colours. Stops are dragged or moved with the arrow keys. A press on the bar adds one; Delete or
 * the button removes the selected one. With fewer than two stops the ramp is empty. The colour of the selected stop is
 * edited below.
 * @param current returns all current values, which decide whether the bar shows steps or blended colours
 */
export function createRamp(
  { key, label }: RampParameter,
  describedBy: string,
  listener: ControlListener,
  current: () => AnyValues,
): Control {
  const editor = new RampEditor(label, listener, () => (current()[BLENDED_BY[key.split('.').at(-1)!]] ?? 1) === 1);
  editor.drawing.setAttribute('aria-describedby', describedBy);
  if (key === 'style.ramp') editor.element.append(createPaletteButton());
  return { elements: [editor.element], id: editor.drawing.id, show: (text) => editor.show(String(text)) };
}

function createPaletteButton(): HTMLElement {
  const button = textButton('quiet ramp-palette', strings.palette.open, () => {
    button.dispatchEvent(new CustomEvent(PALETTE_EVENT, { bubbles: true }));
  });
  return button;
}

class RampEditor {
  readonly drawing = createSvg('svg', { id: uniqueId(), class: 'ramp', role: 'group' });
  readonly element: HTMLElement;
  private readonly gradient = createSvg('linearGradient', { id: uniqueId() });
  private readonly handles = createSvg('g', {});
  private readonly colorInput = create('input', { type: 'color', 'aria-label': strings.ramp.color });
  private readonly removeButton = textButton('quiet', strings.ramp.remove, () => this.remove());
  private readonly tools = create('div', { class: 'ramp-tools' }, this.colorInput, this.removeButton);
  private readonly listener: ControlListener;
  private readonly isBlended: () => boolean;
  private stops: readonly RampStop[] = [];
  private chosen = 0;
  private isHeld = false;

  constructor(label: string, listener: ControlListener, isBlended: () => boolean) {
    this.listener = listener;
    this.isBlended = isBlended;
    const box = `${-MARGIN} -2 ${WIDTH + 2 * MARGIN} ${HEIGHT + MARGIN + 4}`;
    this.drawing.setAttribute('viewBox', box);
    this.drawing.setAttribute('aria-label', label);
    const bar = createSvg('rect', { class: 'ramp-bar', x: 0, y: 0, width: WIDTH, height: HEIGHT });
    const hint = createSvg('text', { class: 'ramp-hint', x: WIDTH / 2, y: 0.65 * HEIGHT }, strings.ramp.begin);
    const fill = `url(#${this.gradient.id})`;
    const colors = createSvg('rect', { width: WIDTH, height: HEIGHT, fill });
    this.drawing.append(this.gradient, colors, bar, hint, this.handles);
    this.element = create('div', { class: 'ramp-holder' }, this.drawing, this.tools);
    bar.addEventListener('pointerdown', (event) => this.add(event));
    this.movePressedStop();
    this.colorInput.addEventListener('input', () => this.paint(this.colorInput.value));
    this.colorInput.addEventListener('change', () => listener.settle());
  }

  show(text: string): void {
    this.stops = readRamp(text) ?? [];
    this.chosen = Math.max(0, Math.min(this.chosen, this.stops.length - 1));
    const isEmpty = this.stops.length === 0;
    this.tools.hidden = isEmpty;
    this.drawing.classList.toggle('is-empty', isEmpty);
    if (!isEmpty) this.colorInput.value = this.stops[this.chosen].color;
    this.drawColors();
    this.drawHandles();
  }

  private drawColors(): void {
    const isBlended = this.isBlended();
    const colors = this.stops.flatMap(({ at, color }, index) => {
      const before = isBlended || index === 0 ? [] : [this.stops[index - 1].color];
      return [...before, color].map((each) => createSvg('stop', { offset: at, 'stop-color': each }));
    });
    this.gradient.replaceChildren(...colors);
  }

  /** Reuses handle elements, so that the focus stays. */
  private drawHandles(): void {
    const { handles, stops } = this;
    while (handles.childElementCount > stops.length) handles.lastElementChild!.remove();
    while (handles.childElementCount < stops.length) handles.append(this.createHandle(handles.childElementCount));
    stops.forEach(({ at, color }, index) => {
      const handle = handles.children[index];
      handle.setAttribute('cx', String(at * WIDTH));
      handle.setAttribute('fill', color);
      handle.setAttribute('aria-label', strings.ramp.stop(index + 1, color, at));
      handle.classList.toggle('is-chosen', index === this.chosen);
    });
  }

  private createHandle(index: number): SVGElement {
    const handle = createSvg('circle', { class: 'ramp-stop', cy: HEIGHT, r: 8, tabindex: 0, role: 'button' });
    handle.addEventListener('focus', () => this.choose(index));
    handle.addEventListener('pointerdown', (event) => {
      this.choose(index);
      this.capturePointer(event);
    });
    handle.addEventListener('keydown', (event) => this.press(event, index));
    handle.addEventListener('keyup', () => this.listener.settle());
    return handle;
  }

  private choose(index: number): void {
    this.chosen = index;
    this.colorInput.value = this.stops[index].color;
    this.drawHandles();
  }

  private press(event: KeyboardEvent, index: number): void {
    const way = ARROWS[event.key];
    if (way !== undefined) this.change(withPlace(this.stops, index, this.stops[index].at + way));
    else if (event.key === 'Delete') this.remove();
    else if (event.key === 'Enter') this.colorInput.click();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private add(event: PointerEvent): void {
    if (this.stops.length === MAX_COLORS) return;
    if (this.stops.length === 0) return this.settled(FIRST_STOPS);
    const at = this.placeOf(event);
    const after = this.stops.findIndex((stop) => stop.at > at);
    this.chosen = after < 0 ? this.stops.length : after;
    const { color } = this.stops[Math.max(0, this.chosen - 1)];
    const stops = this.stops.toSpliced(this.chosen, 0, { at, color });
    if (hasGaps(stops)) this.change(stops);
    this.capturePointer(event);
  }

  private remove(): void {
    const rest = this.stops.filter((_, index) => index !== this.chosen);
    this.settled(rest.length < MIN_COLORS ? [] : rest);
  }

  private paint(color: string): void {
    this.change(this.stops.with(this.chosen, { ...this.stops[this.chosen], color }));
  }

  private settled(stops: readonly RampStop[]): void {
    this.change(stops);
    this.listener.settle();
  }

  private change(stops: readonly RampStop[]): void {
    this.listener.change(writeRamp(stops));
  }

  private capturePointer({ pointerId }: PointerEvent): void {
    this.isHeld = true;
    this.drawing.setPointerCapture(pointerId);
  }

  private movePressedStop(): void {
    this.drawing.addEventListener('pointermove', (event) => {
      if (this.isHeld) this.change(withPlace(this.stops, this.chosen, this.placeOf(event)));
    });
    const release = () => {
      if (this.isHeld) this.listener.settle();
      this.isHeld = false;
    };
    this.drawing.addEventListener('pointerup', release);
    this.drawing.addEventListener('pointercancel', release);
  }

  private placeOf({ clientX }: PointerEvent): number {
    const box = this.drawing.getBoundingClientRect();
    const across = ((clientX - box.left) / box.width) * (WIDTH + 2 * MARGIN) - MARGIN;
    return rounded(Math.max(0, Math.min(1, across / WIDTH)));
  }
}

/** Moves a stop, limited by its neighbours. */
export function withPlace(stops: readonly RampStop[], index: number, at: number): RampStop[] {
  const min = index === 0 ? 0 : stops[index - 1].at + MIN_GAP;
  const max = index === stops.length - 1 ? 1 : stops[index + 1].at - MIN_GAP;
  return stops.with(index, { ...stops[index], at: rounded(Math.max(min, Math.min(max, at))) });
}

function hasGaps(stops: readonly RampStop[]): boolean {
  return stops.every(({ at }, index) => index === 0 || at >= stops[index - 1].at + MIN_GAP);
}

/** Rounds to the precision of the ramp's text format. */
function rounded(at: number): number {
  return Number(at.toFixed(3));
}
