import { create, textButton } from './dom.ts';
import { strings } from './strings.ts';

/** The sheet of everything that pointer and keys can do. */
export function createHelp(): HTMLDialogElement {
  const { title, pointer, keys, paper, close } = strings.help;
  const list = create('dl', {}, ...[...pointer, ...keys].flatMap(([what, does]) => describe(what, does)));
  const button = textButton('loud', close, () => sheet.close());
  const link = create('p', {}, create('a', { href: './paper.html' }, paper));
  const heading = create('h2', { id: 'help-title' }, title);
  const sheet = create('dialog', { class: 'sheet card', 'aria-labelledby': 'help-title' }, heading, list, link, button);
  return sheet;
}

/** Opens the sheet, or closes it when it is open. */
export function toggleHelp(sheet: HTMLDialogElement): void {
  if (sheet.open) sheet.close();
  else sheet.showModal();
}

function describe(what: string, does: string): HTMLElement[] {
  return [create('dt', {}, what), create('dd', {}, does)];
}
