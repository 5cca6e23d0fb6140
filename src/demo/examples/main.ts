/** The page with the examples. */
import { copyText } from '../ui/output.ts';
import { create } from '../ui/dom.ts';
import { Card } from './card.ts';
import { examples } from './examples.ts';

/** A card plays while it crosses the middle of the window: one at a time, for the sake of slow devices. */
const MIDDLE = '-49% 0px -50% 0px';

const STATUS_MS = 4000;

const status = document.querySelector<HTMLElement>('#status')!;
const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
const cards = new Map<Element, Card>();
const observer = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      const card = cards.get(target)!;
      if (isIntersecting) card.enter();
      else card.leave();
    }
  },
  { rootMargin: MIDDLE },
);
let clearing: ReturnType<typeof setTimeout> | undefined;

async function copy(text: string): Promise<void> {
  const isCopied = await copyText(text);
  status.textContent = isCopied ? 'Copied.' : 'The browser does not allow copying. Select the code and copy it.';
  clearTimeout(clearing);
  clearing = setTimeout(() => (status.textContent = ''), STATUS_MS);
}

const contents = document.querySelector('.contents')!;
const container = document.querySelector('#examples')!;
for (const example of examples) {
  const card = new Card(example, isStill, (text) => void copy(text));
  cards.set(card.element, card);
  contents.append(create('li', {}, create('a', { href: `#${example.name}` }, example.title)));
  container.append(card.element);
  observer.observe(card.element);
}
