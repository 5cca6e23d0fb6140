/**
 * Reads and writes PNGs byte by byte. A canvas multiplies alpha into the colours, which destroys the channels of a puff
 * sheet where alpha is low, and browsers may convert its colours or falsify what is read of it.
 */
import { ShapeError, type PixelImage } from '../../index.ts';
import {
  deflated,
  inPieces,
  PNG_FILTERS as FILTERS,
  PNG_SIGNATURE as SIGNATURE,
  pngChunk as chunk,
  pngHeader as header,
  pngRows as filtered,
  predicted,
} from '../../internal.ts';

/** Maximum size of a file in bytes, and of a picture in pixels along each side. */
const MAX_BYTES = 128 * 1024 * 1024;
const MAX_PIXELS = 8192;

interface Picture {
  readonly width: number;
  readonly height: number;
  /** Bits of a sample. */
  readonly depth: number;
  /** Samples of a pixel: by its type of colour, as PNG numbers them. */
  readonly samples: number;
  readonly hasColors: boolean;
  readonly hasAlpha: boolean;
  /** Red, green and blue by index, and alpha of the first of them. */
  readonly palette: Uint8Array | undefined;
  readonly alphas: Uint8Array;
  readonly compressed: Blob;
}

/** @throws ShapeError if the file is too large, no PNG, damaged, interlaced, or has a transparent colour */
export async function decodePng(file: File): Promise<PixelImage> {
  if (file.size > MAX_BYTES) {
    throw new ShapeError(`${file.name} has more than ${MAX_BYTES / 1024 / 1024} MB. Make the picture smaller.`);
  }
  const picture = pictureIn(new Uint8Array(await file.arrayBuffer()), file.name);
  try {
    return await pixelsOf(picture);
  } catch (error) {
    throw new ShapeError(`${file.name} is damaged. Save it again.`, { cause: error });
  }
}

function pictureIn(bytes: Uint8Array<ArrayBuffer>, name: string): Picture {
  if (SIGNATURE.some((byte, at) => bytes[at] !== byte)) {
    throw new ShapeError(`${name} is not a PNG. Save the puff sheet as PNG, with its alpha.`);
  }
  const view = new DataView(bytes.buffer);
  const chunks = new Map<string, Uint8Array<ArrayBuffer>[]>();
  for (let at = SIGNATURE.length; at + 12 <= bytes.length; at += 12 + view.getUint32(at)) {
    const kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    chunks.set(kind, [...(chunks.get(kind) ?? []), bytes.subarray(at + 8, at + 8 + view.getUint32(at))]);
  }
  const [head] = chunks.get('IHDR') ?? [];
  if (head?.length !== 13) throw new ShapeError(`${name} is damaged. Save it again.`);
  const sizes = new DataView(head.buffer, head.byteOffset);
  const [width, height] = [sizes.getUint32(0), sizes.getUint32(4)];
  const [depth, type, , , interlace] = head.subarray(8);
  if (width > MAX_PIXELS || height > MAX_PIXELS) {
    throw new ShapeError(`${name} has ${width} x ${height} pixels. The limit is ${MAX_PIXELS} x ${MAX_PIXELS}.`);
  }
  if (interlace) throw new ShapeError(`${name} is interlaced. Save it without interlacing.`);
  const [isIndexed, hasColors, hasAlpha] = [type === 3, (type & 2) > 0, (type & 4) > 0];
  if (!isIndexed && chunks.has('tRNS')) {
    throw new ShapeError(`${name} has a transparent colour instead of an alpha channel. Save it with alpha.`);
  }
  const samples = isIndexed ? 1 : (hasColors ? 3 : 1) + (hasAlpha ? 1 : 0);
  const palette = isIndexed ? (chunks.get('PLTE')?.[0] ?? new Uint8Array()) : undefined;
  const alphas = chunks.get('tRNS')?.[0] ?? new Uint8Array();
  const compressed = new Blob(chunks.get('IDAT') ?? []);
  return { width, height, depth, samples, hasColors, hasAlpha, palette, alphas, compressed };
}

async function pixelsOf(picture: Picture): Promise<PixelImage> {
  const { width, height, depth, samples, compressed } = picture;
  const data = new Uint8Array(4 * width * height);
  const stride = Math.ceil((width * samples * depth) / 8);
  const reach = Math.max(1, (samples * depth) / 8);
  // The first byte of a row is its filter.
  let [line, before] = [new Uint8Array(1 + stride), new Uint8Array(1 + stride)];
  let [filled, row] = [0, 0];
  const reader = compressed.stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  while (row < height) {
    const { done, value } = await reader.read();
    if (done) throw new Error(`The picture ends at row ${row}.`);
    for (let at = 0; at < value.length && row < height;) {
      const part = value.subarray(at, at + line.length - filled);
      line.set(part, filled);
      at += part.length;
      filled += part.length;
      if (filled < line.length) break;
      unfilter(line, before, reach);
      writeRow(picture, line.subarray(1), data.subarray(4 * width * row, 4 * width * (row + 1)));
      [line, before] = [before, line];
      filled = 0;
      row++;
    }
  }
  await reader.cancel();
  return { width, height, data };
}

/** @param reach bytes from a byte to the same one of the pixel to its left */
function unfilter(line: Uint8Array, before: Uint8Array, reach: number): void {
  const [filter] = line;
  if (filter > 4) throw new Error(`Filter ${filter} is unknown.`);
  if (filter === 0) return;
  for (let at = 1; at < line.length; at++) {
    const left = at > reach ? line[at - reach] : 0;
    const corner = at > reach ? before[at - reach] : 0;
    line[at] += predicted(filter, left, before[at], corner);
  }
}

function writeRow(
  { depth, samples, hasColors, hasAlpha, palette, alphas }: Picture,
  line: Uint8Array,
  data: Uint8Array,
) {
  if (depth === 8 && samples === 4) return data.set(line);
  const largest = 2 ** Math.min(8, depth) - 1;
  const sample = (index: number): number => {
    // Of 16 bits, the upper 8.
    if (depth >= 8) return line[(index * depth) / 8];
    const bit = index * depth;
    return (line[bit >> 3] >> (8 - depth - (bit & 7))) & largest;
  };
  const share = 255 / largest;
  for (let pixel = 0; 4 * pixel < data.length; pixel++) {
    const first = pixel * samples;
    if (palette) {
      const index = sample(first);
      for (let channel = 0; channel < 3; channel++) data[4 * pixel + channel] = palette[3 * index + channel];
      data[4 * pixel + 3] = alphas[index] ?? 255;
      continue;
    }
    for (let channel = 0; channel < 3; channel++) {
      data[4 * pixel + channel] = share * sample(first + (hasColors ? channel : 0));
    }
    data[4 * pixel + 3] = hasAlpha ? sample(first + samples - 1) : 255;
  }
}

/** Encodes an image as a PNG of 8 bits with alpha, without a colour profile. */
export async function encodePng(image: PixelImage): Promise<Blob> {
  const packed = await deflated(await inPieces(filtered(image, FILTERS.above)));
  const parts = [SIGNATURE, header(image.width, image.height), chunk('IDAT', packed), chunk('IEND', new Uint8Array())];
  return new Blob(parts, { type: 'image/png' });
}
