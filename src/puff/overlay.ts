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
  /** The canvas in client pixels. */
  rectangle(): DOMRect;
  style(layer: 'above' | 'below' | undefined, zIndex: number | undefined): void;
  remove(): void;
}

const Z_INDEX = { above: 9999, below: -1 };

const STYLE = {
  all: 'initial',
  display: 'block',
  position: 'absolute',
  'pointer-events': 'none',
  contain: 'strict',
};

/** A canvas over the visible part of the page. It scrolls with the page and does not change its layout. */
export class Overlay implements Sheet {
  canvas: HTMLCanvasElement;
  readonly scale = 1;
  readonly followsWindow = true;

  constructor() {
    this.canvas = this.makeCanvas();
  }

  makeCanvas(): HTMLCanvasElement {
    this.canvas?.remove();
    const canvas = (this.canvas = document.createElement('canvas'));
    canvas.setAttribute('aria-hidden', 'true');
    // By script, so that policies without 'unsafe-inline' allow it.
    for (const [name, value] of Object.entries(STYLE)) canvas.style.setProperty(name, value, 'important');
    this.place();
    return canvas;
  }

  place(): void {
    const { canvas } = this;
    // Not in the body, whose children the page may count, replace or lay out.
    if (!canvas.isConnected) document.documentElement.append(canvas);
    const { clientWidth, clientHeight } = document.documentElement;
    const box = { left: scrollX, top: scrollY, width: clientWidth, height: Math.min(innerHeight, clientHeight) };
    for (const [name, pixels] of Object.entries(box)) canvas.style.setProperty(name, `${pixels}px`, 'important');
  }

  rectangle(): DOMRect {
    return this.canvas.getBoundingClientRect();
  }

  style(layer: 'above' | 'below' = 'above', zIndex = Z_INDEX[layer]): void {
    this.canvas.style.setProperty('z-index', String(zIndex), 'important');
  }

  remove(): void {
    this.canvas.remove();
  }
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

  rectangle(): DOMRect {
    return this.canvas.getBoundingClientRect();
  }

  style(): void {}

  remove(): void {}
}
