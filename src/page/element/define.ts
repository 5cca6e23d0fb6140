/** Importing this module defines `<cartoon-smoke>`. With several versions on one page, the first one wins. */
import { CartoonSmokeElement } from './cartoonSmokeElement.ts';
import type { StateChange } from './events.ts';

declare global {
  interface HTMLElementTagNameMap {
    'cartoon-smoke': CartoonSmokeElement;
  }
}

const NAME = 'cartoon-smoke';

if (globalThis.customElements) {
  const first = customElements.get(NAME);
  if (!first) customElements.define(NAME, CartoonSmokeElement);
  else if (first !== CartoonSmokeElement) warnOfSecond(first);
}

/** Notifies listeners that a second version was loaded. Existing elements keep the class of the first version. */
function warnOfSecond(first: CustomElementConstructor): void {
  const given = CartoonSmokeElement.version;
  const used = (first as Partial<typeof CartoonSmokeElement>).version ?? 'another one';
  const message = `cartoon-smoke ${used} is already in use; version ${given} is ignored.`;
  for (const element of document.querySelectorAll(NAME)) {
    const detail: StateChange = {
      playing: element.playing,
      notices: [{ code: 'otherVersion', key: 'version', given, message }],
    };
    element.dispatchEvent(new CustomEvent('statechange', { detail }));
  }
}

export { CartoonSmokeElement };
