/** Warnings about attributes of the element and about failures. Importing this module starts them. */
import { warnOfError, warnOnce, warnUnawaited } from '../../base/warn.ts';
import { STAGE_MEMBERS } from '../../stage/remote/warnings.ts';
import { CartoonSmokeElement } from './define.ts';
import type { SmokeEvents } from './events.ts';

/** Attributes of all HTML elements, and prefixes that frameworks and ARIA use. */
const GLOBAL =
  /^(accesskey|autocapitalize|autofocus|class|contenteditable|dir|draggable|enterkeyhint|exportparts|hidden|id|inert|inputmode|is|item(id|prop|ref|scope|type)|lang|nonce|part|popover|role|slot|spellcheck|style|tabindex|title|translate|writingsuggestions)$|^(aria|data|v|ng|on)-|^on[a-z]+$|[^a-z0-9-]|^_/;
const ABOUT = '<cartoon-smoke>';
/** Time in which a page adds the elements that a selector names, milliseconds. */
const SELECTOR_DELAY_MS = 2000;

function warnOfAttributes(element: CartoonSmokeElement): void {
  const known = CartoonSmokeElement.observedAttributes;
  for (const name of element.getAttributeNames()) {
    if (!known.includes(name) && !GLOBAL.test(name)) {
      warnOnce(ABOUT, `There is no attribute \u201c${name}\u201d. Did you mean \u201c${nearest(name, known)}\u201d?`);
    }
  }
}

/** @returns the name with the smallest edit distance (Levenshtein) */
function nearest(name: string, names: readonly string[]): string {
  const distances = names.map((each) => distance(name, each));
  return names[distances.indexOf(Math.min(...distances))];
}

function distance(a: string, b: string): number {
  let above = Array.from({ length: b.length + 1 }, (_, column) => column);
  for (let row = 1; row <= a.length; ++row) {
    const line = [row];
    for (let column = 1; column <= b.length; ++column) {
      const replaced = above[column - 1] + (a[row - 1] === b[column - 1] ? 0 : 1);
      line.push(Math.min(replaced, above[column] + 1, line[column - 1] + 1));
    }
    above = line;
  }
  return above[b.length];
}

/** Calls a listener for the events of all elements. The capture phase also reaches events that do not bubble. */
function listen<Name extends keyof SmokeEvents>(
  name: Name,
  act: (detail: SmokeEvents[Name], element: CartoonSmokeElement) => void,
): void {
  const heard = (event: Event) => {
    if (!(event.target instanceof CartoonSmokeElement)) return;
    warnOfAttributes(event.target);
    act((event as CustomEvent<SmokeEvents[Name]>).detail, event.target);
  };
  // None on a server.
  globalThis.document?.addEventListener(name, heard, { capture: true });
}

function warnOfSelectors(element: CartoonSmokeElement): void {
  if (!element.isConnected) return;
  for (const name of ['collide', 'emit-from']) {
    const selector = element.getAttribute(name);
    try {
      if (!selector || (element.getRootNode() as ParentNode).querySelector(selector)) continue;
      warnOnce(ABOUT, `${name}=\u201c${selector}\u201d matches no element.`);
    } catch {
      // A notice says that the selector is invalid.
    }
  }
}

listen('ready', (_, element) => void setTimeout(() => warnOfSelectors(element), SELECTOR_DELAY_MS));
listen('statechange', ({ notices }) => {
  for (const { message } of notices) warnOnce(ABOUT, message);
});
listen('error', ({ error }) => warnOfError(ABOUT, error));

const stage = Object.getOwnPropertyDescriptor(CartoonSmokeElement.prototype, 'stage')!;
Object.defineProperty(CartoonSmokeElement.prototype, 'stage', {
  configurable: true,
  get(this: CartoonSmokeElement) {
    return warnUnawaited('element.stage', stage.get!.call(this) as CartoonSmokeElement['stage'], STAGE_MEMBERS);
  },
});
