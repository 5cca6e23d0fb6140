import type { Values } from '../../preset/parameter.ts';
import type { Stage } from '../../stage/stage.ts';
import { Progress } from '../ui/progress.ts';
import { strings } from '../strings.ts';

/** What comes sooner needs no word, milliseconds. */
const SOON_MS = 400;

/**
 * Goes to the scene of these values; where that takes its time, says so over the old one.
 * @throws what `Stage.enter` throws
 */
export async function enterScene(stage: Stage, values: Values, container: HTMLElement): Promise<void> {
  const progress = new Progress(strings.scenes[String(values.scene)].loading);
  const timer = setTimeout(() => container.append(progress.element), SOON_MS);
  try {
    await stage.enter(values, { onProgress: progress.follow });
  } finally {
    clearTimeout(timer);
    progress.element.remove();
  }
}
