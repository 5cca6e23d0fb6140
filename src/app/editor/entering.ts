import type { Stage } from '../../index.ts';
import type { Values } from '../../preset.ts';
import { Progress } from '../ui/progress.ts';
import { strings } from '../strings.ts';

/** Delay in milliseconds before a loading message appears. */
const SOON_MS = 400;

/**
 * Enters the scene of these values, and shows progress over the previous scene if loading is slow.
 * @throws the errors of `Stage.enter`
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
