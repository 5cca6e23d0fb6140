import type { RemoteStage } from './contract.ts';

/** Drawing begins so many pixels before the canvas comes into view. */
const MARGIN = '64px';

/**
 * Lets a stage rest while its canvas is out of view or its page is hidden. What somebody paused stays paused.
 * @returns the function that ends this
 */
export function followSight(canvas: HTMLCanvasElement, stage: Pick<RemoteStage, 'setVisible'>): () => void {
  const page = canvas.ownerDocument;
  let isNear = true;
  let notified = true;
  const notify = () => {
    const isVisible = isNear && !page.hidden;
    if (isVisible === notified) return;
    notified = isVisible;
    // A stage that has ended meanwhile refuses, and needs to know no more.
    stage.setVisible(isVisible).catch(() => undefined);
  };
  const observer = new IntersectionObserver(
    (entries) => {
      isNear = entries.at(-1)!.isIntersecting;
      notify();
    },
    { rootMargin: MARGIN },
  );
  observer.observe(canvas);
  page.addEventListener('visibilitychange', notify);
  notify();
  return () => {
    observer.disconnect();
    page.removeEventListener('visibilitychange', notify);
  };
}
