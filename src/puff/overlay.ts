/** The canvas over the page, or a canvas of the page. */

/** What an engine draws on. */
export interface Sheet {
  readonly canvas: HTMLCanvasElement;
  /** CSS pixels of the canvas for each CSS pixel of the page: not 1 where the page is transformed. */
  readonly scale: number;
  /** Whether the canvas has the size of the window. */
  readonly followsWindow: boolean;
  /** Creates the canvas, or another one in its place. */
  makeCanvas(): HTMLCanvasElement;
  /** Moves the canvas to what is visible now. */
  place(): void;
  /** Moves the picture, until the next `place`, in client pixels. */
  shift(x: number, y: number): void;
  /** The canvas in client pixels. */
  rectangle(): DOMRect;
  style(layer: 'above' | 'below' | undefined, zIndex: number | undefined): void;
  remove(): void;
}

const Z_INDEX = { above: 9999, below: -1 };

const STYLE = { all: 'initial', display: 'block', 'pointer-events': 'none' };
const FRAME_STYLE = { ...STYLE, position: 'absolute', contain: 'strict' };
const CANVAS_STYLE = { ...STYLE, width: '100%', height: '100%' };

/**
 * A canvas over the visible part of the page. It scrolls with the page and does not change its layout. The element
 * around it clips a shifted canvas, which would make the page longer.
 */
export class Overlay implements Sheet {
  canvas: HTMLCanvasElement;
  readonly scale = 1;
  readonly followsWindow = true;
  private readonly frame = styled(document.createElement('div'), FRAME_STYLE);
  private shifted = { x: 0, y: 0 };
  private readonly print = matchMedia('print');
  private readonly handlePrint = () => styled(this.frame, { display: this.print.matches ? 'none' : 'block' });

  constructor() {
    this.frame.setAttribute('aria-hidden', 'true');
    this.canvas = this.makeCanvas();
    this.print.addEventListener('change', this.handlePrint);
  }

  makeCanvas(): HTMLCanvasElement {
    this.canvas = styled(document.createElement('canvas'), CANVAS_STYLE);
    this.frame.replaceChildren(this.canvas);
    this.place();
    return this.canvas;
  }

  place(): void {
    const { frame } = this;
    // Not in the body, whose children the page may count, replace or lay out.
    if (!frame.isConnected) document.documentElement.append(frame);
    const { clientWidth, clientHeight } = document.documentElement;
    const box = { left: scrollX, top: scrollY, width: clientWidth, height: Math.min(innerHeight, clientHeight) };
    styled(frame, Object.fromEntries(Object.entries(box).map(([name, pixels]) => [name, `${pixels}px`])));
    this.shift(-this.shifted.x, -this.shifted.y);
  }

  shift(x: number, y: number): void {
    this.shifted = { x: this.shifted.x + x, y: this.shifted.y + y };
    styled(this.canvas, { translate: `${this.shifted.x}px ${this.shifted.y}px` });
  }

  rectangle(): DOMRect {
    return this.canvas.getBoundingClientRect();
  }

  style(layer: 'above' | 'below' = 'above', zIndex = Z_INDEX[layer]): void {
    styled(this.frame, { 'z-index': String(zIndex) });
  }

  remove(): void {
    this.print.removeEventListener('change', this.handlePrint);
    this.frame.remove();
  }
}

/** Sets styles by script, so that policies without 'unsafe-inline' allow them. */
function styled<Styled extends HTMLElement>(element: Styled, style: Readonly<Record<string, string>>): Styled {
  for (const [name, value] of Object.entries(style)) element.style.setProperty(name, value, 'important');
  return element;
}

/** A canvas of the page. It keeps its place, its size and its style. */
export class OwnCanvas implements Sheet {
  canvas: HTMLCanvasElement;
  readonly followsWindow = false;
  private isUsed = false;

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
  }

  get scale(): number {
    return this.canvas.clientWidth / Math.max(this.rectangle().width, 1);
  }

  makeCanvas(): HTMLCanvasElement {
    // A canvas that was transferred to a worker cannot be used again.
    if (this.isUsed) {
      const next = this.canvas.cloneNode() as HTMLCanvasElement;
      this.canvas.replaceWith(next);
      this.canvas = next;
    }
    this.isUsed = true;
    return this.canvas;
  }

  place(): void {}

  shift(): void {}

  rectangle(): DOMRect {
    return this.canvas.getBoundingClientRect();
  }

  style(): void {}

  remove(): void {}
}
