/** What can be captured, and what somebody has asked for. */
export const FORMATS = {
  png: { isClip: false, hasAlpha: true },
  svg: { isClip: false, hasAlpha: true },
  gif: { isClip: true, hasAlpha: true },
  webm: { isClip: true, hasAlpha: true },
  mp4: { isClip: true, hasAlpha: false },
  zip: { isClip: true, hasAlpha: true },
} as const;
export type Format = keyof typeof FORMATS;

/** Pixels in a CSS pixel. */
export const SCALES = [1, 2, 4] as const;
/** Frames a second; a GIF counts hundredths of a second, and browsers slow down what is faster than 50. */
export const RATES = [12, 24, 30, 60] as const;
export const FASTEST_GIF = 30;
/** Longest clip, seconds. */
export const LONGEST = 60;

export interface CaptureSettings {
  readonly format: Format;
  /** Size in CSS pixels, and how many pixels make one. */
  readonly width: number;
  readonly height: number;
  readonly scale: number;
  readonly hasBackground: boolean;
  /** Length of a clip in seconds, and its frames a second. */
  readonly seconds: number;
  readonly rate: number;
  /** Whether a zip holds flats, shadow, ink and depth apart, instead of pictures. */
  readonly inLayers: boolean;
}

/** How many frames a clip has, at least 1. */
export function frameCount({ seconds, rate }: CaptureSettings): number {
  return Math.max(1, Math.round(seconds * rate));
}

/** Size in pixels. Encoders of video take even sizes only. */
export function pixelSize({ format, width, height, scale }: CaptureSettings): [width: number, height: number] {
  const grain = format === 'webm' || format === 'mp4' ? 2 : 1;
  return [width, height].map((side) => Math.max(grain, grain * Math.round((side * scale) / grain))) as [number, number];
}
