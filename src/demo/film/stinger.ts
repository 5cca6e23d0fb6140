/** A wipe as a file for video mixers and editors: when it covers everything, and its track matte. */
import { clearedAfter, lookIn, makeWipe, PixelReader } from '../../internal.ts';
import type { Values } from '../../preset.ts';
import { encodeFrames, pictureOf, type Pictures } from './frameVideo.ts';
import { nameOf, type FilmOrder, type MatteLayout, type Stinger } from './order.ts';
import { messages, type Receiver } from './receiver.ts';

type StingerOrder = FilmOrder & { readonly stinger: Stinger };

/** The matte is white this many pixels below the edge of the smoke, because lossy videos blur edges. */
const OVERLAP = 4;

/** The wipe of a stinger in a look, as wide as its frames, and its last frame. */
export function wipeOf({ cutFrame, direction }: Stinger, order: StingerShot, values: Values) {
  const { width, height, scale, fps } = order;
  const size = { width: width / scale, height: height / scale, pixelRatio: scale };
  const duration = cutFrame / fps;
  const wipe = makeWipe(lookIn(values), size, { direction, duration, seed: values.seed as number });
  return { ...wipe, last: cutFrame + Math.ceil(clearedAfter(duration) * fps) };
}

type StingerShot = Pick<FilmOrder, 'width' | 'height' | 'scale' | 'fps'>;

/**
 * Checks the finished frames and sends the report, the matte and the videos.
 * @throws Error if a pixel is not covered at the cut, or the first or the last frame is not empty
 */
export async function finishStinger(order: StingerOrder, last: number, receiver: Receiver): Promise<void> {
  await receiver.putStinger({ ...(await examine(order, last, receiver)), matte: order.matte });
  const { video, matte } = order;
  if (!video) return;
  const range = { ...video, first: 0, last };
  await receiver.putVideo(await encodeFrames(picturesOf(order, matte, receiver), range));
  if (matte !== 'separate') return;
  const matteFilm = { ...order, hasBackground: true, get: mattesOf(order, receiver) };
  await receiver.putVideo(await encodeFrames(matteFilm, range), 'matte');
}

/** Looks at every pixel of the frames, and sends the files of the matte. */
async function examine(order: StingerOrder, last: number, receiver: Receiver) {
  const { width, height, fps, stinger } = order;
  const { cutFrame, direction } = stinger;
  const matte = order.matte && new Matte(width, height, cutFrame);
  const encoder = new PixelReader(width, height);
  const isCovered: boolean[] = [];
  for (let frame = 0; frame <= last; ++frame) {
    const picture = await pictureOf(frame, receiver);
    const alphas = picture.data.filter((_, at) => at % 4 === 3);
    const open = alphas.filter((alpha) => alpha < 255).length;
    if (frame === cutFrame && open > 0) throw new Error(messages.uncovered(open));
    if ((frame === 0 || frame === last) && alphas.some((alpha) => alpha > 0)) throw new Error(messages.leftOver(frame));
    isCovered.push(open === 0);
    if (!matte) continue;
    await receiver.put(nameOf(frame, 'matte', 'png'), await encoder.encode(matte.at(frame, picture)));
  }
  const covered = [isCovered.lastIndexOf(false, cutFrame) + 1, isCovered.indexOf(false, cutFrame) - 1];
  const cutMs = Math.round((1000 * cutFrame) / fps);
  const frames = last + 1;
  return { cutMs, cutFrame, covered, fps, frames, duration: frames / fps, width, height, direction };
}

/** The frames of the film, with the matte beside or below them. */
function picturesOf(order: StingerOrder, layout: MatteLayout | undefined, receiver: Receiver): Pictures {
  if (layout === undefined || layout === 'separate') {
    return { ...order, get: (frame) => pictureOf(frame, receiver) };
  }
  const { width, height } = order;
  const matte = new Matte(width, height, order.stinger.cutFrame);
  const [right, down] = layout === 'stacked' ? [0, height] : [width, 0];
  return {
    ...order,
    width: width + right,
    height: height + down,
    async get(frame) {
      const picture = await pictureOf(frame, receiver);
      const joined = new ImageData(width + right, height + down);
      const below = matte.at(frame, picture);
      for (let row = 0; row < height; ++row) {
        const line = (from: ImageData) => from.data.subarray(4 * width * row, 4 * width * (row + 1));
        joined.data.set(line(picture), 4 * joined.width * row);
        joined.data.set(line(below), 4 * (joined.width * (row + down) + right));
      }
      return joined;
    },
  };
}

function mattesOf({ width, height, stinger }: StingerOrder, receiver: Receiver) {
  const matte = new Matte(width, height, stinger.cutFrame);
  return async (frame: number) => matte.at(frame, await pictureOf(frame, receiver));
}

/**
 * White where the next scene shows, black elsewhere. Until the cut all is black. From then on a pixel is white once the smoke
 * above it is not opaque, and stays white.
 */
export class Matte {
  private readonly cutFrame: number;
  private readonly picture: ImageData;
  private readonly pixels: Uint32Array;
  private readonly wasOpen: Uint8Array;

  constructor(width: number, height: number, cutFrame: number) {
    this.cutFrame = cutFrame;
    this.picture = new ImageData(width, height);
    // Opaque black as 0xAABBGGRR.
    this.pixels = new Uint32Array(this.picture.data.buffer).fill(0xff000000);
    this.wasOpen = new Uint8Array(width * height);
  }

  /**
   * The matte of a frame, valid until the next call.
   * @param picture the frame, of those since the cut each in their order
   */
  at(frame: number, { data }: ImageData): ImageData {
    if (frame < this.cutFrame) return this.picture;
    for (let at = 0; at < this.wasOpen.length; ++at) {
      if (this.wasOpen[at] || data[4 * at + 3] === 255) continue;
      this.wasOpen[at] = 1;
      this.whiten(at);
    }
    return this.picture;
  }

  private whiten(at: number): void {
    const { width, height } = this.picture;
    const [x, y] = [at % width, Math.floor(at / width)];
    const [left, right] = [Math.max(0, x - OVERLAP), Math.min(width, x + OVERLAP + 1)];
    for (let row = Math.max(0, y - OVERLAP); row < Math.min(height, y + OVERLAP + 1); ++row) {
      this.pixels.fill(0xffffffff, row * width + left, row * width + right);
    }
  }
}
