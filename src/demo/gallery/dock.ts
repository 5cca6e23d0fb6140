import type { Stage } from '../../index.ts';
import { create, iconButton } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { LOW } from '../mediaQueries.ts';
import { icon } from '../ui/icons.ts';
import type { Scrubber } from '../playback/scrubber.ts';
import { strings } from '../strings.ts';
import { createTransport } from '../playback/transport.ts';
import { findParameter, presets, presetValues, type Preset, type State, type Value } from '../../preset.ts';

/** The bar below the smoke: the transport and the collapsible gallery. */
export interface Dock {
  readonly element: HTMLElement;
  toggleGallery(): void;
  closeGallery(): void;
}

/**
 * @param opener button below the scrubber
 * @param play buttons for interactions with the smoke
 * @param onGallery called before the gallery opens
 */
export function createDock(
  editor: Editor,
  stage: Stage,
  scrubber: Scrubber,
  opener: HTMLElement,
  play: readonly HTMLElement[],
  onGallery: () => void,
): Dock {
  const gallery = createGallery(editor);
  const toggle = iconButton('icon-button', strings.gallery.toggle, icon('pictures'), () => dock.toggleGallery());
  const show = (isOpen: boolean) => {
    if (isOpen) onGallery();
    gallery.hidden = !isOpen;
    toggle.setAttribute('aria-expanded', String(isOpen));
  };
  const element = create('div', { class: 'dock' }, createTransport(stage, scrubber, opener, ...play, toggle), gallery);
  const dock = { element, toggleGallery: () => show(gallery.hidden !== false), closeGallery: () => show(false) };
  const low = matchMedia(LOW);
  let comesBack = false;
  low.addEventListener('change', () => {
    // After a quick rotation there and back, the change event arrives late, when the window has its first size again.
    comesBack ||= !gallery.hidden;
    show(!low.matches && comesBack);
    if (!low.matches) comesBack = false;
  });
  show(!low.matches);
  return dock;
}

/** Size of a thumbnail in pixels; `npm run thumbnails` creates them. */
const SIZE = { width: 192, height: 128 };

/**
 * The presets as a strip of thumbnails, grouped by scene. They are radio buttons: a single tab stop with arrow-key
 * navigation.
 */
function createGallery(editor: Editor): HTMLElement {
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

/**
 * A random look: the scene and the motion of one preset in the style of another.
 *
 * @param current name of the preset that is shown; the scene is that of another one
 * @param random returns a number from 0 to below 1
 */
function mixedState(current: string, random: () => number = Math.random): State {
  const pick = (from: typeof presets) => from[Math.floor(random() * from.length)];
  const base = pick(presets.filter(({ name }) => name !== current));
  const model = pick(presets.filter(({ name }) => name !== base.name));
  const values: Record<string, Value> = { ...presetValues(base) };
  for (const key of Object.keys(values)) if (isStyle(key)) delete values[key];
  const style = Object.entries(presetValues(model)).filter(([key]) => isStyle(key));
  return { preset: base.name, values: { ...values, ...Object.fromEntries(style) } };
}

/** Shows a mixed look. Can be undone. */
export function surprise(editor: Editor): void {
  editor.load(mixedState(editor.state.preset));
}

function isStyle(key: string): boolean {
  return key.startsWith('style.');
}
