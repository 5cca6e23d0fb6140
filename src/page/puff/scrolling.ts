/** The scrolling boxes around the targets of calls. */
import { parentOf, zoomOf } from '../zoom.ts';
import type { Sheet } from './overlay.ts';

interface Offset {
  readonly x: number;
  readonly y: number;
}

/** Moves the canvas with a scrolling box of the page while all smoke comes from inside it. */
export class Scrolling {
  private readonly sheet: Sheet;
  /** The boxes around each target. */
  private readonly calls = new Set<ReadonlySet<Element>>();
  private readonly offsets = new WeakMap<Element, Offset>();

  constructor(sheet: Sheet) {
    this.sheet = sheet;
  }

  /**
   * Follows the boxes around the target of a call.
   * @returns a function that stops
   */
  enter(target: Element | undefined): () => void {
    const boxes = new Set(target ? boxesAround(target) : []);
    const end = new AbortController();
    this.calls.add(boxes);
    for (const box of boxes) {
      this.offsets.set(box, offsetOf(box));
      scrollerOf(box).addEventListener('scroll', () => this.watch(box), { passive: true, signal: end.signal });
    }
    return () => {
      end.abort();
      this.calls.delete(boxes);
    };
  }

  private watch(box: Element): void {
    const before = this.offsets.get(box)!;
    const now = offsetOf(box);
    this.offsets.set(box, now);
    const hasAll = [...this.calls].every((boxes) => boxes.has(box));
    if (hasAll) this.sheet.shift(before.x - now.x, before.y - now.y);
  }
}

/** In client pixels. */
function offsetOf(box: Element): Offset {
  const zoom = zoomOf(box);
  return { x: zoom * box.scrollLeft, y: zoom * box.scrollTop };
}

/** The page of a frame scrolls with an event of its document. The canvas scrolls with this page by itself. */
function scrollerOf(box: Element): EventTarget {
  const { ownerDocument } = box;
  return ownerDocument !== document && box === ownerDocument.documentElement ? ownerDocument : box;
}

/** The elements whose scrolling moves an element, also across shadow trees. */
function boxesAround(element: Element): Element[] {
  const found: Element[] = [];
  for (let each: Element | undefined = element; each; each = parentOf(each)) {
    const { scrollHeight, clientHeight, scrollWidth, clientWidth } = each;
    if (each !== element && (scrollHeight > clientHeight || scrollWidth > clientWidth)) found.push(each);
    if (getComputedStyle(each).position === 'fixed') break;
  }
  return found;
}
