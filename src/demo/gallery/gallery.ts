import { findParameter, presets, presetValues, type Preset, type State } from '../../preset.ts';
import { create } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { strings } from '../strings.ts';
import { icon } from '../ui/icons.ts';
import { surprise } from './surprise.ts';

/** Size of a thumbnail in pixels; `npm run thumbnails` creates them. */
const SIZE = { width: 192, height: 128 };

/**
 * The presets as a strip of thumbnails, grouped by scene. They are radio buttons: a single tab stop with arrow-key
 * navigation.
 */
export function createGallery(editor: Editor): HTMLElement {
  const inputs = new Map(presets.map((preset) => [preset.name, createInput(preset)]));
  const scenes = [...byScene()].map(([scene, members]) =>
    createScene(
      scene,
      members.map((preset) => createCard(preset, inputs.get(preset.name)!)),
    ),
  );
  const label = { class: 'gallery card', role: 'radiogroup', 'aria-label': strings.gallery.title };
  const element = create('div', label, createSurprise(editor), ...scenes);
  watchChoices(element, editor);
  let shown: string | undefined;
  const show = ({ preset }: State) => {
    if (preset === shown) return;
    shown = preset;
    for (const [name, input] of inputs) input.checked = name === preset;
    const card = inputs.get(preset)?.parentElement;
    if (card) requestAnimationFrame(() => scrollIntoStrip(card, element));
  };
  editor.listen(show);
  show(editor.state);
  return element;
}

/** Space around the selected card in pixels. */
const MARGIN = 14;

/** Scrolls only the strip, unlike scrollIntoView, which also scrolls the page. */
function scrollIntoStrip(card: HTMLElement, strip: HTMLElement): void {
  const [at, frame] = [card.getBoundingClientRect(), strip.getBoundingClientRect()];
  const way = (from: number, to: number, min: number, max: number) =>
    from < min + MARGIN ? from - min - MARGIN : Math.max(0, to + MARGIN - max);
  strip.scrollBy(way(at.left, at.right, frame.left, frame.right), way(at.top, at.bottom, frame.top, frame.bottom));
}

/** Makes each pointer press one undo step. Presets that are passed with the arrow keys share one step. */
function watchChoices(gallery: HTMLElement, editor: Editor): void {
  let gesture: string | undefined;
  gallery.addEventListener('pointerdown', () => (gesture = undefined));
  gallery.addEventListener('keydown', () => (gesture = 'gallery'));
  gallery.addEventListener('change', ({ target }) => editor.choose((target as HTMLInputElement).value, gesture));
  gallery.addEventListener('focusout', ({ relatedTarget }) => {
    if (!gallery.contains(relatedTarget as Node | null)) editor.settle();
  });
}

function byScene(): ReadonlyMap<string, Preset[]> {
  const scenes = new Map<string, Preset[]>();
  for (const preset of presets) {
    const scene = String(presetValues(preset).scene);
    scenes.set(scene, [...(scenes.get(scene) ?? []), preset]);
  }
  return scenes;
}

function createScene(scene: string, cards: readonly HTMLElement[]): HTMLElement {
  const row = findParameter('scene')!;
  const label = (row.kind === 'choice' && row.options.find(({ value }) => value === scene)?.label) || scene;
  const heading = create('span', { class: 'gallery-scene', 'aria-hidden': 'true' }, label);
  const list = create('div', { class: 'gallery-list' }, ...cards);
  return create('div', { role: 'group', 'aria-label': label }, heading, list);
}

/** A card that shows a random look. */
function createSurprise(editor: Editor): HTMLElement {
  const { card, name, scene } = strings.surprise;
  const button = create(
    'button',
    { type: 'button', class: 'gallery-card is-surprise', 'aria-label': name, title: name },
    icon('dice'),
  );
  button.append(create('span', {}, card));
  button.addEventListener('click', () => surprise(editor));
  const heading = create('span', { class: 'gallery-scene', 'aria-hidden': 'true' }, scene);
  return create('div', {}, heading, create('div', { class: 'gallery-list' }, button));
}

function createInput({ name }: Preset): HTMLInputElement {
  const input = create('input', { type: 'radio', name: 'preset', value: name });
  input.addEventListener('focus', () => input.parentElement!.scrollIntoView({ block: 'nearest', inline: 'nearest' }));
  return input;
}

function createCard({ name, label, text }: Preset, input: HTMLInputElement): HTMLElement {
  const source = `./thumbnails/${name}.webp`;
  const picture = create('img', {
    src: source,
    alt: '',
    ...SIZE,
    loading: 'lazy',
    decoding: 'async',
    draggable: 'false',
  });
  return create('label', { class: 'gallery-card', title: text }, input, picture, create('span', {}, label));
}
