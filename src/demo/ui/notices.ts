import { afterRunning } from '../../internal.ts';
import type { Decoded } from '../../preset.ts';
import { create, iconButton, textButton } from './dom.ts';
import { icon } from './icons.ts';
import { strings } from '../strings.ts';

// Display time in milliseconds: long enough to read a sentence twice. A busy page does not draw new notices, so only
// running time counts.
const TRANSIENT_MS = 6000;

/** Shows all notices of something that was read. */
export function notifyAll(notices: Notices, { notices: list }: Pick<Decoded, 'notices'>): void {
  for (const { message } of list) notices.notify(message);
}

/** Notices for the user. They are announced politely and can be dismissed. */
export class Notices {
  readonly element = create('div', {
    class: 'notices',
    role: 'status',
    // Announces only new notices.
    'aria-atomic': 'false',
    'aria-label': strings.notices.title,
  });

  /** A notice that stays until it is dismissed. The text may contain untrusted input. */
  notify(message: string): void {
    this.add(message, 'notice');
  }

  /** A notice without need for action, which disappears after a timeout. */
  mention(message: string): void {
    const notice = this.add(message, 'notice is-transient');
    afterRunning(TRANSIENT_MS, () => notice.remove());
  }

  /** A passing notice. It does not block pointer input and disappears after a timeout. */
  whisper(message: string): void {
    const text = create('p', { class: 'whisper' }, message);
    this.element.append(text);
    afterRunning(TRANSIENT_MS, () => text.remove());
  }

  /** A notice with an action. It stays until the action is taken or the notice is dismissed. */
  offer(message: string, action: string, act: () => void): void {
    const button = textButton('quiet', action, () => {
      notice.remove();
      act();
    });
    const notice = this.add(message, 'notice');
    notice.lastElementChild!.before(button);
  }

  /**
   * A hint. It stays until it is dismissed or removed, and is hidden while a flow is drawn.
   * @returns a function that removes it
   */
  explain(message: string, onDismiss: () => void): () => void {
    const notice = this.add(message, 'notice is-hint', onDismiss);
    return () => notice.remove();
  }

  private add(message: string, className: string, onDismiss?: () => void): HTMLElement {
    const text = create('p', {}, message);
    const dismiss = iconButton('icon-button', strings.notices.dismiss, icon('close'), () => {
      notice.remove();
      onDismiss?.();
    });
    const notice = create('div', { class: className }, text, dismiss);
    this.element.append(notice);
    return notice;
  }
}
