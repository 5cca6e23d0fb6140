import type { Stage } from '../../index.ts';
import { create, iconButton, textButton } from './dom.ts';
import type { Flag } from './flag.ts';
import { icon } from './icons.ts';
import { strings } from '../strings.ts';

/** Dialog that lists all pointer gestures and keys of the current scene. */
export class Help {
  readonly element: HTMLDialogElement;
  private readonly stage: Stage;
  private readonly byHand = create('dl', {});
  private readonly byKeys = create('dl', {});

  /** @param noShortcuts whether shortcuts of a single character are turned off */
  constructor(stage: Stage, noShortcuts: Flag) {
    const { title, keyboard, shortcuts, paper, puff, examples, licenses, close } = strings.help;
    this.stage = stage;
    const button = textButton('loud', close, () => this.element.close());
    // On a phone the other close button is far below.
    const cross = iconButton('icon-button sheet-close', close, icon('close'), () => this.element.close());
    const links = create(
      'p',
      { class: 'help-links' },
      create('a', { href: './paper.html' }, paper),
      create('a', { href: './puff.html' }, puff),
      create('a', { href: './examples.html' }, examples),
      create('a', { href: './third-party-licenses.txt' }, licenses),
    );
    // Otherwise the first link, far below, would get the initial focus.
    const heading = create('h2', { id: 'help-title', tabindex: -1, autofocus: true }, title);
    const attributes = { class: 'sheet card help', 'aria-labelledby': 'help-title' };
    const middle = create('h3', {}, keyboard);
    const box = create('input', { type: 'checkbox', checked: !noShortcuts.value });
    box.addEventListener('change', () => (noShortcuts.value = !box.checked));
    const choice = create('label', { class: 'help-shortcuts' }, box, shortcuts);
    this.element = create(
      'dialog',
      attributes,
      heading,
      cross,
      this.byHand,
      middle,
      choice,
      this.byKeys,
      links,
      button,
    );
  }

  /** Opens or closes the dialog. */
  toggle(): void {
    if (this.element.open) return this.element.close();
    const { hand, keys } = rows(this.stage);
    this.byHand.replaceChildren(...hand.flatMap(describe));
    this.byKeys.replaceChildren(...keys.flatMap(describe));
    this.element.showModal();
  }
}

type Row = readonly [what: string, does: string];

function rows(stage: Stage): { hand: readonly Row[]; keys: readonly Row[] } {
  const { hand, arrows, depth, drops, dropKey, pointer, keys } = strings.help;
  const held = strings.scenes[String(stage.get().scene)]?.hand;
  const drag: Row[] = held ? [[hand(held.thing), held.does]] : [];
  const move: Row[] = held ? [arrows(held.thing), depth(held.thing)] : [];
  const canDrop = stage.dropCount > 0;
  return {
    hand: [...drag, ...pointer, ...(canDrop ? drops : [])],
    keys: [...move, ...(canDrop ? dropKey : []), ...keys],
  };
}

function describe([what, does]: Row): HTMLElement[] {
  return [create('dt', {}, what), create('dd', {}, does)];
}
