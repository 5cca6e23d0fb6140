/** What the encoders of looped clips have in common. */

export type ClipFormat = 'apng' | 'webp' | 'gif';

/** A looped clip that is encoded frame by frame. */
export interface ClipFile {
  /**
   * Adds a frame.
   * @param pixels straight alpha, four bytes each, rows from the top. They belong to the file from now on
   */
  add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void>;
  /** The whole file. It has at least one frame. */
  finish(): Blob;
}

/** Size in pixels, and frames per second. */
export interface ClipShape {
  readonly width: number;
  readonly height: number;
  readonly rate: number;
}

/** A rectangle of a frame in pixels. */
export interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/**
 * The smallest rectangle with all pixels that differ between two frames, at least one pixel.
 * @param before, after four bytes as one number for each pixel
 * @param grain the corner of the rectangle has coordinates that are multiples of it
 */
export function changedArea(before: Uint32Array, after: Uint32Array, width: number, grain = 1): Area {
  const first = after.findIndex((pixel, at) => pixel !== before[at]);
  if (first < 0) return { x: 0, y: 0, width: 1, height: 1 };
  const last = after.findLastIndex((pixel, at) => pixel !== before[at]);
  const [top, bottom] = [first, last].map((at) => Math.floor(at / width));
  let [left, right] = [width, 0];
  for (let at = top * width; at < (bottom + 1) * width; at++) {
    if (after[at] === before[at]) continue;
    const x = at % width;
    if (x < left) left = x;
    if (x > right) right = x;
  }
  const [x, y] = [left - (left % grain), top - (top % grain)];
  return { x, y, width: right + 1 - x, height: bottom + 1 - y };
}

/** The pixels of a rectangle. */
export function cropped(pixels: Uint32Array<ArrayBuffer>, width: number, area: Area): Uint32Array<ArrayBuffer> {
  const part = new Uint32Array(area.width * area.height);
  for (let row = 0; row < area.height; row++) {
    const from = (area.y + row) * width + area.x;
    part.set(pixels.subarray(from, from + area.width), row * area.width);
  }
  return part;
}

/** Largest size of a side: 14 bits in WebP; what decoders of PNG accept is larger. */
export const LONGEST_SIDE = 16_383;
/** Browsers show frames of 10 ms or less for 100 ms. */
export const FASTEST = 60;

/** @throws RangeError that names the size or the rate and what is accepted */
export function requireShape({ width, height, rate }: ClipShape): void {
  for (const side of [width, height]) {
    if (!Number.isInteger(side) || side < 1 || side > LONGEST_SIDE) {
      throw new RangeError(`A clip has 1 to ${LONGEST_SIDE} pixels per side, not ${width} \u00d7 ${height}.`);
    }
  }
  if (!(rate >= 1 && rate <= FASTEST))
    throw new RangeError(`A clip has 1 to ${FASTEST} frames per second, not ${rate}.`);
}
