/** Importing this makes `<cartoon-smoke>` an element of the page. Of several versions on one page the first counts. */
import { CartoonSmokeElement } from './cartoonSmokeElement.ts';

declare global {
  interface HTMLElementTagNameMap {
    'cartoon-smoke': CartoonSmokeElement;
  }
}

const NAME = 'cartoon-smoke';

if (globalThis.customElements && !customElements.get(NAME)) customElements.define(NAME, CartoonSmokeElement);

export { CartoonSmokeElement };
