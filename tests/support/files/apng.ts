/** Decodes APNG files by the rules of the specification. Pixels of each frame are decoded by pngjs. */
import { crc32 } from 'node:zlib';
import { PNG } from 'pngjs';

const SIGNATURE = Buffer.of(137, 80, 78, 71, 13, 10, 26, 10);

export interface AnimatedPng {
  readonly width: number;
  readonly height: number;
  /** Number of plays, 0 for endless. */
  readonly plays: number;
  /** Seconds of each frame. */
  readonly delays: number[];
  /** What is shown: straight alpha, four bytes for each pixel. */
  readonly frames: Buffer[];
  /** Bytes of the rectangles that the frames draw. */
  readonly areas: number[];
}

interface Control {
  readonly [name: string]: number;
}

interface Part {
  readonly control: Control;
  readonly data: Buffer[];
}

/** @throws Error when the file violates the specification */
export function decodeApng(file: Buffer): AnimatedPng {
  const chunks = chunksOf(file);
  const header = chunks[0].content;
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  const [count, plays] = [0, 4].map((at) => chunks.find(({ kind }) => kind === 'acTL')!.content.readUInt32BE(at));
  const parts: Part[] = [];
  let sequence = 0;
  for (const { kind, content } of chunks) {
    if (kind === 'fcTL' || kind === 'fdAT') {
      if (content.readUInt32BE(0) !== sequence) throw new Error(`Chunk ${sequence} is out of order.`);
      sequence++;
    }
    if (kind === 'fcTL') parts.push({ control: controlOf(content), data: [] });
    if (kind === 'IDAT') parts.at(-1)!.data.push(content);
    if (kind === 'fdAT') parts.at(-1)!.data.push(content.subarray(4));
  }
  if (parts.length !== count) throw new Error(`The header says ${count} frames, the file has ${parts.length}.`);
  return {
    width,
    height,
    plays,
    delays: parts.map(({ control }) => control.numerator / control.denominator),
    frames: composed(parts, width, height, header),
    areas: parts.map(({ control }) => control.width * control.height),
  };
}

function chunksOf(file: Buffer): { kind: string; content: Buffer }[] {
  const chunks = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    const end = at + 8 + file.readUInt32BE(at);
    const kind = file.toString('latin1', at + 4, at + 8);
    if (crc32(file.subarray(at + 4, end)) !== file.readUInt32BE(end)) throw new Error(`${kind} has a wrong check.`);
    chunks.push({ kind, content: file.subarray(at + 8, end) });
  }
  return chunks;
}

function controlOf(content: Buffer): Control {
  const [width, height, x, y] = [4, 8, 12, 16].map((at) => content.readUInt32BE(at));
  const [numerator, denominator] = [20, 22].map((at) => content.readUInt16BE(at));
  return { width, height, x, y, numerator, denominator, dispose: content[24], blend: content[25] };
}

function composed(parts: readonly Part[], width: number, height: number, header: Buffer): Buffer[] {
  const canvas = Buffer.alloc(4 * width * height);
  return parts.map(({ control, data }) => {
    if (control.dispose !== 0) throw new Error('This decoder has no disposal.');
    if (control.x + control.width > width || control.y + control.height > height) throw new Error('Outside.');
    const pixels = pixelsOf(control, data, header);
    for (let row = 0; row < control.height; row++) {
      for (let column = 0; column < control.width; column++) {
        const from = 4 * (row * control.width + column);
        const to = 4 * ((control.y + row) * width + control.x + column);
        const pixel = pixels.subarray(from, from + 4);
        if (control.blend === 0) canvas.set(pixel, to);
        else canvas.set(over([...pixel], [...canvas.subarray(to, to + 4)]), to);
      }
    }
    return Buffer.from(canvas);
  });
}

function over([red, green, blue, alpha]: number[], below: number[]): number[] {
  if (alpha === 0) return below;
  const [u, v] = [alpha * 255, (255 - alpha) * below[3]];
  const mixed = [red, green, blue].map((value, at) => Math.round((value * u + below[at] * v) / (u + v)));
  return [...mixed, Math.round((u + v) / 255)];
}

/** As pngjs reads them in a still picture. */
function pixelsOf({ width, height }: Control, data: Buffer[], header: Buffer): Buffer {
  const size = Buffer.from(header);
  size.writeUInt32BE(width, 0);
  size.writeUInt32BE(height, 4);
  const chunks = [chunk('IHDR', size), chunk('IDAT', Buffer.concat(data)), chunk('IEND', Buffer.alloc(0))];
  return PNG.sync.read(Buffer.concat([SIGNATURE, ...chunks]), { checkCRC: true }).data;
}

function chunk(kind: string, content: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(kind, 'latin1'), content]);
  const numbers = Buffer.alloc(8);
  numbers.writeUInt32BE(content.length, 0);
  numbers.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([numbers.subarray(0, 4), body, numbers.subarray(4)]);
}
