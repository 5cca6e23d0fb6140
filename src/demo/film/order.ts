/** What the film page and the command exchange. scripts/film/server.mjs is the other side. */
import type { LightLayout } from '../capture/settings.ts';

/** Camera values at a time, by parameter key. */
export interface Keyframe {
  /** Seconds from frame 0. */
  readonly seconds: number;
  readonly values: Readonly<Record<string, number>>;
}

/** The last one is included. */
export interface FrameRange {
  readonly first: number;
  readonly last: number;
}

/** Videos that the page encodes. */
export type VideoFormat = 'webm' | 'mp4' | 'apng' | 'webp';

/** Where the track matte of a stinger is: to the right of the picture, below it, or in a file of its own. */
export type MatteLayout = 'side-by-side' | 'stacked' | 'separate';

/** A wipe that has the look of the link. */
export interface Stinger {
  /** The frame in which smoke covers everything. */
  readonly cutFrame: number;
  /** Where the smoke goes, in degrees: 0 is to the right, 90 up. */
  readonly direction: number;
}

/** A shot to render. */
export interface FilmOrder {
  /** Query and hash of the address: `?t=2#v=1&preset=lamp`. */
  readonly link: string;
  /** Size of the files in pixels. */
  readonly width: number;
  readonly height: number;
  /** Output pixels per CSS pixel. */
  readonly scale: number;
  /** Drawn pixels per output pixel, in each direction: 1 or 2. */
  readonly supersample: number;
  /** Frames per second. */
  readonly fps: number;
  readonly hasBackground: boolean;
  readonly layers: boolean;
  readonly format: 'png' | 'exr';
  readonly camera: readonly Keyframe[];
  /** Frames between two saved states; 0 without states. */
  readonly statesEvery: number;
  /** Frames of a loop, whose last ones dissolve into what is before the first one. */
  readonly loop?: FrameRange;
  /** Instead of the link's smoke and of a range of frames. */
  readonly stinger?: Stinger;
  /** The track matte of a stinger; none if absent. */
  readonly matte?: MatteLayout;
  /** A video of finished frames. A stinger has its own range. */
  readonly video?: FrameRange & { readonly format: VideoFormat };
}

/** A looped flipbook to draw. */
export interface FlipbookOrder {
  readonly link: string;
  readonly columns: number;
  readonly rows: number;
  /** Size of a frame in pixels. */
  readonly width: number;
  readonly height: number;
  /** Pixels per CSS pixel. */
  readonly scale: number;
  /** Length of the loop. */
  readonly seconds: number;
  /** Layout of the six-way light maps; none if absent. */
  readonly lights?: LightLayout;
}

/** What the page finds out before the first frame. */
export interface Beginning {
  /** The unmasked renderer string of WebGL. */
  readonly renderer: string;
  /** The link in its canonical form. */
  readonly link: string;
  /** Simulated seconds of frame 0. */
  readonly start: number;
  /** The last frame of a stinger; the first is 0. */
  readonly last?: number;
}

/** A finished frame. */
export interface DrawnFrame {
  readonly frame: number;
  readonly step: number;
  /** Hash of the simulator's state. */
  readonly hash: string;
  /** Milliseconds for drawing with the GPU done, for reading back, and until the files are encoded. */
  readonly drawMs: number;
  readonly readMs: number;
  readonly encodeMs: number;
}

/** Names of the files of a frame, by layer; the whole picture has no layer. */
export function nameOf(frame: number, layer: string | undefined, format: FilmOrder['format']): string {
  const number = String(frame).padStart(6, '0');
  return `${layer ? `${layer}/` : 'frame-'}${number}.${format}`;
}
