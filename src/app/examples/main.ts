/** The page with the examples. */
import { copyText } from '../share/copyText.ts';
import { Card } from './card.ts';
import { examples } from './examples.ts';

/** A card plays while it crosses the middle of the window: one at a time, for the sake of slow devices. */
const MIDDLE = '-49% 0px -50% 0px';

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

async function copy(text: string): Promise<void> {
  status.textContent = '';
  status.textContent = (await copyText(text))
    ? 'Copied.'
    : 'The browser does not allow copying. Select the code and copy it.';
}

const container = document.querySelector('#examples')!;
for (const example of examples) {
  const card = new Card(example, isStill, (text) => void copy(text));
  cards.set(card.element, card);
  container.append(card.element);
  observer.observe(card.element);
}
