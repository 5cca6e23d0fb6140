/** The first picture of an element with a share link. */
import { CartoonSmokeElement } from '../../../../src/element.ts';

export interface PosterOrder {
  link: string;
  /** CSS pixels. */
  width: number;
  height: number;
  isTransparent: boolean;
}

/** @returns the PNG in base64, and the link's notices */
export async function poster({ link, width, height, isTransparent }: PosterOrder) {
  const element = new CartoonSmokeElement();
  Object.assign(element, { src: link, paused: true, transparent: isTransparent, loading: 'eager', thread: 'main' });
  Object.assign(element.style, { display: 'block', width: `${width}px`, height: `${height}px` });
  const notices: string[] = [];
  element.addEventListener('statechange', ({ detail }) =>
    notices.push(...detail.notices.map(({ message }) => message)),
  );
  document.body.append(element);
  try {
    const bytes = new Uint8Array(await (await element.picture()).arrayBuffer());
    return { png: btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')), notices };
  } finally {
    element.remove();
  }
}

/** Shows an element with a link at its first picture, without its button. */
export async function showFirst(link: string, width: number, height: number): Promise<void> {
  const element = new CartoonSmokeElement();
  Object.assign(element, { src: link, paused: true, loading: 'eager', thread: 'main' });
  Object.assign(element.style, { display: 'block', width: `${width}px`, height: `${height}px` });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync('cartoon-smoke::part(button) { display: none }');
  document.adoptedStyleSheets = [sheet];
  document.body.replaceChildren(element);
  await element.ready;
}
