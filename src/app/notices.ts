import { create, iconButton, textButton } from './dom.ts';
import { icon } from './icons.ts';
import { strings } from './strings.ts';

// Long enough to read a sentence twice.
const TRANSIENT_MS = 6000;

/** Messages for people: read aloud politely, each dismissible. */
export class Notices {
  readonly element = create('div', {
    class: 'notices',
    role: 'log',
    'aria-live': 'polite',
    'aria-label': strings.notices.title,
  });

  /** A message that stays until it is dismissed. The text may hold what a stranger wrote. */
  tell(message: string): void {
    this.add(message, 'notice');
  }

  /** A message that nobody has to deal with; it goes by itself. */
  mention(message: string): void {
    const notice = this.add(message, 'notice is-transient');
    setTimeout(() => notice.remove(), TRANSIENT_MS);
  }

  /** A message with something that people can do about it. */
  offer(message: string, name: string, act: () => void): void {
    this.add(message, 'notice').lastElementChild!.before(textButton('loud', name, act));
  }

  private add(message: string, className: string): HTMLElement {
    const text = create('p', {}, message);
    const dismiss = iconButton('icon-button', strings.notices.dismiss, icon('close'), () => notice.remove());
    const notice = create('div', { class: className }, text, dismiss);
    this.element.append(notice);
    return notice;
  }
}
