import type { Stage } from '../stage/stage.ts';

/** How far beyond the viewport an element may be for its smoke to be fetched: about a second of fast scrolling. */
const MARGIN = '400px';

/**
 * Calls back, once, when an element nears the viewport or is scrolled to.
 * @returns the function that ends the waiting
 */
export function whenNear(element: Element, arrive: () => void): () => void {
  // scrollMargin is for boxes that scroll within the page; browsers that do not know it leave it out.
  const margins = { rootMargin: MARGIN, scrollMargin: MARGIN };
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    observer.disconnect();
    arrive();
  }, margins);
  observer.observe(element);
  return () => observer.disconnect();
}

/** Rests while nobody can see the page, and goes on only if it was playing. */
export function restWhileHidden(stage: Stage): void {
  let goesOn = false;
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) {
      goesOn = stage.playing;
      stage.pause();
    } else if (goesOn) {
      stage.play();
    }
  });
}
