import { isAccepted } from '../../internal.ts';
import type { AnyValues, ChoiceParameter, NumberParameter, Parameter, Value } from '../../preset.ts';
import { createCurve } from './curveControl.ts';
import { create, textButton, uniqueId } from '../ui/dom.ts';
import { createOutline } from './outlineControl.ts';
import { createRamp } from './rampControl.ts';
import { strings } from '../strings.ts';
import type { Control, ControlListener } from './controlTypes.ts';

/**
 * Creates native inputs for a parameter.
 * @param describedBy id of the element with its description
 * @param current returns all current values
 */
export function createControl(
  parameter: Parameter,
  describedBy: string,
  listener: ControlListener,
  current: () => AnyValues,
): Control {
  switch (parameter.kind) {
    case 'toggle':
      return createToggle(describedBy, listener);
    case 'choice':
      return createChoice(parameter, describedBy, listener);
    case 'color':
      return createColor(describedBy, listener);
    case 'curve':
      return createCurve(describedBy, parameter, listener);
    case 'ramp':
      return createRamp(parameter, describedBy, listener, current);
    case 'path':
      return createOpened(describedBy, listener, strings.flow, FLOW_EVENT, Number(parameter.key.split('.')[1]));
    case 'drawing':
      return createOpened(describedBy, listener, strings.drawing, DRAW_EVENT);
    case 'outline':
      return createOutline(parameter, describedBy, listener);
    case 'timeline':
      return createOpened(describedBy, listener, strings.timeline, TIMELINE_EVENT);
    default:
      return createNumber(parameter, describedBy, listener);
  }
}

function createToggle(describedBy: string, listener: ControlListener): Control {
  const id = uniqueId();
  const input = create('input', { id, type: 'checkbox', role: 'switch', 'aria-describedby': describedBy });
  input.addEventListener('change', () => {
    listener.change(input.checked ? 1 : 0);
    listener.settle();
  });
  return { elements: [input], id, show: (value) => void (input.checked = value === 1) };
}

function createChoice({ options }: ChoiceParameter, describedBy: string, listener: ControlListener): Control {
  const id = uniqueId();
  const entries = options.map(({ value, label }) => create('option', { value }, label));
  const select = create('select', { id, 'aria-describedby': describedBy }, ...entries);
  select.addEventListener('change', () => {
    listener.change(options[select.selectedIndex].value);
    listener.settle();
  });
  const show = (value: Value) => void (select.selectedIndex = options.findIndex((option) => option.value === value));
  return { elements: [select], id, show };
}

/** Bubbles from the panel when the user wants to draw puffs. */
export const DRAW_EVENT = 'drawpuffs';
/** Bubbles from the panel when the user wants to draw a flow; its detail is the index of the flow. */
export const FLOW_EVENT = 'drawflow';
/** Bubbles from the panel when the user wants to open the timeline. */
export const TIMELINE_EVENT = 'opentimeline';

/** Buttons that open the editor of a text, which is elsewhere on the page, and that make the text empty. */
function createOpened(
  describedBy: string,
  listener: ControlListener,
  words: { readonly open: string; readonly remove: string },
  event: string,
  detail?: number,
): Control {
  const open = textButton('quiet', words.open, () =>
    open.dispatchEvent(new CustomEvent(event, { bubbles: true, detail })),
  );
  open.id = uniqueId();
  open.setAttribute('aria-describedby', describedBy);
  // The label of the row would replace the text of the button.
  open.setAttribute('aria-label', words.open);
  const remove = textButton('quiet', words.remove, () => {
    listener.change('');
    listener.settle();
  });
  const elements = [create('div', { class: 'drawing-buttons' }, open, remove)];
  return { elements, id: open.id, show: (text) => void (remove.disabled = text === '') };
}

function createColor(describedBy: string, listener: ControlListener): Control {
  const id = uniqueId();
  const input = create('input', { id, type: 'color', 'aria-describedby': describedBy });
  input.addEventListener('input', () => listener.change(input.value));
  input.addEventListener('change', () => listener.settle());
  return { elements: [input], id, show: (value) => void (input.value = String(value)) };
}

