/** The page about `puff()`: a card for each effect. */
import { puff, type Effect, type PuffOptions } from '../../puff.ts';
import { create, textButton } from '../ui/dom.ts';
import { puffCode } from './code.ts';
import { createForm, type FormOptions } from './options.ts';

const TEXTS: Readonly<Record<Effect, string>> = {
  poof: 'A soft cloud opens around the target and drifts up.',
  pop: 'A ring of small puffs flies apart and is gone.',
  dust: 'Low clouds roll to both sides and settle.',
  trail: 'Smoke follows the pointer, or an element.',
  burst: 'A fountain of puffs shoots up and falls.',
  whoosh: 'A gust carries a streak of smoke away.',
  boom: 'A ring along the ground and a cloud that climbs.',
  vanish: 'The target dissolves into smoke and stays hidden.',
  appear: 'Smoke gathers from both sides and leaves the target.',
  form: 'Small puffs form the word of the target, or another text.',
};

const status = document.querySelector<HTMLElement>('#status')!;
const cards: { effect: Effect; code: HTMLElement; target: string }[] = [];
let options: FormOptions = {};

function card(effect: Effect): HTMLElement {
  const isOfElement = effect === 'vanish' || effect === 'appear';
  const target = isOfElement ? 'element' : effect === 'trail' ? 'event' : 'button';
  const subject = isOfElement ? create('span', { class: 'subject', 'aria-hidden': 'true' }, '★') : undefined;
  if (effect === 'appear') subject!.style.visibility = 'hidden';
  const button = create('button', { type: 'button', class: 'loud effect' }, effect);
  button.addEventListener('click', (event) => {
    if (effect === 'appear') subject!.style.visibility = 'hidden';
    if (effect === 'vanish') subject!.style.removeProperty('visibility');
    show(puff(subject ?? (effect === 'trail' ? event : button), optionsOf(effect)));
  });
  const code = create('code');
  const copy = textButton('quiet', 'Copy', () => void copyText(code.textContent));
  copy.setAttribute('aria-label', `Copy the code of ${effect}`);
  cards.push({ effect, code, target });
  const head = create('div', { class: 'effect-head' }, button, ...(subject ? [subject] : []));
  const line = create('div', { class: 'effect-code' }, code, copy);
  return create('li', { class: 'card' }, head, create('p', {}, TEXTS[effect]), line);
}

/** The options of a call. Only 'form' has a text, and 'poof' need not be named. */
function optionsOf(effect: Effect): PuffOptions {
  const { text, ...others } = options;
  return {
    ...(effect === 'poof' ? undefined : { effect }),
    ...(effect === 'form' ? { text } : undefined),
    ...others,
  };
}

function show(call: Promise<void>): void {
  status.textContent = '';
  call.catch((error: Error) => (status.textContent = error.message));
}

function showCode(): void {
  for (const { effect, code, target } of cards) {
    code.textContent = puffCode(target, optionsOf(effect));
  }
}

async function copyText(text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    status.textContent = 'Copied.';
  } catch {
    status.textContent = 'The browser does not allow copying. Select the code and copy it.';
  }
}

document.querySelector('#effects')!.append(...puff.effects.map(card));
document.querySelector('#options')!.append(
  createForm((next) => {
    options = next;
    showCode();
  }),
);
document.querySelector('#clear')!.addEventListener('click', () => puff.clear());
// Anywhere else on the page.
document.querySelector('main')!.addEventListener('click', (event) => {
  if (!(event.target as Element).closest('button, a, input, select, label, code, output, summary'))
    show(puff(event, optionsOf('poof')));
});
showCode();
