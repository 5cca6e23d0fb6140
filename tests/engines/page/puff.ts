/** Runs in a page: `puff()`. */
import { puff, type Effect } from '../../../src/puff.ts';

interface Played {
  /** Largest number of opaque pixels of a small copy of the canvas during the call. */
  most: number;
  /** The same after it. */
  after: number;
  canvases: number;
  visibility: string;
}

const WIDTH = 64;
const HEIGHT = 48;

/** Resolves when the smoke of a call on a box is gone. */
export async function playPuff(effect: Effect): Promise<Played> {
  const box = document.createElement('div');
  box.setAttribute('style', 'position: fixed; left: 40%; top: 40%; width: 60px; height: 30px');
  document.body.append(box);
  let most = 0;
  // After the stage's own callback of the frame: WebKitGTK draws on the canvas itself, which is empty after the frame.
  const timer = setInterval(() => requestAnimationFrame(() => (most = Math.max(most, opaque()))), 20);
  await puff(box, { effect, count: 10, seed: 5 });
  clearInterval(timer);
  // The last picture may be on its way from the worker.
  for (let frame = 0; frame < 5; ++frame) await new Promise(requestAnimationFrame);
  const { visibility } = box.style;
  box.remove();
  return { most, after: opaque(), canvases: document.querySelectorAll('canvas').length, visibility };
}

function opaque(): number {
  const canvas = document.querySelector('canvas');
  if (!canvas?.width || !canvas.height) return 0;
  const copy = Object.assign(document.createElement('canvas'), { width: WIDTH, height: HEIGHT }).getContext('2d')!;
  copy.drawImage(canvas, 0, 0, WIDTH, HEIGHT);
  const { data } = copy.getImageData(0, 0, WIDTH, HEIGHT);
  return data.filter((byte, at) => at % 4 === 3 && byte > 128).length;
}
