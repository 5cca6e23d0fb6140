import type { Stage } from '../../stage/stage.ts';
import { create, iconButton, textButton } from './dom.ts';
import { icon } from './icons.ts';
import { strings } from '../strings.ts';

/** The sheet of everything that pointer and keys can do in the scene that is shown. */
export class Help {
  readonly element: HTMLDialogElement;
  private readonly stage: Stage;
  private readonly byHand = create('dl', {});
  private readonly byKeys = create('dl', {});

  constructor(stage: Stage) {
    const { title, keyboard, paper, licenses, close } = strings.help;
    this.stage = stage;
    const button = textButton('loud', close, () => this.element.close());
    // On a phone the other one is far below.
    const cross = iconButton('icon-button sheet-close', close, icon('close'), () => this.element.close());
    const links = create(
      'p',
      { class: 'help-links' },
      create('a', { href: './paper.html' }, paper),
      create('a', { href: './third-party-licenses.txt' }, licenses),
    );
    // Else the first link has the focus when the sheet opens, far below its beginning.
    const heading = create('h2', { id: 'help-title', tabindex: -1, autofocus: true }, title);
    const attributes = { class: 'sheet card help', 'aria-labelledby': 'help-title' };
    const middle = create('h3', {}, keyboard);
    this.element = create('dialog', attributes, heading, cross, this.byHand, middle, this.byKeys, links, button);
  }

  /** Opens the sheet, or closes it when it is open. */
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
