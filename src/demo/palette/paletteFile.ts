/** Reads palettes: GIMP, hex lists, JASC, paint.net, Lospec and Adobe Swatch Exchange. */
import { FileError } from '../../preset.ts';
import { strings } from '../strings.ts';
import { hexOfCielab, hexOfRgb } from './color.ts';
import { words } from './words.ts';

const { faults } = words;

/** Largest size of a file in bytes. */
export const MAX_BYTES = 1024 * 1024;
const MAX_COLORS = 1024;

/**
 * Reads a palette. The content decides on its format, because several formats share an extension.
 * @returns different colours as `#rrggbb`, in the order of the file
 * @throws FileError if the file is no palette, damaged or too large, or has fewer than two different colours
 */
export function readPalette(bytes: Uint8Array): string[] {
  if (bytes.length > MAX_BYTES) throw new FileError(strings.files.tooLarge(MAX_BYTES / 1024 / 1024));
  const colors = new Set(isAse(bytes) ? readAse(bytes) : readText(textOf(bytes)));
  if (colors.size > MAX_COLORS) throw new FileError(faults.tooMany(colors.size, MAX_COLORS));
  if (colors.size < 2) throw new FileError(colors.size === 0 ? faults.noColors : faults.oneColor([...colors][0]));
  return [...colors];
}

function textOf(bytes: Uint8Array): string {
  if (isAseprite(bytes)) throw new FileError(faults.sprite);
  const text = new TextDecoder().decode(bytes);
  // No text contains NUL.
  if (text.includes('\0')) throw new FileError(faults.notPalette);
  return text.trim();
}

function readText(text: string): string[] {
  if (text === '') throw new FileError(faults.empty);
  if (text.startsWith('{') || text.startsWith('[')) return readJson(text);
  const [first, ...rest] = text.split(/\r\n|\n|\r/).map((line) => line.trim());
  if (/^GIMP Palette$/i.test(first)) return readGimp(rest);
  if (/^JASC-PAL$/i.test(first)) return readJasc(rest);
  return readHex([first, ...rest]);
}

