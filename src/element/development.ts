/**
 * The element for development builds, which bundlers choose by the export condition `development`: it writes unknown
 * attributes, corrected values and failures to the console, once each. In production the element writes nothing.
 */
import { CartoonSmokeElement } from './define.ts';
import type { SmokeEvents } from './events.ts';

/** Attributes of all HTML elements, and prefixes that frameworks and ARIA use. */
const GLOBAL =
  /^(accesskey|autocapitalize|autofocus|class|contenteditable|dir|draggable|enterkeyhint|exportparts|hidden|id|inert|inputmode|is|item(id|prop|ref|scope|type)|lang|nonce|part|popover|role|slot|spellcheck|style|tabindex|title|translate|writingsuggestions)$|^(aria|data|v|ng|on)-|^on[a-z]+$|[^a-z0-9-]|^_/;
const TAG = '<cartoon-smoke>';

const warned = new Set<string>();

function warn(message: string): void {
  if (warned.has(message)) return;
  warned.add(message);
  // oxlint-disable-next-line eslint/no-console -- only in development builds
  console.warn(`${TAG}: ${message}`);
}

function warnOfAttributes(element: CartoonSmokeElement): void {
  const known = CartoonSmokeElement.observedAttributes;
  for (const name of element.getAttributeNames()) {
    if (!known.includes(name) && !GLOBAL.test(name)) {
      warn(`There is no attribute \u201c${name}\u201d. Did you mean \u201c${nearest(name, known)}\u201d?`);
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
function listen<Name extends keyof SmokeEvents>(name: Name, act: (detail: SmokeEvents[Name]) => void): void {
  const heard = (event: Event) => {
    if (!(event.target instanceof CartoonSmokeElement)) return;
    warnOfAttributes(event.target);
    act((event as CustomEvent<SmokeEvents[Name]>).detail);
  };
  // None on a server.
  globalThis.document?.addEventListener(name, heard, { capture: true });
}

listen('ready', () => undefined);
listen('statechange', ({ notices }) => {
  for (const { message } of notices) warn(message);
});
listen('error', ({ error }) => warn(`${error.name}: ${error.message}`));

export { CartoonSmokeElement };
