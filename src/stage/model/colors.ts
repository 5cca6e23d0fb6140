/** One colour for each primitive: its base colour times the mean of its texture where its triangles are. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { FileImage, ModelFile, Primitive } from './modelFile.ts';
import { areaOf } from './solids.ts';

/** Pixels of an image, four bytes each, sRGB, from the top. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: ArrayLike<number>;
}

/** Decodes an image; undefined if it is damaged or too large. */
export type Decode = (image: FileImage) => Promise<Pixels | undefined>;

/** Samples of a texture for each primitive, at least, spread over its triangles. */
const SAMPLES = 2_000;
/** Pixels along a side of images that are decoded, and of the copies that are read. */
const [LARGEST, READ] = [8_192, 256];

/** The colours of all primitives. @param notices receives a sentence for images that cannot be decoded */
export async function colorsOf(file: ModelFile, decode: Decode, notices: Set<string>): Promise<Map<Primitive, Color>> {
  const decoded = new Map<number, Promise<Pixels | undefined>>();
  const pixelsOf = (image: number) => {
    const source = file.images[image];
    if (source && !decoded.has(image)) decoded.set(image, decode(source));
    return decoded.get(image);
  };
  const colors = new Map<Primitive, Color>();
  for (const primitive of file.meshes.flat()) {
    const { color, image } = file.materials[primitive.material] ?? { color: [1, 1, 1, 1], image: undefined };
    const pixels = image === undefined ? undefined : await pixelsOf(image);
    if (image !== undefined && file.images[image] && !pixels)
      notices.add('An image of the model cannot be decoded, so its colour is missing.');
    const mean = meanOf(primitive, pixels);
    colors.set(primitive, [0, 1, 2].map((part) => encoded(color[part] * mean[part])) as unknown as Color);
  }
  return colors;
}

/** Linear mean of texture and vertex colours over the triangles. */
function meanOf(primitive: Primitive, pixels: Pixels | undefined): number[] {
  const { indices, places, colors } = primitive;
  const texture = places && pixels;
  if (!texture && !colors) return [1, 1, 1];
  const sides = Math.max(1, Math.ceil(Math.sqrt(SAMPLES / (indices.length / 3))));
  const sum = [0, 0, 0, 0];
  for (let first = 0; first + 2 < indices.length; first += 3) {
    const corners = indices.subarray(first, first + 3);
    const weight = areaOf(primitive, corners) + 1e-12;
    for (let a = 0; a < sides; a++) {
      for (let b = 0; a + b < sides; b++) {
        const shares = [(a + 1 / 3) / sides, (b + 1 / 3) / sides];
        const at = (values: Float32Array, size: number, part: number) => {
          const [one, two, three] = [0, 1, 2].map((corner) => values[size * corners[corner] + part]);
          return (1 - shares[0] - shares[1]) * one + shares[0] * two + shares[1] * three;
        };
        const texel = texture ? texelOf(texture, at(places, 2, 0), at(places, 2, 1)) : [1, 1, 1];
        for (let part = 0; part < 3; part++) sum[part] += weight * texel[part] * (colors ? at(colors, 3, part) : 1);
        sum[3] += weight;
      }
    }
  }
  return [0, 1, 2].map((part) => sum[part] / sum[3]);
}

/** Linear colour at a place that repeats. */
function texelOf({ width, height, data }: Pixels, u: number, v: number): number[] {
  const at = (share: number, count: number) =>
    Math.min(count - 1, Math.floor((share - Math.floor(share)) * count)) || 0;
  const first = 4 * (at(v, height) * width + at(u, width));
  return [0, 1, 2].map((part) => decodedByte(data[first + part]));
}

function decodedByte(value: number): number {
  const share = value / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

function encoded(linear: number): number {
  const share = Math.min(Math.max(linear, 0), 1);
  return Math.round(255 * (share <= 0.0031308 ? 12.92 * share : 1.055 * share ** (1 / 2.4) - 0.055));
}

/** Decodes an image by the browser, smaller than it is. */
export async function decodeByBrowser(image: FileImage): Promise<Pixels | undefined> {
  const size = sizeOf(image);
  if (!size || !size.every((side) => side > 0 && side <= LARGEST)) return undefined;
  try {
    const scale = Math.min(1, READ / Math.max(...size));
    const [width, height] = size.map((side) => Math.max(1, Math.round(side * scale)));
    const blob = new Blob([image.bytes as Uint8Array<ArrayBuffer>], { type: image.type });
    const bitmap = await createImageBitmap(blob, {
      resizeWidth: width,
      resizeHeight: height,
      premultiplyAlpha: 'none',
    });
    const context = new OffscreenCanvas(width, height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    bitmap.close();
    return context.getImageData(0, 0, width, height);
  } catch {
    return undefined;
  }
}

/** Width and height as its header says, before anything is decoded. */
export function sizeOf({ bytes, type }: FileImage): readonly [number, number] | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (type === 'image/png') return bytes.length < 24 ? undefined : [view.getUint32(16), view.getUint32(20)];
  for (let at = 2; at + 9 < bytes.length && bytes[at] === 0xff;) {
    const marker = bytes[at + 1];
    // Start of a frame, except tables and restarts with numbers between.
    if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker))
      return [view.getUint16(at + 7), view.getUint16(at + 5)];
    at += 2 + view.getUint16(at + 2);
  }
  return undefined;
}
