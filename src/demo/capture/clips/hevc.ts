import type { ClipShape } from '../../../internal.ts';

/** Main profile, level 5.1: up to 4096 by 2304 pixels at 60 frames per second. */
const CODEC = 'hvc1.1.6.L153.B0';
const BITS_PER_PIXEL = 0.25;

/**
 * Settings of an encoder of HEVC with alpha, which Safari shows.
 * @returns undefined where the browser has none; in 2026 no browser has one
 */
export async function hevcWithAlpha({ width, height, rate }: ClipShape): Promise<VideoEncoderConfig | undefined> {
  if (typeof VideoEncoder === 'undefined') return undefined;
  const bitrate = Math.round(BITS_PER_PIXEL * width * height * rate);
  const config: VideoEncoderConfig = { codec: CODEC, width, height, framerate: rate, bitrate, alpha: 'keep' };
  // oxlint-disable-next-line compat/compat -- asked above
  const answer = await VideoEncoder.isConfigSupported(config).catch(() => undefined);
  // A browser that does not know `alpha` leaves it out of its answer.
  return answer?.supported && answer.config?.alpha === 'keep' ? config : undefined;
}
