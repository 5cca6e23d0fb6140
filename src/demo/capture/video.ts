import {
  BufferTarget,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  Quality,
  VideoSample,
  VideoSampleSource,
  WebMOutputFormat,
  type VideoCodec,
} from 'mediabunny';
import { strings } from '../strings.ts';
import { shootClip, VideoError, type Task, type Studio } from './studio.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';

/** Codecs in order of browser support. */
const CODECS: Readonly<Record<'webm' | 'mp4', VideoCodec[]>> = {
  webm: ['vp9', 'vp8', 'av1'],
  mp4: ['avc', 'hevc', 'av1', 'vp9'],
};

type VideoSettings = Pick<CaptureSettings, 'format' | 'width' | 'height' | 'scale' | 'hasBackground' | 'rate'>;
type AddFrame = (canvas: HTMLCanvasElement | OffscreenCanvas, frame: number) => Promise<void>;

/**
 * Encodes every frame as WebM or MP4 with the browser's encoder.
 * @throws VideoError when the browser cannot encode the format at this size
 */
export function makeVideo(studio: Studio, settings: CaptureSettings, task: Task): Promise<Blob> {
  return encodeVideo(settings, (add) => shootClip(studio, settings, task, (frame) => add(studio.canvas, frame)));
}

/**
 * @param shoot adds the frames in order, from 0
 * @throws VideoError when the browser cannot encode the format at this size
 */
export async function encodeVideo(settings: VideoSettings, shoot: (add: AddFrame) => Promise<void>): Promise<Blob> {
  const source = new VideoSampleSource(await encodingOf(settings));
  const target = new BufferTarget();
  const isMp4 = settings.format === 'mp4';
  const format = isMp4 ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
  const output = new Output({ format, target });
  output.addVideoTrack(source, { frameRate: settings.rate });
  await output.start();
  try {
    await shoot((canvas, frame) => addFrame(source, canvas, frame, settings.rate));
  } catch (error) {
    await output.cancel();
    throw error;
  }
  await output.finalize();
  return new Blob([target.buffer!], { type: isMp4 ? 'video/mp4' : 'video/webm' });
}

async function addFrame(
  source: VideoSampleSource,
  canvas: HTMLCanvasElement | OffscreenCanvas,
  frame: number,
  rate: number,
): Promise<void> {
  const sample = new VideoSample(canvas, { timestamp: frame / rate, duration: 1 / rate });
  // Waits while the encoder's queue is full.
  await source.add(sample);
  sample.close();
}

async function encodingOf(settings: VideoSettings) {
  const [width, height] = pixelSize(settings);
  const format = settings.format as keyof typeof CODECS;
  const encoding = {
    quality: new Quality('very-high'),
    alpha: format === 'webm' && !settings.hasBackground ? ('keep' as const) : ('discard' as const),
  };
  const codec =
    typeof VideoEncoder === 'undefined'
      ? null
      : await getFirstEncodableVideoCodec(CODECS[format], { width, height, frameRate: settings.rate, ...encoding });
  if (!codec) throw new VideoError(strings.capture.noEncoder(strings.capture.formats[format], width, height));
  return { codec, ...encoding };
}
