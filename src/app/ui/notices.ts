import { create, iconButton, textButton } from './dom.ts';
import { icon } from './icons.ts';
import { strings } from '../strings.ts';

// Long enough to read a sentence twice.
const TRANSIENT_MS = 6000;

/** Messages for people: read aloud politely, each dismissible. */
export class Notices {
  readonly element = create('div', {
    class: 'notices',
    role: 'status',
    // Only what is new is read, not what still stands.
    'aria-atomic': 'false',
    'aria-label': strings.notices.title,
  });

  /** A message that stays until it is dismissed. The text may hold what somebody else wrote. */
  notify(message: string): void {
    this.add(message, 'notice');
  }

  /** A message that nobody has to deal with; it goes by itself. */
  mention(message: string): void {
    const notice = this.add(message, 'notice is-transient');
    setTimeout(() => notice.remove(), TRANSIENT_MS);
  }

  /** A message in passing: it lies in nobody's way, not even a pointer's, and goes by itself. */
  whisper(message: string): void {
    const text = create('p', { class: 'whisper' }, message);
    this.element.append(text);
    setTimeout(() => text.remove(), TRANSIENT_MS);
  }

  /** A message with something to do about it; it stays until that is done or it is dismissed. */
  offer(message: string, action: string, act: () => void): void {
    const button = textButton('quiet', action, () => {
      notice.remove();
      act();
    });
    const notice = this.add(message, 'notice');
    notice.lastElementChild!.before(button);
  }

  private add(message: string, className: string): HTMLElement {
    const text = create('p', {}, message);
    const dismiss = iconButton('icon-button', strings.notices.dismiss, icon('close'), () => notice.remove());
    const notice = create('div', { class: className }, text, dismiss);
    this.element.append(notice);
    return notice;
  }
}
