import {
  BufferTarget,
  EncodedPacket,
  EncodedVideoPacketSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  Quality,
  VideoSample,
  VideoSampleSource,
  WebMOutputFormat,
  type VideoCodec,
} from 'mediabunny';
import { shootClip, type Studio, type Task } from '../../internal.ts';
import { strings } from '../strings.ts';
import { hevcWithAlpha } from './clips/hevc.ts';
import { VideoError } from './studio.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';

/** Codecs in order of browser support. */
const CODECS: Readonly<Record<'webm' | 'mp4', VideoCodec[]>> = {
  webm: ['vp9', 'vp8', 'av1'],
  mp4: ['avc', 'hevc', 'av1', 'vp9'],
};

/** Frames from one that needs no other to the next. */
const KEY_FRAMES = 60;

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
  const track = await openTrack(settings);
  const target = new BufferTarget();
  const isMp4 = settings.format === 'mp4';
  const format = isMp4 ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
  const output = new Output({ format, target });
  output.addVideoTrack(track.source, { frameRate: settings.rate });
  await output.start();
  try {
    await shoot((canvas, frame) => track.add(canvas, frame));
    await track.finish?.();
  } catch (error) {
    track.cancel?.();
    await output.cancel();
    throw error;
  }
  await output.finalize();
  return new Blob([target.buffer!], { type: isMp4 ? 'video/mp4' : 'video/webm' });
}

interface Track {
  readonly source: VideoSampleSource | EncodedVideoPacketSource;
  readonly add: AddFrame;
  /** Waits for the last frames. */
  readonly finish?: () => Promise<void>;
  readonly cancel?: () => void;
}

async function openTrack(settings: VideoSettings): Promise<Track> {
  const { rate } = settings;
  const [width, height] = pixelSize(settings);
  const mayHaveAlpha = settings.format === 'mp4' && !settings.hasBackground;
  const config = mayHaveAlpha ? await hevcWithAlpha({ width, height, rate }) : undefined;
  if (config) return openAlphaTrack(config, rate);
  const source = new VideoSampleSource(await encodingOf(settings));
  const add: AddFrame = async (canvas, frame) => {
    const sample = new VideoSample(canvas, { timestamp: frame / rate, duration: 1 / rate });
    // Waits while the encoder's queue is full.
    await source.add(sample);
    sample.close();
  };
  return { source, add };
}

/** With an encoder of its own, because that of mediabunny encodes alpha as a second picture, which MP4 cannot hold. */
function openAlphaTrack(config: VideoEncoderConfig, rate: number): Track {
  const source = new EncodedVideoPacketSource('hevc');
  let written = Promise.resolve();
  let fail: (error: Error) => void;
  const failure = new Promise<never>((_, reject) => (fail = reject));
  failure.catch(() => undefined);
  // oxlint-disable-next-line compat/compat -- has answered that it supports the settings
  const encoder = new VideoEncoder({
    output: (chunk, meta) => {
      written = written.then(() => source.add(EncodedPacket.fromEncodedChunk(chunk), meta));
      written.catch(fail);
    },
    error: (error) => fail(error),
  });
  encoder.configure(config);
  return {
    source,
    add: async (canvas, frame) => {
      // oxlint-disable-next-line compat/compat -- comes with VideoEncoder
      const picture = new VideoFrame(canvas, { timestamp: (1e6 * frame) / rate, duration: 1e6 / rate, alpha: 'keep' });
      encoder.encode(picture, { keyFrame: frame % KEY_FRAMES === 0 });
      picture.close();
      await Promise.race([encoder.encodeQueueSize > 1 ? dequeued(encoder) : written, failure]);
    },
    finish: async () => {
      await Promise.race([encoder.flush(), failure]);
      encoder.close();
      await written;
    },
    cancel: () => encoder.state !== 'closed' && encoder.close(),
  };
}

function dequeued(encoder: VideoEncoder): Promise<unknown> {
  return new Promise((resolve) => encoder.addEventListener('dequeue', resolve, { once: true }));
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
