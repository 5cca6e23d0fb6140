const SVG = 'http://www.w3.org/2000/svg';
const BUTTONS = {
  pause: ['Pause smoke', 'M5 3h4v14H5zM11 3h4v14h-4z'],
  play: ['Play smoke', 'M5 2.5 17 10 5 17.5z'],
  restart: ['Restart smoke', 'M10 3.5a7 7 0 1 0 7 7h-3a4 4 0 1 1-4-4v3.3L16 5 10 .2z'],
} as const;

/**
 * Whether nothing can be drawn here, as in older browsers and in the simulated DOMs of unit tests: the element then shows
 * its content.
 */
export const isInert = (): boolean => !(globalThis.WebGL2RenderingContext && document.adoptedStyleSheets);

/** What the shell shows: the poster, the smoke, the failure state, or that with a button to restart. */
export type Showing = 'poster' | 'smoke' | 'failure' | 'lost';

/**
 * Styles of the element. Everything inside the shadow tree is independent of the element's own box, so that smoke has a
 * usable size on a page that resets all styles, including those of the element.
 */
const css = `
:host { display: block; pointer-events: none; }
:host([hidden]) { display: none; }
:host([interactive]) { pointer-events: auto; }
.frame {
  position: relative; block-size: 100%; overflow: hidden; pointer-events: none;
  font: 500 14px/1 system-ui, sans-serif; color: var(--cartoon-smoke-button-color, #1d1720);
}
.sizer { display: block; inline-size: 100%; block-size: 100%; visibility: hidden; }
.layer { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; }
.interactive canvas { pointer-events: auto; touch-action: pan-y; cursor: grab; }
.interactive canvas.holding { cursor: grabbing; }
.poster ::slotted(*) { display: block !important; inline-size: 100% !important; block-size: 100% !important; object-fit: cover !important; }
.poster ::slotted(picture) { display: flex !important; flex-flow: column; justify-content: center; }
.fallback { display: none; }
.failed .fallback { display: block; overflow: auto; pointer-events: auto; }
.shown .poster { display: none; }
.frame:not(.shown) canvas { visibility: hidden; }
button {
  all: initial; position: absolute; box-sizing: border-box; display: none; place-items: center; cursor: pointer;
  inset-block-end: var(--cartoon-smoke-button-inset, 10px); inset-inline-end: var(--cartoon-smoke-button-inset, 10px);
  inline-size: var(--cartoon-smoke-button-size, 36px); block-size: var(--cartoon-smoke-button-size, 36px);
  border: 2px solid currentColor; border-radius: 50%; color: inherit; pointer-events: auto;
  background: var(--cartoon-smoke-button-background, #fff8ecd9); opacity: .55; transition: opacity .15s;
}
.shown button, .lost button { display: grid; }
button:hover, button:focus-visible, .still button, .lost button { opacity: 1; }
button:focus-visible { outline: 3px solid var(--cartoon-smoke-focus-color, #2f6fde); outline-offset: 2px; }
button svg { inline-size: 50%; block-size: 50%; fill: currentColor; }
@media (forced-colors: active) { button { background: ButtonFace; color: ButtonText; opacity: 1; } }
@media (prefers-reduced-motion: reduce) { button { transition: none; } }
@media print { .frame > button { display: none; } }
`;

/** One style sheet per document. A constructed style sheet cannot be shared between documents. */
const sheets = new WeakMap<Document, CSSStyleSheet>();

/** Content of the element's shadow tree: the canvas, the poster, the fallback and the button. */
export class Shell {
  /** Reserves the space of the canvas; as large as the element. */
  readonly container = document.createElement('div');
  readonly button = document.createElement('button');
  private readonly icon = document.createElementNS(SVG, 'path');
  private readonly root: ShadowRoot;
  private shown: HTMLCanvasElement | undefined;
  private isPlaying = false;

  constructor(root: ShadowRoot) {
    this.root = root;
    this.dress();
    this.container.className = 'frame';
    this.container.setAttribute('part', 'frame');
    this.container.append(layer('poster', 'poster'), layer('fallback'));
    if (!isInert()) this.container.append(sizer(), this.buildButton());
    root.append(this.container);
  }

  /**
   * Adopts the style sheet; called again for each new document. Documents of templates have no window and are never
   * rendered.
   */
  dress(): void {
    const { ownerDocument } = this.root;
    if (ownerDocument.defaultView && !isInert()) this.root.adoptedStyleSheets = [sheetOf(ownerDocument)];
  }

  /** The canvas; undefined before the smoke starts and after it ends. */
  get canvas(): HTMLCanvasElement | undefined {
    return this.shown;
  }

  /** Replaces the canvas. A canvas that was transferred to a worker cannot be reused. */
  makeCanvas(description: string | null): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    canvas.className = 'layer';
    canvas.setAttribute('part', 'canvas');
    this.shown?.remove();
    this.shown = canvas;
    this.describe(description);
    this.container.prepend(canvas);
    return canvas;
  }

  /** @param description accessible name; an empty one marks the smoke as decorative */
  describe(description: string | null): void {
    const { canvas } = this;
    if (!canvas) return;
    canvas.setAttribute('role', description === '' ? 'presentation' : 'img');
    canvas.setAttribute('aria-label', description ?? 'Cartoon smoke');
  }

  show(what: Showing): void {
    this.container.classList.toggle('shown', what === 'smoke');
    this.container.classList.toggle('failed', what === 'failure' || what === 'lost');
    this.container.classList.toggle('lost', what === 'lost');
    this.nameButton();
    if (what !== 'poster') return;
    this.shown?.remove();
    this.shown = undefined;
  }

  /** @param isStill whether nothing moves until the user starts playback, which highlights the button */
  showPlaying(isPlaying: boolean, isStill: boolean): void {
    this.isPlaying = isPlaying;
    this.nameButton();
    this.container.classList.toggle('still', isStill);
  }

  /** Sets the button's icon and its accessible name, which the page can localize. */
  nameButton(): void {
    const action = this.container.classList.contains('lost') ? 'restart' : this.isPlaying ? 'pause' : 'play';
    const [name, path] = BUTTONS[action];
    this.button.setAttribute('aria-label', this.root.host.getAttribute(`label-${action}`) ?? name);
    this.icon.setAttribute('d', path);
  }

  private buildButton(): HTMLButtonElement {
    const svg = document.createElementNS(SVG, 'svg');
    svg.setAttribute('viewBox', '0 0 20 20');
    svg.setAttribute('aria-hidden', 'true');
    svg.append(this.icon);
    this.button.type = 'button';
    this.button.setAttribute('part', 'button');
    this.button.append(svg);
    return this.button;
  }
}

/** An in-flow replaced element gives the element an intrinsic size where the page sets none, in table cells, too. */
function sizer(): SVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 16 9');
  svg.classList.add('sizer');
  svg.setAttribute('aria-hidden', 'true');
  return svg;
}

function layer(name: string, slot?: string): HTMLElement {
  const element = document.createElement('div');
  element.className = `layer ${name}`;
  element.setAttribute('part', name);
  const inner = document.createElement('slot');
  if (slot) inner.name = slot;
  element.append(inner);
  return element;
}

/** @param owner a document with a window */
function sheetOf(owner: Document): CSSStyleSheet {
  let sheet = sheets.get(owner);
  if (!sheet) {
    sheet = new owner.defaultView!.CSSStyleSheet();
    sheet.replaceSync(css);
    sheets.set(owner, sheet);
  }
  return sheet;
}
