import { whyNotAnimated } from '../../internal.ts';
import { findParameter } from '../../preset.ts';
import { iconButton, setAttributes } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { keyframeOf, markOf } from './model.ts';
import type { Session } from './session.ts';
import { words } from './words.ts';

/** Diamonds beside the controls of the panel: they set and remove keyframes at the playhead. */
export class RowKeyframes {
  private readonly panel: HTMLElement;
  private readonly session: Session;
  private readonly buttons = new Map<string, HTMLButtonElement>();
  /** Keys of animated parameters, and of those with a keyframe at the playhead. */
  private shown = '';

  constructor(panel: HTMLElement, session: Session) {
    this.panel = panel;
    this.session = session;
    this.add();
    // Items get their rows when they are opened.
    new MutationObserver(() => this.add()).observe(panel, { childList: true, subtree: true });
  }

  show(): void {
    const { timeline, step } = this.session;
    const animated = timeline.lanes.map(({ key }) => key);
    const here = animated.filter((key) => keyframeOf(timeline, markOf(key, step)));
    const shown = `${animated.join()};${here.join()}`;
    if (shown === this.shown) return;
    this.shown = shown;
    const [isAnimated, isHere] = [new Set(animated), new Set(here)];
    for (const [key, button] of this.buttons) showState(key, button, isAnimated.has(key), isHere.has(key));
  }

  /** Adds diamonds to the rows that have none. */
  private add(): void {
    const rows = this.panel.querySelectorAll<HTMLElement>('.row[data-key]:not(:has(> .keyframe))');
    // Not the timeline itself, and not what stands for several parameters.
    const those = [...rows].filter(({ dataset }) => dataset.key !== 'timeline' && findParameter(dataset.key!));
    for (const row of those) {
      const key = row.dataset.key!;
      const why = whyNotAnimated(key);
      const { label } = findParameter(key)!;
      const name = why === undefined ? words.rowAdd(label) : words.rowWhy(label, why);
      const button = iconButton('keyframe', name, icon('keyframe'), () => this.session.toggleKeyframe(key));
      // Not disabled, so that its name says why.
      if (why !== undefined) button.setAttribute('aria-disabled', 'true');
      this.buttons.set(key, button);
      row.prepend(button);
    }
    if (those.length === 0) return;
    this.shown = '';
    this.show();
  }
}

function showState(key: string, button: HTMLButtonElement, isAnimated: boolean, isHere: boolean): void {
  if (button.hasAttribute('aria-disabled')) return;
  const { label } = findParameter(key)!;
  button.classList.toggle('is-animated', isAnimated);
  button.classList.toggle('is-on', isHere);
  const name = isHere ? words.rowRemove(label) : words.rowAdd(label);
  setAttributes(button, { 'aria-label': name, title: name });
}
