/** Code for pages of other people that shall show this smoke. */

const [WIDTH, HEIGHT] = [640, 360];

/** A frame without controls around a share link. @param title for screen readers */
export function frameCode(link: string, title: string): string {
  const address = new URL(link);
  address.searchParams.set('ui', '0');
  const attributes = `src="${quoted(address.href)}" title="${quoted(title)}" width="${WIDTH}" height="${HEIGHT}"`;
  return `<iframe ${attributes} loading="lazy" style="border: 0"></iframe>`;
}

/** The element of the package, for pages that have it. */
export function elementCode(link: string): string {
  return `<cartoon-smoke src="${quoted(link)}"></cartoon-smoke>`;
}

/** As it must stand in an attribute. */
function quoted(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
