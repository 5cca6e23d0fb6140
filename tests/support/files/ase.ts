/** A colour of an .ase file: its model and its values. */
export interface AseBlock {
  readonly name: string;
  readonly model: string;
  readonly values: readonly number[];
}

/** An Adobe Swatch Exchange file of colours and of the start and the end of groups. */
export function aseOf(blocks: readonly (AseBlock | 'group' | 'end')[]): Uint8Array {
  const bytes: number[] = [];
  const short = (value: number) => bytes.push(value >> 8, value & 255);
  const long = (value: number) => {
    short(value >>> 16);
    short(value & 0xffff);
  };
  const text = (letters: string) => bytes.push(...Array.from(letters, (letter) => letter.charCodeAt(0)));
  const named = (name: string) => {
    short(name.length + 1);
    for (const letter of name) short(letter.charCodeAt(0));
    short(0);
  };
  text('ASEF');
  long(0x10000);
  long(blocks.length);
  for (const block of blocks) {
    short(block === 'group' ? 0xc001 : block === 'end' ? 0xc002 : 1);
    const at = bytes.length;
    if (block === 'group') named('Group');
    else if (block !== 'end') {
      named(block.name);
      text(block.model);
      for (const value of block.values) {
        bytes.push(...new Uint8Array(new Float32Array([value]).buffer).toReversed());
      }
      short(2);
    }
    const length = bytes.length - at;
    bytes.splice(at, 0, length >>> 24, (length >> 16) & 255, (length >> 8) & 255, length & 255);
  }
  return Uint8Array.from(bytes);
}
