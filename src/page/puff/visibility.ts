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
  if (!isChange || !isStyled(element)) {
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
      // The other end is the opacity that the page gives.
      const keyframes = [{ opacity: 0, offset: effect === 'vanish' ? 1 : 0 }];
      fade = element.animate?.(keyframes, { ...FADE[effect], fill: 'both', easing: 'ease-in-out' });
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

/** By shape, because an element of a frame is no instance of this window's classes. */
function isStyled(element: Element | undefined): element is Styled {
  return element !== undefined && 'style' in element;
}

/** The page's own inline visibility of the elements that are hidden. */
const hidden = new WeakMap<Styled, readonly [value: string, priority: string]>();

function hide(element: Styled): void {
  const { style } = element;
  if (!hidden.has(element)) {
    hidden.set(element, [style.getPropertyValue('visibility'), style.getPropertyPriority('visibility')]);
  }
  style.setProperty('visibility', 'hidden', 'important');
  skipTransitions(element);
}

function show(element: Styled): void {
  const { style } = element;
  const [value, priority] = hidden.get(element) ?? [''];
  hidden.delete(element);
  if (style.visibility !== 'visible') style.removeProperty('visibility');
  // A page that has hidden it inline wants it to appear.
  if (value === 'visible') style.setProperty('visibility', value, priority);
  element.removeAttribute('hidden');
  skipTransitions(element);
  // Hidden by a rule of the page.
  if (!element.isConnected || getComputedStyle(element).visibility === 'visible') return;
  style.visibility = 'visible';
  skipTransitions(element);
}

/** With a transition of the page, an element or its children would stay visible for a while. */
function skipTransitions(element: Styled): void {
  for (const each of element.getAnimations?.({ subtree: true }) ?? []) {
    if ((each as Partial<CSSTransition>).transitionProperty === 'visibility') each.finish();
  }
}
