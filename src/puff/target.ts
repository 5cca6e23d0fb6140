/** Where the smoke of a call begins. */
import { ParameterError } from '../preset/errors.ts';

/** An element, an event with coordinates, or a point in client pixels. Without a target, the middle of the window. */
export type PuffTarget = Element | Event | { readonly x: number; readonly y: number } | null;

/** A box in client pixels; a point has no size. */
export interface TargetBox {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** The target of a call. */
export interface Source {
  /** The element whose box the smoke leaves and flows around. */
  readonly element?: Element;
  /** The element whose scrolling boxes carry the smoke along. */
  readonly inside?: Element;
  /** Whether a trail follows the pointer. */
  readonly followsPointer: boolean;
  /**
   * The current box; the last known one after an element has lost its own. Undefined if there never was one: for
   * elements outside of the document, without a size, or with `display: none`.
   */
  box(): TargetBox | undefined;
}

/** @throws ParameterError for anything that has no place on the page */
export function sourceOf(target?: PuffTarget): Source {
  if (!target) return pointSource(innerWidth / 2, innerHeight / 2, true);
  if (target instanceof Element) return elementSource(target);
  if (target instanceof Event) return eventSource(target);
  const { x, y } = target;
  if (Number.isFinite(x) && Number.isFinite(y)) return pointSource(x, y, false);
  throw new ParameterError('target', target, 'an element, an event with coordinates, or { x, y } in client pixels');
}

function eventSource(event: Event): Source {
  const at = placeOf(event);
  // A click by the keyboard has no place. Its element does.
  const element = [event.currentTarget, event.target].find((each) => each instanceof Element);
  if (at && !(at.clientX === 0 && at.clientY === 0 && element)) {
    // Empty after the event.
    const inside = event.composedPath().find((each) => each instanceof Element) ?? element;
    return { ...pointSource(at.clientX, at.clientY, true), inside };
  }
  if (element) return elementSource(element);
  throw new ParameterError('target', event.type, 'an event with coordinates, or of an element');
}

function placeOf(event: Event): { clientX: number; clientY: number } | undefined {
  if ('clientX' in event) return event as MouseEvent;
  return 'changedTouches' in event ? (event as TouchEvent).changedTouches[0] : undefined;
}

/** A point that scrolls with the page. */
function pointSource(x: number, y: number, followsPointer: boolean): Source {
  const [left, top] = [x + scrollX, y + scrollY];
  return { followsPointer, box: () => ({ left: left - scrollX, top: top - scrollY, width: 0, height: 0 }) };
}

function elementSource(element: Element): Source {
  let known: TargetBox | undefined;
  const box = () => {
    const { left, top, width, height } = element.getBoundingClientRect();
    if (width > 0 && height > 0) known = { left: left + scrollX, top: top + scrollY, width, height };
    return known && { ...known, left: known.left - scrollX, top: known.top - scrollY };
  };
  box();
  return { element, inside: element, followsPointer: false, box };
}
