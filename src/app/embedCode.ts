import { create, textButton } from './dom.ts';
import { elementCode, frameCode } from './embed.ts';
import { strings } from './strings.ts';

const words = strings.share;

/** Code to put this smoke on another page, folded until somebody wants it. @param copy copies a text */
export function createEmbed(copy: (text: string) => void): { element: HTMLElement; show(link?: string): void } {
  const frame = createSnippet(words.frame, copy);
  const component = createSnippet(words.element, copy);
  const element = create('details', { class: 'group share-embed' }, create('summary', {}, words.embed));
  element.append(frame.element, component.element);
  return {
    element,
    show(link) {
      element.hidden = link === undefined;
      if (link === undefined) return;
      frame.field.value = frameCode(link, strings.title);
      component.field.value = elementCode(link);
    },
  };
}

function createSnippet(name: string, copy: (text: string) => void) {
  const field = create('textarea', { readonly: true, rows: 3, 'aria-label': name, spellcheck: 'false' });
  field.addEventListener('focus', () => field.select());
  const button = textButton('quiet', words.copyCode, () => copy(field.value));
  const head = create('div', { class: 'share-snippet-head' }, create('span', {}, name), button);
  return { element: create('div', { class: 'share-snippet' }, head, field), field };
}
