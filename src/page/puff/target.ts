/** Where the smoke of a call begins. */
import type { Box } from '../plane.ts';
import { clientBox } from '../zoom.ts';
import { ParameterError } from '../../base/errors.ts';

/** An event of a library, such as React or jQuery, around one of the browser. */
export interface WrappedEvent {
  readonly type: string;
  readonly target: unknown;
  readonly currentTarget: unknown;
  readonly nativeEvent?: unknown;
  readonly originalEvent?: unknown;
}

/** A ref of React, Vue or Angular, a component of Vue, or a list: its first element counts. */
export type ElementHolder =
  | { readonly current: Element | null }
  | { readonly value: Element | null }
  | { readonly nativeElement: Element | null }
  | { readonly $el: Element | null }
  | ArrayLike<Element>;

/**
 * An element, an event with coordinates, or a point in client pixels. Without a target, the middle of the window. Elements
 * and events can be those of a frame of the same origin.
 */
export type PuffTarget =
  Element | Text | Event | WrappedEvent | ElementHolder | { readonly x: number; readonly y: number } | null;

type FromView = (box: Box) => Box;

/** The target of a call. */
export interface Source {
  /** The element whose box the smoke leaves and flows around. */
  readonly element?: Element;
  /** The element whose scrolling boxes carry the smoke along. */
  readonly inside?: Element;
  /** Whether a trail follows the pointer. */
  readonly followsPointer: boolean;
  /** Where a place of the target's window is in this window. */
  readonly fromView: FromView;
  /**
   * The current box; the last known one after an element has lost its own. Undefined if there never was one: for
   * elements outside of the document, without a size, or with `display: none`.
   */
  box(): Box | undefined;
}

const ACCEPTED = 'an element, an event with coordinates, or { x, y } in client pixels';
const HOLDERS = ['current', 'value', 'nativeElement', '$el', 0] as const;

type Loose = Partial<Record<PropertyKey, unknown>>;

/** @throws ParameterError for anything that has no place on the page */
export function sourceOf(target?: PuffTarget): Source {
  if (!target) return pointSource(innerWidth / 2, innerHeight / 2, true);
  const element = elementOf(target) ?? HOLDERS.map((key) => elementOf((target as Loose)[key])).find(Boolean);
  if (element) return elementSource(element);
  if ('type' in Object(target) && 'target' in Object(target)) return eventSource(target as WrappedEvent);
  const { x, y } = target as DOMPoint;
  if (Number.isFinite(x) && Number.isFinite(y)) return pointSource(x, y, false);
  throw new ParameterError('target', target, ACCEPTED);
}

/** By shape, because an element of a frame is no instance of this window's classes. A text counts as its element. */
function elementOf(value: unknown): Element | undefined {
  const node = Object(value) as Element;
  if (node.nodeType === 3) return node.parentElement ?? undefined;
  return typeof node.getBoundingClientRect === 'function' && node.nodeType !== undefined ? node : undefined;
}

function eventSource(event: WrappedEvent): Source {
  const native = (event.nativeEvent ?? event.originalEvent ?? event) as Event;
  const at = placeOf(native);
  // A click by the keyboard has no place. Its element does.
  const element = [event.currentTarget, event.target].map(elementOf).find(Boolean);
  if (at && !(at.clientX === 0 && at.clientY === 0 && element)) {
    // Empty after the event.
    const inside = native.composedPath?.().map(elementOf).find(Boolean) ?? elementOf(event.target) ?? element;
    return pointSource(at.clientX, at.clientY, true, inside);
  }
  if (element) return elementSource(element);
  throw new ParameterError('target', event.type, 'an event with coordinates, or of an element');
}

function placeOf(event: Event): { clientX: number; clientY: number } | undefined {
  if ('clientX' in event) return event as MouseEvent;
  return 'changedTouches' in event ? (event as TouchEvent).changedTouches[0] : undefined;
}

/** A point that scrolls with the page. */
function pointSource(x: number, y: number, followsPointer: boolean, inside?: Element): Source {
  const fromView = fromViewOf(inside);
  const box = onPage(fromView({ left: x, top: y, width: 0, height: 0 }));
  return { inside, followsPointer, fromView, box: () => onPage(box, -1) };
}

/** @param sign 1 from the window to the page, -1 back */
function onPage({ left, top, width, height }: Box, sign = 1): Box {
  return { left: left + sign * scrollX, top: top + sign * scrollY, width, height };
}

function elementSource(element: Element): Source {
  const fromView = fromViewOf(element);
  let known: Box | undefined;
  const box = () => {
    const now = boxOf(element, fromView);
    if (now.width > 0 && now.height > 0) known = onPage(now);
    return known && onPage(known, -1);
  };
  box();
  return { element, inside: element, followsPointer: false, fromView, box };
}

/** The box of an element in client pixels of this window. */
export function boxOf(element: Element, fromView = fromViewOf(element)): Box {
  return fromView(clientBox(element));
}

/** @throws ParameterError for an element that is neither in this window nor in a frame of it */
function fromViewOf(element: Element | undefined): FromView {
  const frames: HTMLElement[] = [];
  for (let view = element?.ownerDocument.defaultView; view && view !== window; view = view.parent as typeof view) {
    const frame = view.frameElement as HTMLElement | null;
    const accepted = 'an element of this window, or of a frame of the same origin in it';
    if (!frame) throw new ParameterError('target', `an element of the window ${view.location.href}`, accepted);
    frames.push(frame);
  }
  return (box) => frames.reduce(throughFrame, box);
}

function throughFrame({ left, top, width, height }: Box, frame: HTMLElement): Box {
  const outer = clientBox(frame);
  const { paddingLeft, paddingTop, paddingRight } = getComputedStyle(frame);
  const [before, above, after] = [paddingLeft, paddingTop, paddingRight].map(Number.parseFloat);
  // The page of a frame is zoomed and transformed as the frame.
  const pixel = outer.width / Math.max(frame.offsetWidth, 1);
  const { innerWidth: inner = 1 } = (frame as HTMLIFrameElement).contentWindow ?? {};
  const scale = (pixel * (frame.clientWidth - before - after)) / Math.max(inner, 1);
  return {
    left: outer.left + pixel * (frame.clientLeft + before) + scale * left,
    top: outer.top + pixel * (frame.clientTop + above) + scale * top,
    width: scale * width,
    height: scale * height,
  };
}
