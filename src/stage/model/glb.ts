/** Reads the container of a binary glTF 2.0 file and its accessors. Files may be hostile: everything is checked. */
import { FileError } from '../../base/errors.ts';

/** A value of the JSON of a file, of which nothing is known. */
export type Json = Readonly<Record<string, unknown>>;

/** Largest file, bytes. */
export const MAX_BYTES = 32 * 1024 * 1024;
/** Numbers of all accessors that are read. Accessors may share bytes or have none, so a small file could ask for more. */
const MAX_NUMBERS = 24_000_000;
const MAX_TEXT = 300;

const [MAGIC, JSON_CHUNK, BINARY_CHUNK] = [0x46546c67, 0x4e4f534a, 0x004e4942];
/** Numbers of an element by its type. */
const SIZES: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

type Read = (view: DataView, at: number) => number;
/** Bytes, reader and largest value of each component type. */
const COMPONENTS: Readonly<Record<number, readonly [bytes: number, read: Read, most: number]>> = {
  5120: [1, (view, at) => view.getInt8(at), 127],
  5121: [1, (view, at) => view.getUint8(at), 255],
  5122: [2, (view, at) => view.getInt16(at, true), 32_767],
  5123: [2, (view, at) => view.getUint16(at, true), 65_535],
  5125: [4, (view, at) => view.getUint32(at, true), 4_294_967_295],
  5126: [4, (view, at) => view.getFloat32(at, true), 1],
};

/** A number of the file in an error message, or a part of its text. */
export function shown(value: unknown): string {
  const text = typeof value === 'string' ? value : (JSON.stringify(value) ?? 'nothing');
  return text.length > MAX_TEXT ? `${text.slice(0, MAX_TEXT)}…` : text;
}

/** @throws FileError always */
export function refuse(fault: string): never {
  throw new FileError(`The model cannot be used: ${fault}`);
}

