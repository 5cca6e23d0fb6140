import type { State } from '../preset/codec.ts';
import { presets, presetValues, type Preset } from '../preset/presets.ts';
import { create, createSvg } from './dom.ts';
import type { Editor } from './editor.ts';
import { strings } from './strings.ts';

/** The presets as a group of radio buttons, each with a puff in its own colours. */
export function createChooser(editor: Editor): { element: HTMLElement; show(state: State): void } {
  const inputs = presets.map((preset) => createInput(preset, editor));
  const options = presets.map((preset, index) => createOption(preset, inputs[index]));
  const legend = create('legend', {}, strings.panel.presets);
  return {
    element: create('fieldset', { class: 'chooser' }, legend, ...options),
    show: ({ preset }) => inputs.forEach((input) => (input.checked = input.value === preset)),
  };
}

function createInput({ name }: Preset, editor: Editor): HTMLInputElement {
  const input = create('input', { type: 'radio', name: 'preset', value: name });
  input.addEventListener('change', () => editor.choose(name));
  return input;
}

function createOption(preset: Preset, input: HTMLInputElement): HTMLElement {
  return create('label', { class: 'preset', 'data-text': preset.text }, input, drawPuff(preset), preset.label);
}

/** A small puff as the preset draws it: its smoke, its shade, its ink. */
function drawPuff(preset: Preset): SVGSVGElement {
  const values = presetValues(preset);
  const puff = createSvg('svg', { viewBox: '0 0 32 24', class: 'puff', 'aria-hidden': 'true' });
  const outline = 'M6 20a5 5 0 0 1-1-9.5 5.5 5.5 0 0 1 7-5.5 6.5 6.5 0 0 1 11.5 2 5 5 0 0 1 4 8.5A4 4 0 0 1 25 20z';
  const shade = 'M6 20a5 5 0 0 1-4-5c6 3 17 3 25.5-3a4.5 4.5 0 0 1-2.5 8z';
  const inkWidth = values['style.outlines'] === 1 ? Number(values['style.outlineWidth']) * 0.6 : 0;
  puff.append(
    createSvg('path', { d: outline, fill: String(values['style.smokeColor']) }),
    ...(values['style.tones'] === 1 ? [] : [createSvg('path', { d: shade, fill: '#3b2a6e', 'fill-opacity': '0.35' })]),
    createSvg('path', {
      d: outline,
      fill: 'none',
      stroke: String(values['style.inkColor']),
      'stroke-width': String(inkWidth),
    }),
  );
  return puff;
}
