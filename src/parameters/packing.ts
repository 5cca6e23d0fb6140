/** Compression of long links and takes: deflate-raw in base64url, with a size limit against decompression bombs. */

/** Maximum decompressed size of a link, in bytes. */
export const DECODED_LIMIT = 64 * 1024;

// A chunk can expand a thousandfold before the stream can be cancelled, so input chunks are small: at most this, in bytes,
// or a 1024th of the limit.
const PIECE = 256;
/** Bytes that become text at once. */
const SLICE = 8192;

/** Decompressed bytes, and whether they were truncated at the limit. */
export interface Inflated {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly isCut: boolean;
}

/** Compresses text as UTF-8. The result contains only letters, digits, `-` and `_`. */
export function pack(text: string): Promise<string> {
  return packBytes(new TextEncoder().encode(text));
}

/** Compresses bytes. The result contains only letters, digits, `-` and `_`. */
export async function packBytes(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const deflated = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return toBase64Url(new Uint8Array(await new Response(deflated).arrayBuffer()));
}

/**
 * Decompresses the result of {@link pack}, at most DECODED_LIMIT bytes.
 * @throws if the text is not base64url or not deflate data
 */
export async function unpack(packed: string): Promise<{ text: string; isCut: boolean }> {
  const { bytes, isCut } = await unpackBytes(packed, DECODED_LIMIT);
  return { text: new TextDecoder().decode(bytes), isCut };
}

/**
 * Decompresses the result of {@link packBytes}, at most `limit` bytes.
 * @throws if the text is not base64url or not deflate data
 */
export async function unpackBytes(packed: string, limit: number): Promise<Inflated> {
  const reader = inPieces(fromBase64Url(packed), Math.max(PIECE, limit / 1024))
    .pipeThrough(new DecompressionStream('deflate-raw'))
    .getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let left = limit;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return { bytes: joined(parts), isCut: false };
    parts.push(value.subarray(0, left));
    left -= value.length;
    if (left < 0) {
      await reader.cancel();
      return { bytes: joined(parts), isCut: true };
    }
  }
}

function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function inPieces(bytes: Uint8Array<ArrayBuffer>, size: number): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at >= bytes.length) return controller.close();
      controller.enqueue(bytes.subarray(at, (at += size)));
    },
  });
}

function toBase64Url(bytes: Uint8Array): string {
  const slices = Array.from({ length: Math.ceil(bytes.length / SLICE) }, (_, index) =>
    String.fromCharCode(...bytes.subarray(SLICE * index, SLICE * (index + 1))),
  );
  return btoa(slices.join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function fromBase64Url(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}
