/** Videos of finished frames. */
import { ClipFiles } from '../../internal.ts';
import { decodePng } from '../gallery/straightPng.ts';
import { nameOf, type FilmOrder } from './order.ts';
import type { Receiver } from './receiver.ts';

/** Frames of one size. */
export interface Pictures extends Pick<FilmOrder, 'width' | 'height' | 'fps' | 'hasBackground'> {
  /** Straight-alpha pixels. The frames of a range are asked for in their order. */
  readonly get: (frame: number) => Promise<ImageData>;
}

type VideoOrder = NonNullable<FilmOrder['video']>;

/** A finished frame. Not by a canvas, which would multiply alpha into the colours. */
export async function pictureOf(frame: number, receiver: Receiver): Promise<ImageData> {
  const file = new File([await receiver.picture(frame)], nameOf(frame, undefined, 'png'));
  const { data, width, height } = await decodePng(file);
  return new ImageData(new Uint8ClampedArray(data.buffer as ArrayBuffer), width, height);
}

export async function encodeFrames(pictures: Pictures, video: VideoOrder): Promise<Blob> {
  const { format, first, last } = video;
  if (format !== 'apng' && format !== 'webp') return encodeFilm(pictures, { ...video, format });
  const { width, height, fps, get } = pictures;
  const files = new ClipFiles([format], { width, height, rate: fps });
  for (let frame = first; frame <= last; ++frame) await files.add((await get(frame)).data);
  return files.finish()[0];
}

async function encodeFilm(
  { width, height, fps, hasBackground, get }: Pictures,
  { format, first, last }: VideoOrder & { readonly format: 'webm' | 'mp4' },
): Promise<Blob> {
  const { encodeVideo } = await import('../capture/video.ts');
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d')!;
  const settings = { format, width, height, scale: 1, hasBackground, rate: fps };
  return encodeVideo(settings, async (add) => {
    for (let frame = first; frame <= last; ++frame) {
      context.putImageData(await get(frame), 0, 0);
      await add(canvas, frame - first);
    }
  });
}
