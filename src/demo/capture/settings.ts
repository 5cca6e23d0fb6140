/** Capture formats and settings. */
export const FORMATS = {
  png: { isClip: false, hasAlpha: true },
  svg: { isClip: false, hasAlpha: true },
  apng: { isClip: true, hasAlpha: true },
  webp: { isClip: true, hasAlpha: true },
  gif: { isClip: true, hasAlpha: true },
  webm: { isClip: true, hasAlpha: true },
  // With alpha only where the browser encodes it, see clips/hevc.ts.
  mp4: { isClip: true, hasAlpha: false },
  zip: { isClip: true, hasAlpha: true },
  flipbook: { isClip: true, hasAlpha: false },
} as const;
export type Format = keyof typeof FORMATS;

/** Formats for the same purpose, whose sizes are compared. */
export const COMPARED = ['apng', 'webp', 'gif', 'webm', 'mp4'] as const;
export type ComparedFormat = (typeof COMPARED)[number];

export function isCompared(format: Format): boolean {
  return COMPARED.some((each) => each === format);
}

/** Device pixels per CSS pixel. */
export const SCALES = [1, 2, 4] as const;
/**
 * Frames per second. GIF delays are in hundredths of a second, and browsers slow down GIFs above 50 frames per second.
 */
export const RATES = [12, 24, 30, 60] as const;
export const FASTEST_GIF = 30;
/** Maximum length of a clip in seconds. */
export const LONGEST = 60;

/** Layout of six-way light maps: as Unity reads them, or in the order RLT, BBF of tools for Unreal Engine. */
export type LightLayout = 'unity' | 'unreal';

export interface CaptureSettings {
  readonly format: Format;
  /** Size in CSS pixels, and device pixels per CSS pixel. */
  readonly width: number;
  readonly height: number;
  readonly scale: number;
  readonly hasBackground: boolean;
  /** Length of a clip in seconds, and its frames per second. */
  readonly seconds: number;
  readonly rate: number;
  /** Whether the zip contains flats, shadow, ink, surfaces and depth as separate layers instead of complete frames. */
  readonly inLayers: boolean;
  /** Layout of the six-way light maps of a flipbook; none if absent. */
  readonly lights?: LightLayout;
}

/** Columns of the atlas of a flipbook, as many as rows or one more. */
export function columnsOf(frames: number): number {
  return Math.ceil(Math.sqrt(frames));
}

/** Size in device pixels. Video encoders require even sizes. */
export function pixelSize({
  format,
  width,
  height,
  scale,
}: Pick<CaptureSettings, 'format' | 'width' | 'height' | 'scale'>): [width: number, height: number] {
  const grain = format === 'webm' || format === 'mp4' ? 2 : 1;
  return [width, height].map((side) => Math.max(grain, grain * Math.round((side * scale) / grain))) as [number, number];
}