export function isObject(value: unknown): value is Json {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** The JSON of a file with what refers to its bytes. */
export class Glb {
  readonly json: Json;
  private readonly binary: Uint8Array | undefined;
  private readonly buffers = new Map<number, Uint8Array>();
  private readonly lists = new Map<string, readonly Json[]>();
  private numbers = 0;

  /** @throws FileError for a file that is no GLB of version 2, or too large */
  constructor(bytes: Uint8Array) {
    if (!(bytes instanceof Uint8Array)) refuse('it is not a Uint8Array.');
    if (bytes.byteLength > MAX_BYTES)
      refuse(`the file has ${(bytes.byteLength / 2 ** 20).toFixed(1)} MB. At most 32 MB are accepted.`);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.byteLength < 20 || view.getUint32(0, true) !== MAGIC)
      refuse('the file is not a GLB file. Export the model as glTF Binary (.glb).');
    const version = view.getUint32(4, true);
    if (version !== 2) refuse(`the file has version ${version} of glTF. Only version 2 is accepted.`);
    const chunks = chunksOf(bytes, view);
    const text = chunks.get(JSON_CHUNK);
    if (!text) refuse('the file has no JSON.');
    this.binary = chunks.get(BINARY_CHUNK);
    this.json = jsonOf(text);
  }

  /** Objects of a list of the JSON; none if it is absent. @throws FileError for more than `most`, or for other values */
  list(name: string, most = 100_000): readonly Json[] {
    const known = this.lists.get(name);
    if (known) return known;
    const values = this.json[name] ?? [];
    if (!Array.isArray(values) || !values.every(isObject)) return refuse(`${name} is not a list of objects.`);
    if (values.length > most) refuse(`it has ${values.length} ${name}. At most ${most} are accepted.`);
    this.lists.set(name, values);
    return values;
  }

  /** An object of a list by its index. */
  at(name: string, index: unknown): Json {
    const list = this.list(name);
    if (!isIndex(index, list.length)) refuse(`${shown(index)} is no index of ${name}, which has ${list.length}.`);
    return list[index];
  }

  /** The bytes of a buffer view, and its stride, 0 if it has none. */
  bytesOf(index: unknown): { bytes: Uint8Array; stride: number } {
    const { buffer, byteOffset = 0, byteLength, byteStride = 0, extensions } = this.at('bufferViews', index);
    if (isObject(extensions) && 'EXT_meshopt_compression' in extensions) refuse(COMPRESSED('meshopt'));
    const whole = this.bufferOf(buffer);
    if (!isIndex(byteOffset, whole.length + 1) || !isIndex(byteLength, whole.length - byteOffset + 1))
      refuse(`buffer view ${shown(index)} is not within its buffer.`);
    if (byteStride !== 0 && !isIndex(byteStride, 253)) refuse(`buffer view ${shown(index)} has an invalid stride.`);
    return { bytes: whole.subarray(byteOffset, byteOffset + byteLength), stride: byteStride };
  }

  /**
   * The numbers of an accessor, with normalised integers as fractions.
   * @param types accepted types of its elements
   * @param isNormalized whether integers that are not marked as normalised are accepted as they are
   * @throws FileError for numbers that are not finite, or outside the file
   */
  accessor(index: unknown, ...types: readonly string[]): { values: Float32Array | Uint32Array; size: number } {
    const { bufferView, byteOffset = 0, componentType, count, type, normalized, sparse } = this.at('accessors', index);
    const what = `accessor ${shown(index)}`;
    const component = Object.hasOwn(COMPONENTS, String(componentType)) && COMPONENTS[componentType as number];
    if (!component) return refuse(`${what} has an unknown component type.`);
    if (typeof type !== 'string' || !types.includes(type)) refuse(`${what} has the type ${shown(type)}.`);
    const size = SIZES[type];
    if (!isIndex(count, MAX_NUMBERS) || count === 0) refuse(`${what} has ${shown(count)} elements.`);
    this.numbers += count * size;
    if (this.numbers > MAX_NUMBERS) refuse('it has too much data.');
    const isWhole = componentType === 5125 || (componentType !== 5126 && !normalized);
    const values =
      isWhole && componentType !== 5120 && componentType !== 5122
        ? new Uint32Array(count * size)
        : new Float32Array(count * size);
    const scale = normalized ? component[2] : 1;
    const inOrder = (element: number) => element;
    const copy = (view: unknown, offset: unknown, elements: number, to: (element: number) => number, where: string) => {
      const { bytes, stride } = this.bytesOf(view);
      const [width, read] = component;
      const step = stride || width * size;
      if (!isIndex(offset, bytes.length + 1) || offset + step * (elements - 1) + width * size > bytes.length)
        refuse(`${where} is not within its buffer view.`);
      const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
      const isPlain = componentType === 5126 && step === width * size && to === inOrder && !normalized;
      if (isPlain) {
        const whole = values as Float32Array;
        for (let at = 0; at < whole.length; at++) {
          whole[at] = data.getFloat32(offset + width * at, true);
          if (!Number.isFinite(whole[at])) refuse(`${what} has a number that is not finite.`);
        }
        return;
      }
      for (let element = 0; element < elements; element++) {
        const first = size * to(element);
        for (let part = 0; part < size; part++) {
          const value = read(data, offset + step * element + width * part) / scale;
          if (!Number.isFinite(value)) refuse(`${what} has a number that is not finite.`);
          values[first + part] = normalized ? Math.max(value, -1) : value;
        }
      }
    };
    if (bufferView !== undefined) copy(bufferView, byteOffset, count, inOrder, what);
    if (sparse !== undefined) this.replaceSparse(sparse, count, what, copy);
    return { values, size };
  }

  private replaceSparse(
    sparse: unknown,
    count: number,
    what: string,
    copy: (view: unknown, offset: unknown, elements: number, to: (element: number) => number, where: string) => void,
  ): void {
    if (!isObject(sparse) || !isObject(sparse.indices) || !isObject(sparse.values))
      return refuse(`${what} has an invalid sparse part.`);
    const { indices, values } = sparse;
    const width = COMPONENTS[indices.componentType as number]?.[0];
    if (!isIndex(sparse.count, count + 1) || ![5121, 5123, 5125].includes(indices.componentType as number))
      return refuse(`${what} has an invalid sparse part.`);
    const { bytes } = this.bytesOf(indices.bufferView);
    const { byteOffset: from = 0 } = indices;
    if (!isIndex(from, bytes.length + 1) || from + width * sparse.count > bytes.length)
      return refuse(`${what} has a sparse part that is not within its buffer view.`);
    const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const read = COMPONENTS[indices.componentType as number][1];
    const to = (element: number) => {
      const at = read(data, from + width * element);
      return at < count ? at : refuse(`${what} has a sparse part that replaces element ${at}.`);
    };
    copy(values.bufferView, values.byteOffset ?? 0, sparse.count, to, `the sparse part of ${what}`);
  }

  private bufferOf(index: unknown): Uint8Array {
    const { uri, byteLength } = this.at('buffers', index);
    const known = this.buffers.get(index as number);
    if (known) return known;
    const whole = uri === undefined ? index === 0 && this.binary : embedded(uri);
    if (whole === undefined)
      refuse(`its data is in another file, ${shown(uri)}. Export the model as glTF Binary (.glb), which contains all.`);
    if (!whole || !isIndex(byteLength, whole.length + 1)) return refuse(`buffer ${shown(index)} lacks bytes.`);
    const bytes = whole.subarray(0, byteLength);
    this.buffers.set(index as number, bytes);
    return bytes;
  }
}

/** What to do with a compressed file. */
export const COMPRESSED = (kind: string): string =>
  `it is compressed with ${kind}, which is not supported. Export it without compression, or convert it with npx @gltf-transform/cli copy in.glb out.glb.`;

export function isIndex(value: unknown, count: number): value is number {
  return Number.isInteger(value) && (value as number) >= 0 && (value as number) < count;
}

/** The bytes of a URI with the data itself; undefined for another address, which is never fetched. */
export function embedded(uri: unknown): Uint8Array | undefined {
  const [, packed] = (typeof uri === 'string' && /^data:[^,]*;base64,(.*)$/s.exec(uri)) || [];
  if (packed === undefined) return undefined;
  try {
    return Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  } catch {
    return refuse('its embedded data is damaged.');
  }
}

function chunksOf(bytes: Uint8Array, view: DataView): Map<number, Uint8Array> {
  const chunks = new Map<number, Uint8Array>();
  const length = view.getUint32(8, true);
  if (length > bytes.byteLength) refuse(`the file is cut off: ${bytes.byteLength} of ${length} bytes are there.`);
  for (let at = 12; at + 8 <= length;) {
    const [size, type] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    if (at + 8 + size > length) refuse('the file is damaged: a chunk is longer than the file.');
    if (!chunks.has(type)) chunks.set(type, bytes.subarray(at + 8, at + 8 + size));
    at += 8 + size;
  }
  return chunks;
}

function jsonOf(text: Uint8Array): Json {
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder().decode(text));
  } catch {
    return refuse('its JSON is damaged.');
  }
  return isObject(json) ? json : refuse('its JSON is no object.');
}
