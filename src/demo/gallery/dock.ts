import type { Stage } from '../../index.ts';
import { create, iconButton } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { createGallery } from './gallery.ts';
import { LOW } from '../mediaQueries.ts';
import { icon } from '../ui/icons.ts';
import type { Scrubber } from '../playback/scrubber.ts';
import { strings } from '../strings.ts';
import { createTransport } from '../playback/transport.ts';

/** The bar below the smoke: the transport and the collapsible gallery. */
export interface Dock {
  readonly element: HTMLElement;
  toggleGallery(): void;
  closeGallery(): void;
}

/** @param play buttons for interactions with the smoke */
export function createDock(editor: Editor, stage: Stage, scrubber: Scrubber, ...play: HTMLElement[]): Dock {
  const gallery = createGallery(editor);
  const toggle = iconButton('icon-button', strings.gallery.toggle, icon('pictures'), () => dock.toggleGallery());
  const show = (isOpen: boolean) => {
    gallery.hidden = !isOpen;
    toggle.setAttribute('aria-expanded', String(isOpen));
  };
  const element = create('div', { class: 'dock' }, createTransport(stage, scrubber, ...play, toggle), gallery);
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
