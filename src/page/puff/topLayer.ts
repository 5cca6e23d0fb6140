/** The top layer: modal dialogs, popovers and what is on full screen, in front of every `z-index`. */
import { parentOf } from '../zoom.ts';
import type { Source } from './target.ts';

const SELECTORS = [':modal', ':popover-open', ':fullscreen', 'select:open'];

/** The element of the top layer that a source is in, if any. A point counts as what is under it. */
export function topLayerOf(source: Source): Element | undefined {
  const { left, top } = source.box() ?? { left: -1, top: -1 };
  for (let each = source.inside ?? elementAt(left, top); each; each = parentOf(each)) {
    // All of the page is in front of nothing else, and a frame has a top layer of its own.
    const part = each;
    if (part.ownerDocument !== document || part === document.documentElement) continue;
    if (SELECTORS.some((selector) => isMatch(part, selector))) return part;
  }
  return undefined;
}

function elementAt(x: number, y: number): Element | undefined {
  let found = document.elementFromPoint(x, y) ?? undefined;
  for (let outer; found?.shadowRoot && found !== outer;) {
    outer = found;
    found = found.shadowRoot.elementFromPoint(x, y) ?? found;
  }
  return found;
}

/** Older browsers throw for selectors that they do not know. */
function isMatch(element: Element, selector: string): boolean {
  try {
    return element.matches(selector);
  } catch {
    return false;
  }
}
