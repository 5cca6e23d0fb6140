/** Animated WebP: the container of RFC 9649, with frames that the browser encodes. */
import { changedArea, cropped, requireShape, type Area, type ClipFile, type ClipShape } from './clipFile.ts';

/** Bits of the header. */
const [ANIMATED, ALPHA] = [0x02, 0x10];
const FOREVER = 0;
/** Browsers encode a quality of 1 without loss, but with little effort: the files are larger than APNG. */
const QUALITY = 0.8;
/** A frame replaces what is below, and stays below the next one. */
const REPLACE_AND_KEEP = 0x02;
/** Corners of frames have even coordinates. */
const GRAIN = 2;
/** Chunks of a still picture that are its pixels: alpha, with loss, without loss. */
const PIXELS = ['ALPH', 'VP8 ', 'VP8L'];

/**
 * Encodes colours with a small loss, and alpha without loss. Frames after the first one are the rectangle that changes.
 */
export class Webp implements ClipFile {
  private readonly shape: ClipShape;
  private readonly frames: Uint8Array<ArrayBuffer>[] = [];
  private before: Uint32Array<ArrayBuffer> | undefined;

  /** @throws RangeError for a size or a rate that is not accepted */
  constructor(shape: ClipShape) {
    requireShape(shape);
    this.shape = shape;
  }

  async add({ buffer }: Uint8ClampedArray<ArrayBuffer>): Promise<void> {
    const { width, height } = this.shape;
    const pixels = new Uint32Array(buffer);
    const { before } = this;
    this.before = pixels;
    const area = before ? changedArea(before, pixels, width, GRAIN) : { x: 0, y: 0, width, height };
    const still = await encodeStill(area, cropped(pixels, width, area));
    const head = new Uint8Array(16);
    [area.x / GRAIN, area.y / GRAIN, area.width - 1, area.height - 1, this.duration()].forEach((value, at) =>
      head.set(threeBytes(value), 3 * at),
    );
    head[15] = REPLACE_AND_KEEP;
    this.frames.push(chunk('ANMF', head, ...(await pixelsIn(still))));
  }

  finish(): Blob {
    const { width, height } = this.shape;
    const header = new Uint8Array(10);
    header[0] = ANIMATED | ALPHA;
    header.set(threeBytes(width - 1), 4);
    header.set(threeBytes(height - 1), 7);
    // A background colour, which browsers ignore, and the number of plays.
    const animation = Uint8Array.of(0, 0, 0, 0, FOREVER, 0);
    const parts = [ascii('WEBP'), chunk('VP8X', header), chunk('ANIM', animation), ...this.frames];
    const size = new DataView(new ArrayBuffer(4));
    size.setUint32(
      0,
      parts.reduce((sum, { length }) => sum + length, 0),
      true,
    );
    return new Blob([ascii('RIFF'), size, ...parts], { type: 'image/webp' });
  }

  /** Milliseconds of the next frame. Rounding errors do not accumulate over frames. */
  private duration(): number {
    const until = (count: number) => Math.round((1000 * count) / this.shape.rate);
    return until(this.frames.length + 1) - until(this.frames.length);
  }
}

async function encodeStill({ width, height }: Area, pixels: Uint32Array<ArrayBuffer>): Promise<Blob> {
  const canvas = new OffscreenCanvas(width, height);
  const image = new ImageData(new Uint8ClampedArray(pixels.buffer), width, height);
  canvas.getContext('2d')!.putImageData(image, 0, 0);
  return canvas.convertToBlob({ type: 'image/webp', quality: QUALITY });
}

/** The chunks of a still picture that go into a frame. */
async function pixelsIn(still: Blob): Promise<Uint8Array<ArrayBuffer>[]> {
  const bytes = new Uint8Array(await still.arrayBuffer());
  const view = new DataView(bytes.buffer);
  const found: Uint8Array<ArrayBuffer>[] = [];
  for (let at = 12; at + 8 <= bytes.length;) {
    const length = view.getUint32(at + 4, true);
    const end = at + 8 + length + (length % 2);
    if (PIXELS.includes(String.fromCharCode(...bytes.subarray(at, at + 4)))) found.push(bytes.subarray(at, end));
    at = end;
  }
  return found;
}

/** A chunk with its length, and a byte after an odd length. */
function chunk(kind: string, ...contents: Uint8Array[]): Uint8Array<ArrayBuffer> {
  const length = contents.reduce((sum, content) => sum + content.length, 0);
  const whole = new Uint8Array(8 + length + (length % 2));
  whole.set(ascii(kind));
  new DataView(whole.buffer).setUint32(4, length, true);
  let at = 8;
  for (const content of contents) {
    whole.set(content, at);
    at += content.length;
  }
  return whole;
}

function ascii(text: string): Uint8Array<ArrayBuffer> {
  return new TextEncoder().encode(text);
}

function threeBytes(value: number): number[] {
  return [value & 0xff, (value >> 8) & 0xff, value >> 16];
}
