/** Palettes in each format, and damaged ones. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { FileError } from '../../../../src/base/errors.ts';
import { MAX_BYTES, readPalette } from '../../../../src/demo/palette/paletteFile.ts';
import { aseOf, type AseBlock } from '../../../support/files/ase.ts';

const read = (text: string) => readPalette(new TextEncoder().encode(text));

/** A swatch of an .ase file. */
const swatch = (model: string, ...values: number[]): AseBlock => ({ name: 'A swatch', model, values });

describe('a palette is read', () => {
  it.each([
    ['GIMP', 'GIMP Palette\nName: Two\nColumns: 2\n# A comment\n255 136   0\tOrange\n  0   0  51 Night\n'],
    ['GIMP without names, with Windows line ends', 'GIMP Palette\r\n#\r\n255 136 0\r\n0 0 51\r\n'],
    ['GIMP by Aseprite, with alpha', 'GIMP Palette\nChannels: RGBA\n#\n255 136 0 255 Untitled\n0 0 51 128 Untitled\n'],
    ['hex', 'ff8800\n000033\n'],
    ['hex in capitals, with # and old Mac line ends', '#FF8800\r#000033'],
    ['JASC', 'JASC-PAL\r\n0100\r\n2\r\n255 136 0\r\n0 0 51\r\n'],
    ['JASC with alpha and more lines than colours', 'JASC-PAL\n0100\n2\n255 136 0 255\n0 0 51 255\n9 9 9 9\n'],
    ['paint.net', '; paint.net Palette File\n; Colors: 3\nFFFF8800\nFF000033 ; night\n00FFFFFF\n'],
    ['Lospec', '{"name":"Two","author":"","colors":["ff8800","000033"]}'],
    ['Lospec with #, and the same colour again', ' {"colors": ["#FF8800", "#000033", "ff8800"]}'],
    ['with a byte order mark', '\uFEFFff8800\n000033'],
  ])('%s', (_, text) => {
    expect(read(text)).toEqual(['#ff8800', '#000033']);
  });

  it('with a name in Latin-1', () => {
    const text = 'GIMP Palette\nName: Fl\u00fcgel\n255 136 0 Fl\u00fcgel\n0 0 51\n';
    expect(readPalette(Uint8Array.from(text, (letter) => letter.charCodeAt(0)))).toEqual(['#ff8800', '#000033']);
  });

  it('Adobe Swatch Exchange, in each colour model, without its groups', () => {
    const bytes = aseOf([
      'group',
      swatch('RGB ', 1, 136 / 255, 0),
      swatch('Gray', 0.2),
      swatch('CMYK', 1, 0, 0.5, 0.2),
      'end',
      swatch('LAB ', 0.462775, -47.5621, 48.5837),
      swatch('LAB ', 1, 0, 0),
      swatch('GRAY', 2),
    ]);
    // The web platform tests say that lab(46.2775% -47.5621 48.5837) is green.
    expect(readPalette(bytes)).toEqual(['#ff8800', '#333333', '#00cc66', '#008000', '#ffffff']);
  });

  it('from a part of a larger buffer', () => {
    const bytes = aseOf([swatch('Gray', 0), swatch('Gray', 1)]);
    const whole = new Uint8Array(bytes.length + 7);
    whole.set(bytes, 7);
    expect(readPalette(whole.subarray(7))).toEqual(['#000000', '#ffffff']);
  });
});

const TWO_SWATCHES = aseOf([swatch('RGB ', 1, 0, 0), swatch('RGB ', 0, 0, 1)]);
const changed = (at: number, ...bytes: number[]) => {
  const copy = TWO_SWATCHES.slice();
  copy.set(bytes, at);
  return copy;
};
/** Places in the first block: its length, the length of its name, its model and its first value. */
const [LENGTH, NAME, MODEL, VALUE] = [14, 18, 38, 42];

