import type { Stage } from '../../index.ts';
import type { Values } from '../../preset.ts';
import { withProgress } from '../ui/progress.ts';
import { strings } from '../strings.ts';

/**
 * Enters the scene of these values, and shows progress over the previous scene if loading is slow.
 * @throws the errors of `Stage.enter`
 */
export function enterScene(stage: Stage, values: Values, container: HTMLElement): Promise<void> {
  const { loading } = strings.scenes[String(values.scene)];
  return withProgress(loading, container, (onProgress) => stage.enter(values, { onProgress }));
}
