/** Code for pages of other people that shall show this smoke. */

/** CSS pixels. */
export const FRAME = { width: 640, height: 360 };

/** A frame around what a share link shows, without the page. @param title for screen readers */
export function frameCode(link: string, title: string): string {
  const address = new URL(link);
  address.pathname = address.pathname.replace(/[^/]*$/, 'embed.html');
  address.searchParams.delete('ui');
  return frameOf(address.href, title);
}

/** @param address of embed.html with its query and hash */
export function frameOf(address: string, title: string): string {
  const attributes = `src="${quoted(address)}" title="${quoted(title)}" width="${FRAME.width}" height="${FRAME.height}"`;
  return `<iframe ${attributes} loading="lazy" referrerpolicy="no-referrer" style="border: 0"></iframe>`;
}

/** The script that makes `<cartoon-smoke>` an element. */
export interface ElementScript {
  /** Whole address. */
  readonly address: string;
  /** Hash of its content: a browser runs nothing else. */
  readonly integrity: string;
}

/** The element, with the script that it needs unless the page has the package. */
export function elementCode(link: string, script?: ElementScript): string {
  const element = `<cartoon-smoke src="${quoted(link)}"></cartoon-smoke>`;
  if (!script) return element;
  const { address, integrity } = script;
  const attributes = `src="${quoted(address)}" integrity="${quoted(integrity)}" crossorigin="anonymous"`;
  return `<script type="module" ${attributes}></script>\n${element}`;
}

/** As it must stand in an attribute. */
function quoted(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
