import { MAX_STOPS, MIN_STOPS, readCurve, writeCurve, type Stop } from '../../internal.ts';
import type { CurveParameter } from '../../preset.ts';
import type { Control, ControlListener } from './controlTypes.ts';
import { create, createSvg, uniqueId } from '../ui/dom.ts';
import { strings } from '../strings.ts';

const [WIDTH, HEIGHT, MARGIN] = [240, 96, 8];
const STEP = 0.02;
/** Hit radius of a stop, large enough for touch. */
const REACH = 12;
/** Minimum distance between stops. */
const MIN_GAP = 0.02;

const ARROWS: Readonly<Record<string, readonly [at: number, value: number]>> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowDown: [0, -STEP],
  ArrowUp: [0, STEP],
};

/** Initial stops after a press on the plane of a curve without any. */
const FIRST_STOPS: readonly Stop[] = [
  { at: 0, value: 1 },
  { at: 1, value: 1 },
];

/**
 * Curve editor. Stops are dragged or moved with the arrow keys. A press on the empty plane adds one; Delete removes
 * one. A curve that can be empty is empty with fewer than two stops.
 */
export function createCurve(
  describedBy: string,
  { label, default: initial }: CurveParameter,
  listener: ControlListener,
): Control {
  const id = uniqueId();
  const line = createSvg('polyline', { class: 'curve-line' });
  const plane = createSvg('rect', { class: 'curve-plane', x: 0, y: 0, width: WIDTH, height: HEIGHT });
  const handles = createSvg('g', {});
  const hint = createSvg('text', { class: 'ramp-hint', x: WIDTH / 2, y: HEIGHT / 2 }, strings.ramp.begin);
  const box = `${-MARGIN} ${-MARGIN} ${WIDTH + 2 * MARGIN} ${HEIGHT + 2 * MARGIN}`;
  const drawing = createSvg(
    'svg',
    { id, class: 'curve', viewBox: box, role: 'group', 'aria-label': label },
    plane,
    line,
    hint,
    handles,
  );
  drawing.setAttribute('aria-describedby', describedBy);
  let stops: readonly Stop[] = [];
  let held = -1;
  /** Offset from the pointer to the dragged stop. */
  let grip: Stop = { at: 0, value: 0 };
  const change = (next: readonly Stop[]) => listener.change(writeCurve(next));

  drawing.addEventListener('pointerdown', (event) => {
    if (stops.length === 0) {
      change(FIRST_STOPS);
      return listener.settle();
    }
    const stop = pointed(drawing, event);
    held = reached(stops, stop);
    const { at, value } = stops[held] ?? stop;
    grip = { at: at - stop.at, value: value - stop.value };
    if (held < 0) {
      if (event.target !== plane || stops.length === MAX_STOPS) return;
      const index = stops.findIndex((other) => other.at > stop.at);
      held = index < 0 ? stops.length : index;
      change(moved([...stops.slice(0, held), stop, ...stops.slice(held)], held, stop));
    }
    drawing.setPointerCapture(event.pointerId);
  });
  drawing.addEventListener('pointermove', (event) => {
    if (held < 0) return;
    const { at, value } = pointed(drawing, event);
    change(moved(stops, held, { at: at + grip.at, value: value + grip.value }));
  });
  const release = () => {
    if (held >= 0) listener.settle();
    held = -1;
  };
  drawing.addEventListener('pointerup', release);
  drawing.addEventListener('pointercancel', release);

  const handleOf = (index: number): SVGElement => {
    const handle = createSvg('circle', { class: 'curve-stop', r: 6, tabindex: 0, role: 'button' });
    handle.addEventListener('keydown', (event) => {
      const way = ARROWS[event.key];
      const { at, value } = stops[index];
      if (way) change(moved(stops, index, { at: at + way[0], value: value + way[1] }));
      else if (event.key !== 'Delete') return;
      else if (stops.length > MIN_STOPS) change(stops.filter((_, other) => other !== index));
      else if (initial === '') change([]);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    handle.addEventListener('keyup', () => listener.settle());
    return handle;
  };

  const show = (text: string | number) => {
    stops = readCurve(String(text)) ?? [];
    drawing.classList.toggle('is-empty', stops.length === 0);
    while (handles.childElementCount > stops.length) handles.lastElementChild!.remove();
    while (handles.childElementCount < stops.length) handles.append(handleOf(handles.childElementCount));
    line.setAttribute('points', pointsOf(stops));
    stops.forEach(({ at, value }, index) => {
      const handle = handles.children[index];
      handle.setAttribute('cx', String(at * WIDTH));
      handle.setAttribute('cy', String((1 - value) * HEIGHT));
      handle.setAttribute('aria-label', strings.curve.stop(index + 1, at, value));
    });
  };
  return { elements: [create('div', { class: 'curve-holder' }, drawing)], id, show };
}

/** The pointer's position in curve coordinates. */
function pointed(drawing: SVGElement, { clientX, clientY }: PointerEvent): Stop {
  const box = drawing.getBoundingClientRect();
  const across = ((clientX - box.left) / box.width) * (WIDTH + 2 * MARGIN) - MARGIN;
  const down = ((clientY - box.top) / box.height) * (HEIGHT + 2 * MARGIN) - MARGIN;
  return { at: across / WIDTH, value: 1 - down / HEIGHT };
}

/** Index of the stop within reach of the pointer, or -1. */
function reached(stops: readonly Stop[], { at, value }: Stop): number {
  const away = stops.map((stop) => Math.hypot((stop.at - at) * WIDTH, (stop.value - value) * HEIGHT));
  const nearest = away.indexOf(Math.min(...away));
  return away[nearest] < REACH ? nearest : -1;
}

/** Moves a stop, limited by its neighbours and the plane. */
export function moved(stops: readonly Stop[], index: number, { at, value }: Stop): Stop[] {
  const min = index === 0 ? 0 : stops[index - 1].at + MIN_GAP;
  const max = index === stops.length - 1 ? 1 : stops[index + 1].at - MIN_GAP;
  const stop = { at: Math.max(min, Math.min(max, at)), value: Math.max(0, Math.min(1, value)) };
  return stops.map((other, number) => (number === index ? stop : other));
}

/** The curve is constant before the first stop and after the last. */
function pointsOf(stops: readonly Stop[]): string {
  if (stops.length === 0) return '';
  const [first, last] = [stops[0], stops[stops.length - 1]];
  const all = [{ at: 0, value: first.value }, ...stops, { at: 1, value: last.value }];
  return all.map(({ at, value }) => `${at * WIDTH},${(1 - value) * HEIGHT}`).join(' ');
}
