/** Hides the element of a `vanish` and shows that of an `appear`, with or without smoke. Layout does not change. */
import type { Effect } from './options.ts';

/** Milliseconds in which an element fades, and how long it waits for the smoke. */
const FADE = { vanish: { duration: 450, delay: 60 }, appear: { duration: 240, delay: 520 } } as const;

/** The change of an element's visibility. */
export interface VisibilityChange {
  /** Starts to fade. */
  readonly begin: () => void;
  /** Hides or shows the element, at once if it has not faded. */
  readonly end: () => void;
  /** Ends after the fade, if it has begun. */
  readonly finished: () => Promise<void>;
}

/** @param element that the effect hides or shows, if any */
export function visibilityChange(effect: Effect, element: Element | undefined): VisibilityChange {
  const isChange = effect === 'vanish' || effect === 'appear';
  if (!isChange || !(element instanceof HTMLElement || element instanceof SVGElement)) {
    return { begin() {}, end() {}, finished: async () => undefined };
  }
  let fade: Animation | undefined;
  const end = () => {
    if (effect === 'vanish') hide(element);
    else show(element);
    fade?.cancel();
    fade = undefined;
  };
  return {
    begin() {
      const opacity = effect === 'vanish' ? [1, 0] : [0, 1];
      fade = element.animate?.({ opacity }, { ...FADE[effect], fill: 'both', easing: 'ease-in-out' });
      if (effect === 'appear') show(element);
      fade?.addEventListener('finish', end, { once: true });
    },
    end,
    async finished() {
      // Cancelled by the page.
      await fade?.finished.catch(() => undefined);
      end();
    },
  };
}

type Styled = HTMLElement | SVGElement;

function hide(element: Styled): void {
  element.style.visibility = 'hidden';
}

function show(element: Styled): void {
  element.style.removeProperty('visibility');
  element.removeAttribute('hidden');
  // Hidden by a rule of the page.
  if (element.isConnected && getComputedStyle(element).visibility !== 'visible') element.style.visibility = 'visible';
}
