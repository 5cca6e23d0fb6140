import type { Stage } from '../../index.ts';
import type { Value } from '../../preset.ts';
import type { Changes, Editor } from './editor.ts';
import { enterScene } from './entering.ts';

/**
 * Synchronizes a stage and an editor. Edits reach the stage once per frame. Values set on the stage directly, for
 * example from the console, reach the editor.
 * @param notify reports what the stage rejected
 * @param container parent of the progress bar
 * @returns a function that waits until the stage has applied all edits. Await it before changing the stage: pending
 * edits would overwrite the change
 */
export function connectStage(
  editor: Editor,
  stage: Stage,
  notify: (message: string) => void,
  container: HTMLElement,
): () => Promise<void> {
  let waiting: Changes = {};
  let isFlushing = false;
  // Values that the editor adopts from the stage must not be sent back later: they would overwrite what a take has set.
  let isAdopting = false;
  const isWaiting = () => Object.keys(waiting).length > 0;
  const isBehind = () => isWaiting() || isFlushing;
  const adopt = () => {
    isAdopting = true;
    editor.adopt(stage.get());
    isAdopting = false;
  };
  const flush = async () => {
    const changes = waiting;
    waiting = {};
    isFlushing = true;
    try {
      const isElsewhere = (changes.scene ?? stage.get().scene) !== stage.get().scene;
      if (isElsewhere) {
        await enterScene(stage, editor.state.values, container);
      } else {
        apply(changes, stage);
        // While edits were pending, the editor ignored other changes to the stage.
        adopt();
      }
    } catch (error) {
      notify((error as Error).message);
      adopt();
    } finally {
      isFlushing = false;
      if (isWaiting()) requestAnimationFrame(flush);
    }
  };
  editor.listen((_state, changed) => {
    if (isAdopting) return;
    const wasWaiting = isWaiting();
    waiting = { ...waiting, ...changed };
    if (!wasWaiting && isWaiting() && !isFlushing) requestAnimationFrame(flush);
  });
  stage.on('statechange', () => {
    if (!isBehind()) adopt();
  });
  return async () => {
    while (isBehind()) await new Promise(requestAnimationFrame);
  };
}

/** Calls the stage only when there are changes, because each call redraws a paused stage. */
function apply(changes: Changes, stage: Stage): void {
  const taken = Object.keys(changes).filter((key) => changes[key] === undefined);
  const given = Object.entries(changes).filter((change): change is [string, Value] => change[1] !== undefined);
  if (taken.length > 0) stage.unset(taken);
  if (given.length > 0) stage.set(Object.fromEntries(given));
}
