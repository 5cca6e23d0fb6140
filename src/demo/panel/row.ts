import { showsBillboards } from '../../internal.ts';
import type { Parameter, Value } from '../../preset.ts';
import { createControl } from './control.ts';
import type { Control } from './controlTypes.ts';
import { create, iconButton, uniqueId } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { icon } from '../ui/icons.ts';
import { strings } from '../strings.ts';

/** A parameter in the panel: its label, its inputs and a reset button. */
export interface Row {
  readonly element: HTMLElement;
  /** @param base value that the reset button restores */
  show(value: Value, base: Value): void;
}

export function createRow(parameter: Parameter, editor: Editor): Row {
  const textId = uniqueId();
  const control = createControl(
    parameter,
    textId,
    connect(parameter, editor, (value) => control.show(value)),
    () => editor.state.values,
  );
  return frameRow(parameter, textId, control, () => editor.reset(parameter.key));
}

/** The row around a control. @param textId id of the element with the description, which it creates */
export function frameRow(parameter: Parameter, textId: string, control: Control, restore: () => void): Row {
  const { key, label, text, kind } = parameter;
  const reset = iconButton('reset', strings.panel.reset(label), icon('reset'), restore);
  const name = create('label', { for: control.id }, label, ...unitOf(parameter));
  const hidden = create('span', { id: textId, class: 'read-aloud' }, text);
  const attributes = { class: `row row-${kind}`, 'data-key': key, 'data-text': text };
  const element = create('div', attributes, name, reset, ...control.elements, hidden);
  let wasIdle: boolean | undefined;
  return {
    element,
    show(value, base) {
      control.show(value);
      const isIdle = value === base;
      if (isIdle === wasIdle) return;
      wasIdle = isIdle;
      // The button is hidden instead of disabled: many disabled buttons would make it hard to see what has changed.
      reset.classList.toggle('is-idle', isIdle);
      reset.tabIndex = isIdle ? -1 : 0;
      reset.setAttribute('aria-hidden', String(isIdle));
    },
  };
}

function unitOf(parameter: Parameter): HTMLElement[] {
  const hasUnit = (parameter.kind === 'number' || parameter.kind === 'integer') && parameter.unit !== '';
  return hasUnit ? [create('span', { class: 'unit' }, parameter.unit)] : [];
}

/**
 * Parameters that create a new simulator, bake billboards or change how smoke of an emitter moves are applied at the end of a
 * gesture; all others at once. Puffs keep the look that they are born with, and there are at most 15 looks at a time.
 */
function connect({ key, reader, isBaked }: Parameter, editor: Editor, preview: (value: Value) => void) {
  let waiting: Value | undefined;
  return {
    change(value: Value): void {
      const isOfLook = reader === 'simulator' && key.includes('.look.');
      const isSlow = reader === 'stage' || isOfLook || (isBaked && showsBillboards(editor.state.values));
      if (!isSlow) return editor.change(key, value, key);
      waiting = value;
      preview(value);
    },
    settle(): void {
      if (waiting !== undefined) editor.change(key, waiting);
      waiting = undefined;
      editor.settle();
    },
  };
}
