import type { Stage } from '../../index.ts';
import { strings } from '../strings.ts';
import { Flag } from './flag.ts';
import type { Notices } from './notices.ts';

/** Explains the gestures on the picture at the first visit, until the first one or until it is dismissed. */
export function showHint(stage: Stage, canvas: HTMLElement, notices: Notices): void {
  const isKnown = new Flag('knowsGestures');
  if (isKnown.value) return;
  const used = new AbortController();
  const learn = () => {
    isKnown.value = true;
    used.abort();
  };
  const held = strings.scenes[String(stage.get().scene)]?.hand;
  const remove = notices.explain(strings.hint(held), learn);
  used.signal.addEventListener('abort', remove);
  for (const gesture of ['pointerdown', 'wheel', 'keydown']) {
    canvas.addEventListener(gesture, learn, { signal: used.signal, passive: true });
  }
}
