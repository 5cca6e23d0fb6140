/** Bytes as base64, for JSON. */
export function packed(bytes: Uint8Array): string {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

export async function packedFile(file: Blob): Promise<string> {
  return packed(new Uint8Array(await file.arrayBuffer()));
}