function createNumber(parameter: NumberParameter, describedBy: string, listener: ControlListener): Control {
  const id = uniqueId();
  const range = createRange(parameter, id, describedBy, listener);
  const exact = createExact(parameter, listener);
  let shown = parameter.default;
  range.addEventListener('keydown', (event) => {
    const steps = ARROWS[event.key];
    if (steps === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    listener.change(stepBy(parameter, shown, event.shiftKey ? 10 * steps : steps));
  });
  range.addEventListener('keyup', () => listener.settle());
  const show = (value: Value) => {
    shown = Number(value);
    range.value = String(placeOf(parameter, shown));
    range.setAttribute('aria-valuetext', `${shown} ${parameter.unit}`.trim());
    range.style.setProperty('--filled', String(filledShare(parameter, shown)));
    if (exact.value === '' || Number(exact.value) !== shown) exact.value = String(shown);
    exact.removeAttribute('aria-invalid');
  };
  return { elements: [exact, range], id, show };
}

export const ARROWS: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

function createRange(parameter: NumberParameter, id: string, describedBy: string, listener: ControlListener) {
  const limits = { min: lowestPlace(parameter), max: PLACES, step: 1 };
  const range = create('input', { id, type: 'range', ...limits, 'aria-describedby': describedBy });
  range.addEventListener('input', () => listener.change(valueAt(parameter, range.valueAsNumber)));
  range.addEventListener('change', () => listener.settle());
  return range;
}

function createExact(parameter: NumberParameter, listener: ControlListener): HTMLInputElement {
  const { min, max, label } = parameter;
  const name = strings.panel.exactly(label);
  const exact = create('input', { type: 'number', min, max, step: 'any', inputmode: 'decimal', 'aria-label': name });
  exact.addEventListener('input', () => {
    const value = exact.valueAsNumber;
    exact.setAttribute('aria-invalid', String(!isAccepted(parameter, value)));
    if (isAccepted(parameter, value)) listener.change(value);
  });
  exact.addEventListener('change', () => {
    // Numbers out of range are clamped, as in a link. Other text restores the previous value.
    const value = parameter.kind === 'integer' ? Math.round(exact.valueAsNumber) : exact.valueAsNumber;
    if (!Number.isNaN(value)) listener.change(Math.min(Math.max(value, min), max));
    listener.settle();
  });
  return exact;
}

function filledShare(parameter: NumberParameter, value: number): number {
  const lowest = lowestPlace(parameter);
  return (placeOf(parameter, value) - lowest) / (PLACES - lowest);
}

/** Slider positions on each side of the origin: enough for every pixel of a wide panel. */
export const PLACES = 500;

/** Origin of the fine part of a range: 0 if the range contains it, otherwise the lower end. */
function origin({ min, max }: NumberParameter): number {
  return min < 0 && max > 0 ? 0 : min;
}

/** Lowest slider position: -PLACES when the range extends below its origin, otherwise 0. */
export function lowestPlace(parameter: NumberParameter): number {
  return parameter.min < origin(parameter) ? -PLACES : 0;
}

/** The slider position of a value. */
export function placeOf(parameter: NumberParameter, value: number): number {
  const share = (value - origin(parameter)) / spanTowards(parameter, value >= origin(parameter));
  return Math.round(PLACES * (parameter.slider === 'fine' ? Math.cbrt(share) : share));
}

/** The value at a slider position, rounded to a multiple of the step from the origin, within the range. */
export function valueAt(parameter: NumberParameter, place: number): number {
  // The ends of the range may not be multiples of the step.
  if (place >= PLACES) return parameter.max;
  if (place <= -PLACES) return parameter.min;
  const share = place / PLACES;
  const bent = parameter.slider === 'fine' ? share ** 3 : share;
  const value = origin(parameter) + bent * spanTowards(parameter, place >= 0);
  return clampToStep(parameter, value);
}

/** The value after arrow-key presses. On a cubic slider, a step in position would be too small near the origin. */
export function stepBy(parameter: NumberParameter, value: number, steps: number): number {
  return clampToStep(parameter, value + steps * parameter.step);
}

function spanTowards(parameter: NumberParameter, upwards: boolean): number {
  return upwards ? parameter.max - origin(parameter) : origin(parameter) - parameter.min;
}

function clampToStep(parameter: NumberParameter, value: number): number {
  const { min, max, step } = parameter;
  const steps = Math.round((value - origin(parameter)) / step);
  // Rounds through a decimal string: 3 steps of 0.1 give 0.3 in the link, not 0.30000000000000004.
  const rounded = Number((origin(parameter) + steps * step).toPrecision(10));
  return Math.min(Math.max(rounded, min), max);
}
