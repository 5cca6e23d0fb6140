import { create, textButton } from './dom.ts';
import { elementCode, frameCode, type ElementScript } from './embed.ts';
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
      component.field.value = elementCode(link, publishedScript());
    },
  };
}

/** The copy that lies in the built site, at the address where the site is published; the development server has none. */
function publishedScript(): ElementScript | undefined {
  const path = import.meta.env.VITE_ELEMENT_SCRIPT as string | undefined;
  const integrity = import.meta.env.VITE_ELEMENT_INTEGRITY as string;
  return path ? { address: new URL(path, document.baseURI).href, integrity } : undefined;
}

function createSnippet(name: string, copy: (text: string) => void) {
  const field = create('textarea', { readonly: true, rows: 3, 'aria-label': name, spellcheck: 'false' });
  field.addEventListener('focus', () => field.select());
  const button = textButton('quiet', words.copyCode, () => copy(field.value));
  const head = create('div', { class: 'share-snippet-head' }, create('span', {}, name), button);
  return { element: create('div', { class: 'share-snippet' }, head, field), field };
}
