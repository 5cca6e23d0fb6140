import { create } from '../ui/dom.ts';
import { strings } from '../strings.ts';

/** 'look' starts from the beginning where it is opened; 'moment' shows the exact frame. */
export type ShareKind = 'look' | 'moment';

/** Selects what to share. @param choose called with each selection */
export function createShareKind(choose: (what: ShareKind) => void): {
  element: HTMLElement;
  readonly chosen: ShareKind;
} {
  const inputs = (['look', 'moment'] as const).map((what) => {
    const input = create('input', { type: 'radio', name: 'share-what', value: what, checked: what === 'look' });
    input.addEventListener('change', () => choose(what));
    return input;
  });
  const options = inputs.map((input) => createOption(input));
  const legend = create('legend', { class: 'read-aloud' }, strings.share.what);
  return {
    element: create('fieldset', { class: 'share-what' }, legend, ...options),
    get chosen() {
      return inputs[1].checked ? 'moment' : 'look';
    },
  };
}

function createOption(input: HTMLInputElement): HTMLElement {
  const [name, text] = strings.share.kinds[input.value as ShareKind];
  return create('label', {}, input, create('span', {}, create('strong', {}, name), create('small', {}, text)));
}
