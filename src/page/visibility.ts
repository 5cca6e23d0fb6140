import type { Stage } from '../stage/stage.ts';

/** Distance from the viewport at which fetching starts: about one second of fast scrolling. */
const MARGIN = '400px';

/**
 * Calls back once when an element comes near the viewport.
 * @returns a function that stops observing
 */
export function whenNear(element: Element, arrive: () => void): () => void {
  // scrollMargin applies to nested scroll containers. Browsers without support ignore it.
  const margins = { rootMargin: MARGIN, scrollMargin: MARGIN };
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    observer.disconnect();
    arrive();
  }, margins);
  observer.observe(element);
  return () => observer.disconnect();
}

/** Pauses while the page is hidden, and resumes only if the stage was playing. */
export function pauseWhileHidden(stage: Stage): void {
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
