/** Embed code for other pages. */

/** Size in CSS pixels. */
export const FRAME = { width: 640, height: 360 };

/** Iframe code for a share link, without the page's controls. @param title for screen readers */
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

/** The script that defines `<cartoon-smoke>`. */
export interface ElementScript {
  /** Absolute URL. */
  readonly address: string;
  /** Subresource integrity hash. */
  readonly integrity: string;
}

/** Element code, with the script unless the page uses the package. */
export function elementCode(link: string, script?: ElementScript): string {
  const element = `<cartoon-smoke src="${quoted(link)}"></cartoon-smoke>`;
  if (!script) return element;
  const { address, integrity } = script;
  const attributes = `src="${quoted(address)}" integrity="${quoted(integrity)}" crossorigin="anonymous"`;
  return `<script type="module" ${attributes}></script>\n${element}`;
}

/** Escapes text for an attribute value. */
function quoted(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
