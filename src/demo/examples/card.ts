import { create, textButton, uniqueId } from '../ui/dom.ts';
import type { Example } from './examples.ts';

/** An example that plays, beside its code. */
export class Card {
  readonly element: HTMLElement;
  private readonly frame = create('div', { class: 'example-frame' });
  private readonly play: HTMLButtonElement;
  private readonly example: Example;
  private isStopped: boolean;

  /**
   * @param isStopped whether it waits for its button
   * @param copy copies a text
   */
  constructor(example: Example, isStopped: boolean, copy: (text: string) => void) {
    this.example = example;
    this.isStopped = isStopped;
    const { title, text, played, name } = example;
    const id = uniqueId();
    this.play = textButton('quiet', '', () => this.toggle());
    const alone = create('a', { href: pageOf(example), target: '_blank' }, 'Open alone');
    const note = played === name ? '' : ' The page that plays is built with Vite and looks the same.';
    this.element = create(
      'section',
      { class: 'example', id: name, 'aria-labelledby': id },
      create('h2', { id }, title),
      create('p', {}, text + note),
      create('div', { class: 'example-played' }, this.frame, create('div', { class: 'row' }, this.play, alone)),
      code(example, copy),
    );
    this.show(false);
  }

  /** Starts the example, unless its button has stopped it. */
  enter(): void {
    if (!this.isStopped) this.show(true);
  }

  /** Removes the example's page, with its WebGL context. */
  leave(): void {
    this.show(false);
  }

  private toggle(): void {
    this.isStopped = this.frame.childElementCount > 0;
    this.show(!this.isStopped);
  }

  private show(plays: boolean): void {
    const { title } = this.example;
    this.play.textContent = plays ? 'Stop' : 'Play';
    this.play.setAttribute('aria-label', `${plays ? 'Stop' : 'Play'} ${title}`);
    if (plays === this.frame.childElementCount > 0) return;
    this.frame.replaceChildren(...(plays ? [create('iframe', { src: pageOf(this.example), title })] : []));
  }
}

function pageOf({ played }: Example): string {
  return `./examples/${played}/index.html`;
}

/** The code, one file at a time. */
function code({ title, files }: Example, copy: (text: string) => void): HTMLElement {
  const group = uniqueId();
  const text = create('code');
  const block = create('pre', { tabindex: 0 }, text);
  const button = textButton('quiet', 'Copy', () => copy(text.textContent));
  const select = ([name, source]: Example['files'][number]) => {
    text.textContent = source;
    block.scrollTop = 0;
    block.setAttribute('aria-label', `${name} of ${title}`);
    button.setAttribute('aria-label', `Copy ${name} of ${title}`);
  };
  const names = create('fieldset', { class: 'example-files' }, create('legend', {}, `Files of ${title}`));
  for (const [at, file] of files.entries()) {
    const input = create('input', { type: 'radio', name: group, checked: at === 0 });
    input.addEventListener('change', () => select(file));
    names.append(create('label', {}, input, file[0]));
  }
  select(files[0]);
  return create('div', { class: 'example-code' }, create('div', { class: 'row' }, names, button), block);
}