describe('a damaged palette is rejected with what is wrong', () => {
  it.each([
    ['empty', '', 'It is empty.'],
    ['of blank lines', '\n \r\n', 'It is empty.'],
    ['prose', 'Dear diary', 'It is not a palette. Use .gpl (GIMP)'],
    ['a binary', 'RIFF\0\0\0\0PAL data', 'It is not a palette.'],
    ['of comments only', '; paint.net\n;', 'It has no colours. A palette needs at least two.'],
    ['of one colour', 'ff8800\nFF8800', 'It has only one colour, #ff8800.'],
    ['a hex list with a word', 'ff8800\norange', 'Line 2 is “orange”, not a colour such as ff8800.'],
    ['a hex list with a long line', `ff8800\n${'f'.repeat(99)}`, `Line 2 is “${'f'.repeat(24)}…”`],
    ['a hex list with short colours', 'ff8800\nf80', 'Line 2 is “f80”'],
    ['GIMP without colours', 'GIMP Palette\n#\n', 'It has no colours.'],
    ['GIMP with two channels', 'GIMP Palette\n255 136 0\n0 51', 'Line 3 is “0 51”, not three numbers from 0 to 255.'],
    ['GIMP above 255', 'GIMP Palette\n255 256 0', 'Line 2 is “255 256 0”'],
    ['GIMP below 0', 'GIMP Palette\n255 -6 0', 'Line 2 is “255 -6 0”'],
    ['JASC of another version', 'JASC-PAL\n0200\n2\n0 0 0\n9 9 9', 'A JASC palette has the version 0100'],
    ['JASC without a number', 'JASC-PAL\n0100\n', 'A JASC palette has the version 0100'],
    ['JASC that ends early', 'JASC-PAL\n0100\n3\n0 0 0\n9 9 9', 'It ends after 2 of its 3 colours.'],
    ['JASC with a word', 'JASC-PAL\n0100\n2\n0 0 0\nblack', 'Line 5 is “black”'],
    ['JSON that is torn', '{"colors":["ff8800",', 'It is not valid JSON.'],
    ['JSON without colours', '{"name":"Two"}', 'It is not a palette.'],
    ['JSON with a number of colours', '{"colors":2}', 'It is not a palette.'],
    ['a list in JSON', '["ff8800","000033"]', 'It is not a palette.'],
    ['null in JSON', '{"colors":[null,"ff8800"]}', 'Colour 1 is null, not a text such as ff8800.'],
    ['a name in JSON', '{"colors":["ff8800","red"]}', 'Colour 2 is "red"'],
    ['markup in JSON', '{"colors":["<img src=x onerror=alert(1)>"]}', 'Colour 1 is "<img src=x onerror=aler…'],
  ])('%s', (_, text, message) => {
    expect(() => read(text)).toThrow(FileError);
    expect(() => read(text)).toThrow(message);
  });

  it.each([
    ['with a header alone', TWO_SWATCHES.slice(0, 9), 'It ends in its header.'],
    ['that ends in the head of a block', TWO_SWATCHES.slice(0, 15), 'It ends in block 1 of 2.'],
    ['that ends in a block', TWO_SWATCHES.slice(0, -1), 'It ends in block 2 of 2.'],
    ['with too many blocks', changed(8, 255, 255, 255, 255), 'It ends in block 3 of 4294967295.'],
    ['with too long a block', changed(LENGTH, 255, 255, 255, 255), 'It ends in block 1 of 2.'],
    ['with too short a block', changed(LENGTH, 0, 0, 0, 1), 'Block 1 is no colour in RGB, CMYK, LAB or grey.'],
    ['with too long a name', changed(NAME, 255, 255), 'Block 1 is no colour'],
    ['with another model', changed(MODEL, 72, 83, 86, 32), 'Block 1 is no colour'],
    ['with a value that is no number', changed(VALUE, 255, 255, 255, 255), 'Block 1 is no colour'],
    ['without blocks', aseOf([]), 'It has no colours.'],
    ['of one colour', aseOf([swatch('Gray', 1), swatch('RGB ', 1, 1, 1)]), 'It has only one colour, #ffffff.'],
    ['of Aseprite', Uint8Array.from([128, 0, 0, 0, 0xe0, 0xa5, 1, 0]), 'It is a sprite of Aseprite'],
  ])('.ase %s', (_, bytes, message) => {
    expect(() => readPalette(bytes)).toThrow(FileError);
    expect(() => readPalette(bytes)).toThrow(message);
  });

  it('of too many bytes or colours', () => {
    expect(() => readPalette(new Uint8Array(MAX_BYTES + 1))).toThrow('The file is too large. The limit is 1 MB.');
    const colors = Array.from({ length: 1025 }, (_, at) => at.toString(16).padStart(6, '0'));
    expect(() => read(colors.join('\n'))).toThrow('It has 1025 colours. The limit is 1024.');
    expect(read(colors.slice(1).join('\n'))).toHaveLength(1024);
  });
});

describe('whatever the bytes, the result is a list of colours or a FileError', () => {
  const expectHandled = (bytes: Uint8Array) => {
    try {
      const colors = readPalette(bytes);
      expect(colors.length).toBeGreaterThan(1);
      for (const color of colors) expect(color).toMatch(/^#[0-9a-f]{6}$/);
    } catch (error) {
      expect(error).toBeInstanceOf(FileError);
    }
  };

  it.each([
    ['.ase', TWO_SWATCHES],
    ['.gpl', new TextEncoder().encode('GIMP Palette\n1 2 3\n4 5 6\n')],
    ['.pal', new TextEncoder().encode('JASC-PAL\n0100\n2\n1 2 3\n4 5 6\n')],
    ['.json', new TextEncoder().encode('{"colors":["ff8800","000033"]}')],
  ])('%s with changed bytes', (_, bytes) => {
    const change = fc.tuple(fc.nat(bytes.length - 1), fc.nat(255));
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 4 }), fc.nat(bytes.length), (changes, length) => {
        const copy = bytes.slice(0, length);
        for (const [at, byte] of changes) if (at < length) copy[at] = byte;
        expectHandled(copy);
      }),
      { seed: 5, numRuns: 1500 },
    );
  });

  it('random bytes', () => {
    fc.assert(fc.property(fc.uint8Array({ maxLength: 200 }), expectHandled), { seed: 5, numRuns: 500 });
  });
});
