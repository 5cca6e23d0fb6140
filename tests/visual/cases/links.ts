/** Share links, opened as an element opens them. */
import { readLink } from '../../../src/element/attributes/link.ts';
import { goToMoment } from '../../../src/element/moment.ts';
import type { Notice } from '../../../src/preset/notice.ts';
import { openHere } from '../../../src/remote/openHere.ts';

/** CSS pixels. Pictures have half as many each way, because less would show too little of the open air. */
const [WIDTH, HEIGHT] = [320, 180];

export interface OpenedLink {
  hash: string;
  notices: Notice[];
  picture: Blob;
}

/** @param link what comes behind the page's address: the query and the hash */
export async function openLink(link: string): Promise<OpenedLink> {
  const notices: Notice[] = [];
  const { values, start, take } = await readLink(link, 'https://cartoon-smoke.example/', notices);
  const size = { width: WIDTH, height: HEIGHT, pixelRatio: 0.5 };
  // Only the picture that is compared is drawn.
  const stage = await openHere(new OffscreenCanvas(WIDTH, HEIGHT), { values, ...size, visible: false });
  try {
    if (take) notices.push(...(await goToMoment(stage, take, start, values)));
    else await stage.seek(start ?? 0);
    return { hash: await stage.hash(), notices, picture: await stage.picture() };
  } finally {
    await stage.dispose();
  }
}
