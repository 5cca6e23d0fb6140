/** The page with the examples, with the sources of their projects. */
import { afterRunning } from '../../internal.ts';
import { copyText, create, textButton, uniqueId } from '../ui/dom.ts';

interface Example {
  /** Folder in examples/. */
  readonly name: string;
  readonly title: string;
  readonly text: string;
  /** Folder of the page that plays: frameworks with a build of their own are not part of the site. */
  readonly played: string;
  /** File names and texts, the most important file first. */
  readonly files: readonly (readonly [name: string, text: string])[];
}

const FOLDER = '../../../examples/';
const sources: Readonly<Record<string, string>> = import.meta.glob(
  '../../../examples/{cdn,game,lantern,next,product,react,ring-game,scroll,svelte,three,vite,vue}/{,app/}*.{html,js,json,jsx,mjs,svelte,ts,tsx,vue}',
  { eager: true, query: '?raw', import: 'default' },
);

const examples: readonly Example[] = [
  exampleOf('three', 'A three.js scene', 'main.ts', 'Smoke rises through a loaded model and every kind of mesh.'),
  exampleOf(
    'game',
    'A small game',
    'main.ts',
    'Twenty explosions a second, dust at each step, and a jet with a trail. Click on the ground for one more.',
  ),
  exampleOf(
    'ring-game',
    'A game of smoke rings',
    'main.ts',
    'Blow rings through hoops: bursts with looks of their own, and their promises. For pointers, keys and fingers.',
  ),
  exampleOf('lantern', 'Light things', 'main.ts', 'The smoke of a fire lifts a feather and a paper lantern.'),
  exampleOf(
    'react',
    'React Three Fiber',
    'main.tsx',
    'Components for smoke, emitters, colliders and casters. Drag to orbit, click the ring for another colour.',
  ),
  exampleOf('product', 'A product page', 'main.ts', 'Steam beside the text, and a puff from the button.'),
  exampleOf('scroll', 'Smoke by scrolling', 'main.ts', 'A locomotive that puffs as you scroll. Scroll inside it.'),
  exampleOf('vite', 'The element', 'main.ts', 'A custom element that a slider controls, bundled by Vite.'),
  exampleOf('vue', 'Vue', 'App.vue', 'The element in a template, with typed attributes and events.', 'vite'),
  exampleOf('svelte', 'Svelte', 'App.svelte', 'The element in a component, with typed attributes and events.', 'vite'),
  exampleOf('next', 'Next.js', 'app/Smoke.jsx', 'The element in a page that a server renders.', 'vite'),
  exampleOf('cdn', 'Without a build', 'index.html', 'One script from a CDN, and one tag.', 'vite'),
];

function exampleOf(name: string, title: string, main: string, text: string, played = name): Example {
  const start = `${FOLDER}${name}/`;
  const found = Object.entries(sources).filter(([path]) => path.startsWith(start));
  const files = found.map(([path, source]) => [path.slice(start.length), source] as const);
  const order = ([path]: readonly [string, string]) => (path === main ? 0 : 1);
  return { name, title, text, played, files: files.toSorted((one, other) => order(one) - order(other)) };
}

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
let stopClearing: (() => void) | undefined;

async function copyCode(text: string): Promise<void> {
  const isCopied = await copyText(text);
  status.textContent = isCopied ? 'Copied.' : 'The browser does not allow copying. Select the code and copy it.';
  stopClearing?.();
  stopClearing = afterRunning(STATUS_MS, () => (status.textContent = ''));
}

/** An example that plays, beside its code. */
class Card {
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

const contents = document.querySelector('.contents')!;
const container = document.querySelector('#examples')!;
for (const example of examples) {
  const card = new Card(example, isStill, (text) => void copyCode(text));
  cards.set(card.element, card);
  contents.append(create('li', {}, create('a', { href: `#${example.name}` }, example.title)));
  container.append(card.element);
  observer.observe(card.element);
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
