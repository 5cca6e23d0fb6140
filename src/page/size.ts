// Ink is drawn at the resolution of the screen; beyond two pixels a CSS pixel nobody sees more, but every pixel costs.
const LARGEST_PIXEL_RATIO = 2;
// As many as a screen of 4K has: what is larger, such as an element as large as its page, is never seen whole.
const MAX_PIXELS = 3840 * 2160;

// WebGL guarantees less, but no machine that draws smoke has less.
const LONGEST_SIDE = 8192;

/** In CSS pixels, and how many pixels make one. */
export interface Size {
  readonly width: number;
  readonly height: number;
  readonly pixelRatio: number;
}

/** How large the picture in an element is to be. */
export function sizeOf(element: Element): Size {
  const { clientWidth: width, clientHeight: height } = element;
  const affordable = Math.sqrt(MAX_PIXELS / Math.max(1, width * height));
  const possible = LONGEST_SIDE / Math.max(1, width, height);
  return { width, height, pixelRatio: Math.min(devicePixelRatio, LARGEST_PIXEL_RATIO, affordable, possible) };
}

/**
 * Tells the size of an element whenever it changes, or the page is zoomed or goes to another screen.
 * @returns the function that ends it
 */
export function watchSize(element: Element, notify: (size: Size) => void): () => void {
  const end = new AbortController();
  const update = () => notify(sizeOf(element));
  const observer = new ResizeObserver(update);
  observer.observe(element);
  watchPixelRatio(update, end.signal);
  return () => {
    observer.disconnect();
    end.abort();
  };
}

/** A query holds for one pixel ratio: with each change the next is asked. */
function watchPixelRatio(update: () => void, signal: AbortSignal): void {
  const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  const change = () => {
    update();
    watchPixelRatio(update, signal);
  };
  query.addEventListener('change', change, { once: true, signal });
}
