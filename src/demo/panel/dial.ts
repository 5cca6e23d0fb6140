import type { NumberParameter, Values } from '../../preset.ts';
import type { Editor } from '../editor/editor.ts';
import { strings } from '../strings.ts';
import { create, uniqueId } from '../ui/dom.ts';
import { ARROWS } from './control.ts';
import { daylight, dayOf, DAYLIGHT_KEYS, OWN_HOUR, type Daylight } from './daylight.ts';
import { frameRow, type Row } from './row.ts';

const QUARTERS = 96;

/** What the panel says of the dial. It is no parameter of links: it sets others, and shows the hour that they have. */
export const hourParameter: NumberParameter = {
  key: 'light.hour',
  kind: 'number',
  group: 'light',
  reader: 'light',
  ...strings.dial.words,
  min: 0,
  max: (QUARTERS - 1) / 4,
  default: OWN_HOUR,
  step: 0.25,
  slider: 'even',
  unit: '',
};

/**
 * The dial of the hour, a row of the panel. An arrow key moves it by a quarter of an hour, with Shift by an hour, also past
 * midnight.
 * @param scene its rig has the scene's backdrop
 */
export function createDial(editor: Editor, scene: { readonly rig: Values }): Row {
  const [id, textId] = [uniqueId(), uniqueId()];
  const { min, max, step } = hourParameter;
  const range = create('input', { id, type: 'range', min, max, step, 'aria-describedby': textId });
  const shown = create('span', { class: 'hour', 'aria-hidden': 'true' });
  const quartersNow = dayOfState(editor, scene);
  /** -1 while the values are those of no hour. */
  let quarter = -1;
  const show = () => {
    const { values } = editor.state;
    const has = (light?: Daylight) => DAYLIGHT_KEYS.every((key) => light?.[key] === values[key]);
    const quarters = quartersNow();
    // Neighbouring hours may have the same values.
    if (!has(quarters[quarter])) quarter = quarters.findIndex(has);
    const hour = quarter < 0 ? undefined : quarter / 4;
    range.value = String(hour ?? OWN_HOUR);
    range.classList.toggle('is-unset', hour === undefined);
    shown.textContent = strings.dial.hour(hour, OWN_HOUR);
    range.setAttribute('aria-valuetext', shown.textContent);
  };
  const go = (to: number) => {
    quarter = to;
    editor.changeAll(quartersNow()[quarter], hourParameter.key);
    show();
  };
  range.addEventListener('input', () => go(4 * range.valueAsNumber));
  range.addEventListener('change', () => editor.settle());
  range.addEventListener('keydown', (event) => {
    const steps = ARROWS[event.key];
    if (steps === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const from = quarter < 0 ? 4 * OWN_HOUR : quarter;
    go((from + QUARTERS + (event.shiftKey ? 4 * steps : steps)) % QUARTERS);
  });
  range.addEventListener('keyup', () => editor.settle());
  const reset = () => editor.changeAll(Object.fromEntries(DAYLIGHT_KEYS.map((key) => [key, editor.base[key]])));
  const row = frameRow(hourParameter, textId, { elements: [shown, range], id, show }, reset);
  const textOf = (values: Values) => JSON.stringify(DAYLIGHT_KEYS.map((key) => values[key]));
  return { element: row.element, show: () => row.show(textOf(editor.state.values), textOf(editor.base)) };
}

/** Returns the values of all quarters of an hour, computed once for a preset, a scene and a glow. */
function dayOfState(editor: Editor, scene: { readonly rig: Values }): () => readonly Daylight[] {
  let [known, quarters]: [string, readonly Daylight[]] = ['', []];
  return () => {
    const { preset, values } = editor.state;
    const backdrop = scene.rig['style.backdrop'] ?? '';
    const glow = values['emission.glow'];
    if (known !== `${preset} ${backdrop} ${glow}`) {
      known = `${preset} ${backdrop} ${glow}`;
      const day = { ...dayOf(preset), 'emission.glow': glow };
      quarters = Array.from({ length: QUARTERS }, (_, quarter) => daylight(quarter / 4, day, backdrop));
    }
    return quarters;
  };
}
