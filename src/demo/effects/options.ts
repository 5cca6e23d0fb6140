/** The form with the options of a call. */
import type { PuffOptions } from '../../puff.ts';
import { presets, type PresetName } from '../../preset.ts';
import { create, textButton, uniqueId } from '../ui/dom.ts';

interface Slider {
  readonly name: 'count' | 'size' | 'speed' | 'spread' | 'direction' | 'duration';
  readonly label: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** Where the slider is until it is used. The effect decides then. */
  readonly start: number;
}

const SLIDERS: readonly Slider[] = [
  { name: 'count', label: 'Count', unit: '', min: 1, max: 120, step: 1, start: 24 },
  { name: 'size', label: 'Size', unit: '×', min: 0.25, max: 4, step: 0.05, start: 1 },
  { name: 'speed', label: 'Speed', unit: '×', min: 0, max: 4, step: 0.05, start: 1 },
  { name: 'spread', label: 'Spread', unit: '°', min: 0, max: 360, step: 5, start: 90 },
  { name: 'direction', label: 'Direction', unit: '°', min: -180, max: 180, step: 5, start: 90 },
  { name: 'duration', label: 'Duration', unit: ' s', min: 0, max: 10, step: 0.1, start: 1 },
];

/** Maximum length of the text of 'form'. */
const MAX_LETTERS = 40;

/** Options of a call, apart from the effect. */
export type FormOptions = Omit<PuffOptions, 'effect'>;

/**
 * Creates the form. Options appear in the result once they are set.
 * @param notify called with the options after each change
 */
export function createForm(notify: (options: FormOptions) => void): HTMLElement {
  let options: FormOptions = {};
  const resets: (() => void)[] = [];
  const change = (next: FormOptions) => {
    options = { ...options, ...next };
    notify(options);
  };
  const rows = [
    ...SLIDERS.map((slider) => sliderRow(slider, change, resets)),
    colorRow(change, resets),
    choiceRow(
      'Look',
      [['', 'Open air'], ...looks()],
      (preset) => change({ preset: (preset as PresetName) || undefined }),
      resets,
    ),
    choiceRow(
      'Layer',
      [
        ['', 'Above the page'],
        ['below', 'Below the page'],
      ],
      (layer) => change({ layer: layer === 'below' ? 'below' : undefined }),
      resets,
    ),
    textRow(change, resets),
  ];
  const reset = textButton('quiet', 'Reset', () => {
    for (const act of resets) act();
    options = {};
    notify(options);
  });
  const form = create('form', { class: 'puff-options', 'aria-label': 'Options' }, ...rows, reset);
  // The key Enter in the text would load the page again.
  form.addEventListener('submit', (event) => event.preventDefault());
  return form;
}

function looks(): [string, string][] {
  return presets.filter(({ name }) => name !== 'air').map(({ name, label }) => [name, label]);
}

function sliderRow(
  { name, label, unit, start, ...range }: Slider,
  change: (options: FormOptions) => void,
  resets: (() => void)[],
): HTMLElement {
  const id = uniqueId();
  const input = create('input', { type: 'range', id, ...range, value: start });
  const shown = create('output', { for: id }, 'auto');
  const fill = () =>
    input.style.setProperty('--filled', String((input.valueAsNumber - range.min) / (range.max - range.min)));
  fill();
  input.addEventListener('input', () => {
    fill();
    shown.textContent = `${input.valueAsNumber}${unit}`;
    change({ [name]: input.valueAsNumber });
  });
  resets.push(() => {
    input.valueAsNumber = start;
    fill();
    shown.textContent = 'auto';
  });
  return create('div', { class: 'row' }, create('label', { for: id }, label), input, shown);
}

function colorRow(change: (options: FormOptions) => void, resets: (() => void)[]): HTMLElement {
  const id = uniqueId();
  const usual = '#fffaf0';
  const input = create('input', { type: 'color', id, value: usual });
  input.addEventListener('input', () => change({ color: input.value }));
  resets.push(() => (input.value = usual));
  return create('div', { class: 'row' }, create('label', { for: id }, 'Colour'), input);
}

function textRow(change: (options: FormOptions) => void, resets: (() => void)[]): HTMLElement {
  const id = uniqueId();
  const input = create('input', { type: 'text', id, maxlength: MAX_LETTERS, placeholder: 'Only for form' });
  input.addEventListener('input', () => change({ text: input.value.trim() || undefined }));
  resets.push(() => (input.value = ''));
  return create('div', { class: 'row' }, create('label', { for: id }, 'Text'), input);
}

function choiceRow(
  label: string,
  choices: readonly (readonly [value: string, text: string])[],
  choose: (value: string) => void,
  resets: (() => void)[],
): HTMLElement {
  const id = uniqueId();
  const input = create('select', { id }, ...choices.map(([value, text]) => create('option', { value }, text)));
  input.addEventListener('change', () => choose(input.value));
  resets.push(() => (input.selectedIndex = 0));
  return create('div', { class: 'row' }, create('label', { for: id }, label), input);
}
