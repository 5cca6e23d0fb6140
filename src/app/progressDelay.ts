import { Progress } from './progress.ts';
import type { Scrubber, Seek } from './scrubber.ts';
import { strings } from './strings.ts';

/** Shorter ways need no word. */
const DELAY_MS = 700;

/**
 * Where a way along the time line takes its time, says so and lets people stop it.
 * @param container where that is shown
 */
export function showSlowProgress(scrubber: Scrubber, container: HTMLElement): void {
  let current: { seek: Seek; began: number } | undefined;
  let progress: Progress | undefined;
  const end = () => {
    progress?.element.remove();
    progress = undefined;
  };
  scrubber.listen((seek) => {
    if (seek !== current?.seek) {
      end();
      current = seek && { seek, began: performance.now() };
    }
    if (!seek || performance.now() - current!.began < DELAY_MS) return;
    if (!progress) {
      progress = new Progress(strings.transport.onWay(seek.goal), () => scrubber.stop());
      container.append(progress.element);
    }
    progress.show(seek.share);
  });
}
