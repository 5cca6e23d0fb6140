/** The canvas over the page, or a canvas of the page. */
import type { Box } from '../plane.ts';
import { clientBox, parentOf } from '../zoom.ts';
import { boxOf, type Source } from './target.ts';

/** What an engine draws on. */
export interface Sheet {
  readonly canvas: HTMLCanvasElement;
  /** CSS pixels of the canvas for each client pixel: not 1 where the page is zoomed or transformed. */
  readonly scale: number;
  /** Whether the canvas has the size of the window. */
  readonly followsWindow: boolean;
  /** Whether the window has another size than at the latest `place`. */
  readonly hasOtherSize: boolean;
  /** The element of the top layer that the canvas is in front of. */
  readonly host: Element | undefined;
  /** Creates the canvas, or another one in its place. */
  makeCanvas(): HTMLCanvasElement;
  /** Moves the canvas to what is visible now, and in front of an element of the top layer, if any. */
  place(host?: Element): void;
  /** Moves the picture, until the next `place`, in client pixels. */
  shift(x: number, y: number): void;
  /** The canvas in client pixels. */
  rectangle(): Box;
  style(layer: 'above' | 'below' | undefined, zIndex: number | undefined): void;
  remove(): void;
}

const Z_INDEX = { above: 9999, below: -1 };

const STYLE = { all: 'initial', display: 'block', 'pointer-events': 'none' };
/** Layout containment keeps the canvas out of the size of the document. */
const FRAME_STYLE = { ...STYLE, left: '0', top: '0', width: '0', height: '0', contain: 'layout' };
const CANVAS_STYLE = { ...STYLE, position: 'absolute', left: '0', top: '0' };

/**
 * A canvas over the visible part of the page. It scrolls with the page and changes neither its layout nor its size. The
 * popover around it is in a shadow tree, where rules of the page for `::backdrop` do not apply.
 */
export class Overlay implements Sheet {
  canvas: HTMLCanvasElement;
  host: Element | undefined;
  readonly followsWindow = true;
  private readonly outer = styled(document.createElement('div'), { ...FRAME_STYLE, position: 'absolute' });
  private readonly frame = styled(document.createElement('div'), FRAME_STYLE);
  private window = '';
  private at = { x: 0, y: 0 };
  private readonly print = matchMedia('print');
  private readonly handlePrint = () => styled(this.frame, { display: this.print.matches ? 'none' : 'block' });

  constructor() {
    this.outer.setAttribute('aria-hidden', 'true');
    this.frame.append(document.createElement('slot'));
    this.outer.attachShadow({ mode: 'open' }).append(this.frame);
    this.canvas = this.makeCanvas();
    this.print.addEventListener('change', this.handlePrint);
  }

  get scale(): number {
    return scaleOf(this);
  }

  get hasOtherSize(): boolean {
    return this.window !== visible().join();
  }

  makeCanvas(): HTMLCanvasElement {
    this.canvas = styled(document.createElement('canvas'), CANVAS_STYLE);
    this.outer.replaceChildren(this.canvas);
    this.place(this.host);
    return this.canvas;
  }

  place(host?: Element): void {
    this.enter(host);
    const [width, height] = visible();
    this.window = visible().join();
    // First as if the root were neither moved nor zoomed, and then as measured.
    this.setBox(0, 0, width, height);
    const { left, top, width: drawn } = this.rectangle();
    const pixel = drawn / Math.max(width, 1) || 1;
    this.setBox(-left / pixel, -top / pixel, width / pixel, height / pixel);
  }

  /** Enters the top layer as its last element, or leaves it. The order of its elements is that of their entry. */
  private enter(host: Element | undefined): void {
    const { outer, frame } = this;
    // Not in the body, whose children the page may count, replace or lay out.
    const parent = host && !('showPopover' in frame) ? host : document.documentElement;
    if (outer.parentNode !== parent) parent.append(outer);
    frame.removeAttribute('popover');
    if (host && parent !== host) {
      frame.popover = 'manual';
      frame.showPopover();
    }
    this.host = host;
    const isFixed = host && getComputedStyle(host).position === 'fixed';
    styled(frame, { position: isFixed ? 'fixed' : 'absolute' });
  }

