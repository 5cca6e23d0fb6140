/** Animated PNG, by the third edition of the PNG specification (W3C, 2025). */
import { chunk, deflated, filtered, FILTERS, header, SIGNATURE, type Filter } from './pngChunks.ts';
import { changedArea, cropped, requireShape, type Area, type ClipFile, type ClipShape } from './clipFile.ts';

/** Number of plays of a clip that never ends. */
const FOREVER = 0;
/** The previous frame stays below the next one. */
const KEEP = 0;
/** A frame replaces what is below, or covers it where it is opaque. */
const [REPLACE, COVER] = [0, 1];

/**
 * Encodes without loss, alpha included. Frames after the first one are the rectangle that changes. If all that changes is
 * opaque, pixels that stay the same are transparent in it, which compresses better.
 */
export class Apng implements ClipFile {
  private readonly shape: ClipShape;
  private readonly chunks: Uint8Array<ArrayBuffer>[] = [];
  private readonly delay: readonly [numerator: number, denominator: number];
  private before: Uint32Array<ArrayBuffer> | undefined;
  private filter: Filter = FILTERS.none;
  private frames = 0;
  /** Number of the next chunk of an animation. */
  private sequence = 0;

  /** @throws RangeError for a size or a rate that is not accepted */
  constructor(shape: ClipShape) {
    requireShape(shape);
    this.shape = shape;
    this.delay = delayOf(shape.rate);
  }

  async add({ buffer }: Uint8ClampedArray<ArrayBuffer>): Promise<void> {
    const { width, height } = this.shape;
    const pixels = new Uint32Array(buffer);
    const { before } = this;
    this.before = pixels;
    if (!before) {
      const area = { x: 0, y: 0, width, height };
      this.control(area, REPLACE);
      this.chunks.push(chunk('IDAT', await this.packFirst(area, pixels)));
      return;
    }
    const area = changedArea(before, pixels, width);
    const part = cropped(pixels, width, area);
    const blend = keepUnchanged(part, cropped(before, width, area)) ? COVER : REPLACE;
    this.control(area, blend);
    const packed = await pack(area, part, this.filter);
    const data = new Uint8Array(4 + packed.length);
    new DataView(data.buffer).setUint32(0, this.sequence++);
    data.set(packed, 4);
    this.chunks.push(chunk('fdAT', data));
  }

  finish(): Blob {
    const { width, height } = this.shape;
    const control = new DataView(new ArrayBuffer(8));
    control.setUint32(0, this.frames);
    control.setUint32(4, FOREVER);
    const head = [SIGNATURE, header(width, height), chunk('acTL', new Uint8Array(control.buffer))];
    return new Blob([...head, ...this.chunks, chunk('IEND', new Uint8Array())], { type: 'image/apng' });
  }

  /** Packs the first frame with the best filter, which later frames use, too: they have the same style. */
  private async packFirst(area: Area, pixels: Uint32Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
    let best: Uint8Array<ArrayBuffer> | undefined;
    for (const filter of Object.values(FILTERS)) {
      const packed = await pack(area, pixels, filter);
      if (best && packed.length >= best.length) continue;
      best = packed;
      this.filter = filter;
    }
    return best!;
  }

  private control({ x, y, width, height }: Area, blend: number): void {
    const content = new Uint8Array(26);
    const view = new DataView(content.buffer);
    [this.sequence++, width, height, x, y].forEach((value, at) => view.setUint32(4 * at, value));
    this.delay.forEach((value, at) => view.setUint16(20 + 2 * at, value));
    content.set([KEEP, blend], 24);
    this.chunks.push(chunk('fcTL', content));
    this.frames++;
  }
}

/** Seconds of a frame as a fraction of numbers with 16 bits. It is exact for 24, 12.5 and 24000/1001 frames per second. */
function delayOf(rate: number): [numerator: number, denominator: number] {
  const numerators = [1, 2, 1001, 100];
  const numerator = numerators.find((each) => Math.abs(each * rate - Math.round(each * rate)) < 1e-6) ?? 100;
  return [numerator, Math.round(numerator * rate)];
}

/**
 * Makes the pixels transparent that stay the same, if the others can then cover what is below: they are opaque, or there is
 * nothing below.
 * @returns whether they are
 */
function keepUnchanged(part: Uint32Array, below: Uint32Array): boolean {
  const covers = part.every((pixel, at) => {
    const alpha = pixel >>> 24;
    return pixel === below[at] || alpha === 255 || (alpha > 0 && below[at] === 0);
  });
  if (covers) part.forEach((pixel, at) => pixel === below[at] && (part[at] = 0));
  return covers;
}

function pack(
  { width, height }: Area,
  pixels: Uint32Array<ArrayBuffer>,
  filter: Filter,
): Promise<Uint8Array<ArrayBuffer>> {
  const rows = filtered({ width, height, data: new Uint8Array(pixels.buffer) }, filter);
  for (;;) {
    const { done, value } = rows.next();
    if (done) return deflated(value);
  }
}
