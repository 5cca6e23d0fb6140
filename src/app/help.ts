import type { Stage } from '../stage/stage.ts';
import { create, textButton } from './dom.ts';
import { strings } from './strings.ts';

/** The sheet of everything that pointer and keys can do in the scene that is shown. */
export class Help {
  readonly element: HTMLDialogElement;
  private readonly stage: Stage;
  private readonly list = create('dl', {});

  constructor(stage: Stage) {
    const { title, paper, licenses, close } = strings.help;
    this.stage = stage;
    const button = textButton('loud', close, () => this.element.close());
    const links = create(
      'p',
      { class: 'help-links' },
      create('a', { href: './paper.html' }, paper),
      create('a', { href: './third-party-licenses.txt' }, licenses),
    );
    // Else the first link has the focus when the sheet opens, far below its beginning.
    const heading = create('h2', { id: 'help-title', tabindex: -1, autofocus: true }, title);
    const attributes = { class: 'sheet card help', 'aria-labelledby': 'help-title' };
    this.element = create('dialog', attributes, heading, this.list, links, button);
  }

  /** Opens the sheet, or closes it when it is open. */
  toggle(): void {
    if (this.element.open) return this.element.close();
    this.list.replaceChildren(...rows(this.stage).flatMap(([what, does]) => describe(what, does)));
    this.element.showModal();
  }
}

type Row = readonly [what: string, does: string];

function rows(stage: Stage): readonly Row[] {
  const { hand, arrows, depth, drops, pointer, keys } = strings.help;
  const held = strings.scenes[String(stage.get().scene)]?.hand;
  const drag: Row[] = held ? [[hand(held.thing), held.does]] : [];
  const move: Row[] = held ? [arrows(held.thing), depth(held.thing)] : [];
  return [...drag, ...pointer, ...(stage.dropCount > 0 ? drops : []), ...move, ...keys];
}

function describe(what: string, does: string): HTMLElement[] {
  return [create('dt', {}, what), create('dd', {}, does)];
}
