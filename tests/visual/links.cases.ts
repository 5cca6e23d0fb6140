/** Share links, opened as an element opens them. */
import { readLink } from '../../src/page/element/attributes/link.ts';
import { goToMoment } from '../../src/page/element/moment.ts';
import type { Notice } from '../../src/parameters/notice.ts';
import { openHere } from '../../src/stage/remote/openHere.ts';

/**
 * CSS pixels. The picture has half as many pixels in each direction, because a smaller page would crop the open-air
 * scene.
 */
const [WIDTH, HEIGHT] = [320, 180];

export interface OpenedLink {
  hash: string;
  notices: Notice[];
  picture: Blob;
}

/** @param link query and hash of the page's address */
export async function openLink(link: string): Promise<OpenedLink> {
  const notices: Notice[] = [];
  const { values, start, take } = await readLink(link, 'https://cartoon-smoke.example/', notices);
  const size = { width: WIDTH, height: HEIGHT, pixelRatio: 0.5 };
  // Draw only the picture for the comparison.
  const stage = await openHere(new OffscreenCanvas(WIDTH, HEIGHT), { values, ...size, visible: false });
  try {
    if (take) notices.push(...(await goToMoment(stage, take, start, values)));
    else await stage.seek(start ?? 0);
    return { hash: await stage.hash(), notices, picture: await stage.picture() };
  } finally {
    await stage.dispose();
  }
}
