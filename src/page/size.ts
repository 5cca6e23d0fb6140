import { zoomOf } from './zoom.ts';

// Ink is drawn at device resolution. Above two device pixels per CSS pixel the difference is invisible, but the cost
// grows.
const LARGEST_PIXEL_RATIO = 2;
// The pixel count of a 4K screen. A larger element, for example one as tall as its page, is never fully visible.
const MAX_PIXELS = 3840 * 2160;

// WebGL guarantees less, but every GPU that can render smoke supports this size.
const LONGEST_SIDE = 8192;

/** Size in CSS pixels, and device pixels per CSS pixel. */
export interface Size {
  readonly width: number;
  readonly height: number;
  readonly pixelRatio: number;
}

/** Size of the drawing buffer for an element. */
export function sizeOf(element: Element): Size {
  const { clientWidth: width, clientHeight: height } = element;
  const affordable = Math.sqrt(MAX_PIXELS / Math.max(1, width * height));
  const possible = LONGEST_SIDE / Math.max(1, width, height);
  const wanted = devicePixelRatio * zoomOf(element);
  return { width, height, pixelRatio: Math.min(wanted, LARGEST_PIXEL_RATIO, affordable, possible) };
}

/**
 * Reports the size of an element when the element, the zoom factor or the screen changes.
 * @returns a function that stops watching
 */
export function watchSize(element: Element, notify: (size: Size) => void): () => void {
  const end = new AbortController();
  const update = () => notify(sizeOf(element));
  const observer = new ResizeObserver(update);
  // The box in device pixels also changes with CSS zoom. Safari has no such box.
  const hasDevicePixels = 'devicePixelContentBoxSize' in ResizeObserverEntry.prototype;
  observer.observe(element, { box: hasDevicePixels ? 'device-pixel-content-box' : 'content-box' });
  watchPixelRatio(update, end.signal);
  return () => {
    observer.disconnect();
    end.abort();
  };
}

/** A media query matches a single pixel ratio, so each change registers a new query. */
function watchPixelRatio(update: () => void, signal: AbortSignal): void {
  const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  const change = () => {
    update();
    watchPixelRatio(update, signal);
  };
  query.addEventListener('change', change, { once: true, signal });
}
