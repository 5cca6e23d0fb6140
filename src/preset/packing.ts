/** Long links: text to deflate-raw in base64url and back, with a limit that a deflate bomb cannot pass. */

/** Decoding stops here, in bytes. */
export const DECODED_LIMIT = 64 * 1024;

// One piece of input can grow a thousandfold before the stream can be stopped, so the pieces are small.
const PIECE = 256;

/** Deflates UTF-8 text; the result holds only letters, digits, `-` and `_`. */
export async function pack(text: string): Promise<string> {
  const bytes = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return toBase64Url(new Uint8Array(await new Response(bytes).arrayBuffer()));
}

/**
 * Inflates what `pack` made, at most DECODED_LIMIT bytes of it.
 * @returns the text, and whether it was cut at the limit
 * @throws when the text is no base64url or no deflated data
 */
export async function unpack(packed: string): Promise<{ text: string; isCut: boolean }> {
  const reader = inPieces(fromBase64Url(packed)).pipeThrough(new DecompressionStream('deflate-raw')).getReader();
  const decoder = new TextDecoder();
  let text = '';
  let room = DECODED_LIMIT;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return { text, isCut: false };
    text += decoder.decode(value.subarray(0, room), { stream: true });
    room -= value.length;
    if (room < 0) {
      await reader.cancel();
      return { text, isCut: true };
    }
  }
}

function inPieces(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at >= bytes.length) return controller.close();
      controller.enqueue(bytes.subarray(at, (at += PIECE)));
    },
  });
}

function toBase64Url(bytes: Uint8Array): string {
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function fromBase64Url(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}