/** Lines `R G B name` after a header. Aseprite writes alpha as a fourth number, which is ignored. */
function readGimp(lines: readonly string[]): string[] {
  return lines.flatMap((line, at) => {
    if (line === '' || /^(#|Name:|Columns:|Channels:)/i.test(line)) return [];
    return [channelsOf(line, at + 2)];
  });
}

/** The version, the number of colours, then a line `R G B` for each. */
function readJasc([version, count, ...lines]: readonly string[]): string[] {
  if (version !== '0100' || !/^\d+$/.test(count ?? '')) throw new FileError(faults.jasc);
  const rows = lines.slice(0, Number(count));
  if (rows.length < Number(count)) throw new FileError(faults.fewer(Number(count), rows.length));
  return rows.map((line, at) => channelsOf(line, at + 4));
}

function channelsOf(line: string, number: number): string {
  const channels = /^(\d{1,3})\s+(\d{1,3})\s+(\d{1,3})(?:\s|$)/.exec(line)?.slice(1, 4).map(Number);
  if (!channels || Math.max(...channels) > 255) throw new FileError(faults.line(number, short(line), 'channels'));
  const [red, green, blue] = channels;
  return hexOfRgb(red / 255, green / 255, blue / 255);
}

/** A colour in each line: RRGGBB, or AARRGGBB as paint.net writes it, where `;` starts a comment. */
function readHex(lines: readonly string[]): string[] {
  return lines.flatMap((line, at) => {
    const text = line.replace(/;.*/, '').trim();
    if (text === '') return [];
    const [, alpha, color] = /^#?([0-9a-f]{2})?([0-9a-f]{6})$/i.exec(text) ?? [];
    // A text whose first line is no colour is no list of colours.
    if (color === undefined)
      throw new FileError(at === 0 ? faults.notPalette : faults.line(at + 1, short(line), 'hex'));
    return alpha === '00' ? [] : [`#${color.toLowerCase()}`];
  });
}

/** The answer of Lospec's interface: `{ "colors": ["rrggbb"] }`. */
function readJson(text: string): string[] {
  const { colors } = (parsed(text) ?? {}) as { colors?: unknown };
  if (!Array.isArray(colors)) throw new FileError(faults.notPalette);
  return colors.map((each: unknown, at) => {
    const [, color] = (typeof each === 'string' && /^#?([0-9a-f]{6})$/i.exec(each)) || [];
    if (color === undefined) throw new FileError(faults.entry(at + 1, short(JSON.stringify(each))));
    return `#${color.toLowerCase()}`;
  });
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new FileError(faults.json, { cause: error });
  }
}

/** The start of a text, for a message. */
function short(text: string): string {
  return text.length > 24 ? `${text.slice(0, 24)}\u2026` : text;
}

const ASE_SIGNATURE = 'ASEF';
const COLOR_BLOCK = 1;
/** Bytes of the header, and of the type and the length of a block. */
const [HEADER, BLOCK_HEAD] = [12, 6];
/** Number of values of a colour, and its conversion. Values are 0 to 1, except a and b of LAB. */
const MODELS: Readonly<Record<string, readonly [count: number, hexOf: (...values: number[]) => string]>> = {
  'RGB ': [3, (red, green, blue) => hexOfRgb(red, green, blue)],
  GRAY: [1, (grey) => hexOfRgb(grey, grey, grey)],
  CMYK: [4, (...inks) => hexOfRgb(...inksOnPaper(inks))],
  'LAB ': [3, (l, a, b) => hexOfCielab(100 * l, a, b)],
};

function isAse(bytes: Uint8Array): boolean {
  return signatureAt(bytes, 0) === ASE_SIGNATURE;
}

/** Aseprite's own files, which have the same extension. */
function isAseprite(bytes: Uint8Array): boolean {
  return bytes[4] === 0xe0 && bytes[5] === 0xa5;
}

function signatureAt(bytes: Uint8Array, at: number): string {
  return String.fromCharCode(...bytes.subarray(at, at + 4));
}

/**
 * Adobe Swatch Exchange, which Adobe has not documented: a header with the number of blocks, then blocks with their type
 * and their length. Blocks that start and end groups are skipped.
 */
function readAse(bytes: Uint8Array): string[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  if (bytes.length < HEADER) throw new FileError(faults.truncated);
  const count = view.getUint32(8);
  const colors: string[] = [];
  let at = HEADER;
  for (let block = 1; block <= count; block++) {
    const start = at + BLOCK_HEAD;
    if (start > bytes.length) throw new FileError(faults.truncatedAt(block, count));
    at = start + view.getUint32(at + 2);
    if (at > bytes.length) throw new FileError(faults.truncatedAt(block, count));
    if (view.getUint16(start - BLOCK_HEAD) === COLOR_BLOCK) colors.push(swatchOf(bytes.subarray(start, at), block));
  }
  return colors;
}

/** A name in UTF-16 after its length, a model of four letters, then its values. */
function swatchOf(block: Uint8Array, number: number): string {
  const view = new DataView(block.buffer, block.byteOffset, block.length);
  const damaged = new FileError(faults.block(number));
  if (block.length < 2) throw damaged;
  const at = 2 + 2 * view.getUint16(0);
  const model = signatureAt(block, at);
  const [count, hexOf] = MODELS[model.toUpperCase()] ?? [];
  if (count === undefined || hexOf === undefined || at + 4 * (count + 1) > block.length) throw damaged;
  const values = Array.from({ length: count }, (_, value) => view.getFloat32(at + 4 * (value + 1)));
  if (!values.every(Number.isFinite)) throw damaged;
  return hexOf(...values);
}

/** Without the colour profile, which the file does not have. */
function inksOnPaper([cyan, magenta, yellow, black]: readonly number[]): [number, number, number] {
  const [red, green, blue] = [cyan, magenta, yellow].map((ink) => (1 - ink) * (1 - black));
  return [red, green, blue];
}