  private setBox(x: number, y: number, width: number, height: number): void {
    styled(this.canvas, { width: `${width}px`, height: `${height}px` });
    this.moveTo(x, y);
  }

  /** Not by `left` or `transform`: where only these change, Firefox makes the document longer in spite of containment. */
  private moveTo(x: number, y: number): void {
    this.at = { x, y };
    styled(this.canvas, { margin: `${y}px 0 0 ${x}px` });
  }

  shift(x: number, y: number): void {
    const { at, scale } = this;
    this.moveTo(at.x + scale * x, at.y + scale * y);
  }

  rectangle(): Box {
    return clientBox(this.canvas);
  }

  style(layer: 'above' | 'below' = 'above', zIndex = Z_INDEX[layer]): void {
    styled(this.outer, { 'z-index': String(zIndex) });
  }

  remove(): void {
    this.print.removeEventListener('change', this.handlePrint);
    this.outer.remove();
  }
}

function scaleOf(sheet: Sheet): number {
  return sheet.canvas.clientWidth / Math.max(sheet.rectangle().width, 1);
}

/** Width and height of the visible part of the page without its scroll bars, client pixels. */
function visible(): [width: number, height: number] {
  const { clientWidth, clientHeight } = document.documentElement;
  return [clientWidth, Math.min(innerHeight, clientHeight)];
}

/** Sets styles by script, so that policies without 'unsafe-inline' allow them. */
export function styled<Styled extends HTMLElement>(element: Styled, style: Readonly<Record<string, string>>): Styled {
  for (const [name, value] of Object.entries(style)) element.style.setProperty(name, value, 'important');
  return element;
}

const usedCanvases = new WeakSet<HTMLCanvasElement>();
const copies = new WeakMap<HTMLCanvasElement, HTMLCanvasElement>();

/** A canvas of the page. It keeps its place, its size and its style. */
export class OwnCanvas implements Sheet {
  canvas: HTMLCanvasElement;
  readonly followsWindow = false;
  readonly hasOtherSize = false;
  readonly host = undefined;

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    for (let copy = copies.get(canvas); copy; copy = copies.get(copy)) this.canvas = copy;
  }

  get scale(): number {
    return scaleOf(this);
  }

  makeCanvas(): HTMLCanvasElement {
    // A canvas that was transferred to a worker cannot be used again, not even by the next engine.
    if (usedCanvases.has(this.canvas)) {
      const copy = this.canvas.cloneNode() as HTMLCanvasElement;
      this.canvas.replaceWith(copy);
      copies.set(this.canvas, copy);
      this.canvas = copy;
    }
    usedCanvases.add(this.canvas);
    return this.canvas;
  }

  place(): void {}

  shift(): void {}

  rectangle(): Box {
    return boxOf(this.canvas);
  }

  style(): void {}

  remove(): void {}
}

/** The top layer: modal dialogs, popovers and what is on full screen, in front of every `z-index`. */

const SELECTORS = [':modal', ':popover-open', ':fullscreen', 'select:open'];

/** The element of the top layer that a source is in, if any. A point counts as what is under it. */
export function topLayerOf(source: Source): Element | undefined {
  const { left, top } = source.box() ?? { left: -1, top: -1 };
  for (let each = source.inside ?? elementAt(left, top); each; each = parentOf(each)) {
    // All of the page is in front of nothing else, and a frame has a top layer of its own.
    const part = each;
    if (part.ownerDocument !== document || part === document.documentElement) continue;
    if (SELECTORS.some((selector) => isMatch(part, selector))) return part;
  }
  return undefined;
}

function elementAt(x: number, y: number): Element | undefined {
  let found = document.elementFromPoint(x, y) ?? undefined;
  for (let outer; found?.shadowRoot && found !== outer;) {
    outer = found;
    found = found.shadowRoot.elementFromPoint(x, y) ?? found;
  }
  return found;
}

/** Older browsers throw for selectors that they do not know. */
function isMatch(element: Element, selector: string): boolean {
  try {
    return element.matches(selector);
  } catch {
    return false;
  }
}
