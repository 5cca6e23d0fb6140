import { Progress } from './progress.ts';
import type { Scrubber, Way } from './scrubber.ts';
import { strings } from './strings.ts';

/** Shorter ways need no word. */
const PATIENCE_MS = 700;

/**
 * Where a way along the time line takes its time, says so and lets people stop it.
 * @param host where that is shown
 */
export function tellOfLongWays(scrubber: Scrubber, host: HTMLElement): void {
  let current: { way: Way; began: number } | undefined;
  let progress: Progress | undefined;
  const end = () => {
    progress?.element.remove();
    progress = undefined;
  };
  scrubber.listen((way) => {
    if (way !== current?.way) {
      end();
      current = way && { way, began: performance.now() };
    }
    if (!way || performance.now() - current!.began < PATIENCE_MS) return;
    if (!progress) {
      progress = new Progress(strings.progress.winding(way.goal), () => scrubber.stop());
      host.append(progress.element);
    }
    progress.show(way.share);
  });
}
