import type { Value } from '../preset/parameter.ts';
import type { Stage } from '../stage/stage.ts';
import type { Editor } from './editor.ts';

/**
 * Lets stage and editor follow each other: edits reach the stage once a frame, and values that somebody gives to the
 * stage directly, as from the console, reach the editor.
 * @param tell says what the stage refused
 */
export function connectStage(editor: Editor, stage: Stage, tell: (message: string) => void): void {
  let waiting: Record<string, Value> = {};
  const isWaiting = () => Object.keys(waiting).length > 0;
  const flush = () => {
    const values = waiting;
    waiting = {};
    try {
      stage.set(values);
    } catch (error) {
      tell((error as Error).message);
      editor.adopt(stage.get());
    }
  };
  editor.listen((_state, changed) => {
    const wasWaiting = isWaiting();
    Object.assign(waiting, changed);
    if (!wasWaiting && isWaiting()) requestAnimationFrame(flush);
  });
  stage.on('statechange', () => {
    if (!isWaiting()) editor.adopt(stage.get());
  });
}
