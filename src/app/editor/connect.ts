import type { Value } from '../../preset/parameter.ts';
import type { Stage } from '../../stage/stage.ts';
import type { Changes, Editor } from './editor.ts';
import { enterScene } from './entering.ts';

/**
 * Lets stage and editor follow each other: edits reach the stage once a frame, and values that somebody gives to the
 * stage directly, as from the console, reach the editor.
 * @param notify says what the stage rejected
 * @param container where progress is shown
 * @returns waits until the stage has taken up all edits: what is done to it before, they would undo
 */
export function connectStage(
  editor: Editor,
  stage: Stage,
  notify: (message: string) => void,
  container: HTMLElement,
): () => Promise<void> {
  let waiting: Changes = {};
  let isFlushing = false;
  // What the editor learns from the stage must not come back to it later: it would undo what a take has set meanwhile.
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
        // While edits waited for their frame, the editor heard nothing of what else was done to the stage.
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

/** Each call draws a picture in a pause: none for nothing. */
function apply(changes: Changes, stage: Stage): void {
  const taken = Object.keys(changes).filter((key) => changes[key] === undefined);
  const given = Object.entries(changes).filter((change): change is [string, Value] => change[1] !== undefined);
  if (taken.length > 0) stage.unset(taken);
  if (given.length > 0) stage.set(Object.fromEntries(given));
}
