/** Embed code for other pages. */

/** Size in CSS pixels. */
export const FRAME = { width: 640, height: 360 };

/** What the code for other pages shows, and how. */
export interface EmbedOptions {
  /** CSS pixels; undefined for the width of the container. */
  readonly width: number | undefined;
  /** Width and height of the aspect ratio. */
  readonly ratio: readonly [number, number];
  readonly isTransparent: boolean;
  readonly isInteractive: boolean;
  /** Description for screen readers; empty for decoration. */
  readonly alt: string;
  /** Whether there is a picture until the first frame. */
  readonly hasPoster: boolean;
}

/** File name of the poster in the code. */
export const POSTER = 'smoke.png';

/** Iframe code for a share link, without the page's controls. @param title for screen readers if there is no description */
export function frameCode(link: string, options: EmbedOptions, title: string): string {
  const address = new URL(link);
  address.pathname = address.pathname.replace(/[^/]*$/, 'embed.html');
  address.searchParams.delete('ui');
  if (!options.isInteractive) address.searchParams.set('interactive', '0');
  if (options.isTransparent) address.searchParams.set('transparent', '1');
  const { width, ratio } = options;
  const name = options.alt || title;
  if (width !== undefined) return frameOf(address.href, name, { width, height: heightOf(width, ratio) });
  return frameOf(address.href, name, { width: '100%' }, `; aspect-ratio: ${ratio.join(' / ')}`);
}

/** @param address of embed.html with its query and hash */
export function frameOf(
  address: string,
  title: string,
  size: Readonly<Record<string, string | number>> = FRAME,
  style = '',
): string {
  const sides = Object.entries(size).map(([side, length]) => ` ${side}="${length}"`);
  const attributes = `src="${quoted(address)}" title="${quoted(title)}"${sides.join('')}`;
  return `<iframe ${attributes} loading="lazy" referrerpolicy="no-referrer" style="border: 0${style}"></iframe>`;
}

/** The script that defines `<cartoon-smoke>`. */
export interface ElementScript {
  /** Absolute URL. */
  readonly address: string;
  /** Subresource integrity hash. */
  readonly integrity: string;
}

/** Element code, with the script unless the page uses the package. */
export function elementCode(link: string, options: EmbedOptions, script?: ElementScript): string {
  const flags = `${options.isTransparent ? ' transparent' : ''}${options.isInteractive ? ' interactive' : ''}`;
  const attributes = `src="${quoted(link)}" alt="${quoted(options.alt)}"${flags} style="${styleOf(options)}"`;
  const poster = options.hasPoster ? `\n  <img slot="poster" src="${POSTER}" alt="" />\n` : '';
  const element = `<cartoon-smoke ${attributes}>${poster}</cartoon-smoke>`;
  if (!script) return element;
  const { address, integrity } = script;
  const from = `src="${quoted(address)}" integrity="${quoted(integrity)}" crossorigin="anonymous"`;
  return `<script type="module" ${from}></script>\n${element}`;
}

/** CSS of a box of this size, at most as wide as its container. */
export function styleOf({ width, ratio }: EmbedOptions): string {
  const sides = width === undefined ? 'width: 100%' : `width: ${width}px; max-width: 100%`;
  return `${sides}; aspect-ratio: ${ratio.join(' / ')}`;
}

export function heightOf(width: number, [across, up]: EmbedOptions['ratio']): number {
  return Math.round((width * up) / across);
}

/** Escapes text for an attribute value. */
function quoted(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
