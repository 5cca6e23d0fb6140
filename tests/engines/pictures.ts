/** Pictures that came out of a page as base64, in Node. */
import { PNG } from 'pngjs';

export function pictureIn(base64: string): PNG {
  return PNG.sync.read(Buffer.from(base64, 'base64'));
}

/** How many colours a picture has: a blank one has one. */
export function colorsIn({ data }: PNG): number {
  const colors = new Set<number>();
  for (let at = 0; at < data.length; at += 4) colors.add(data.readUInt32LE(at));
  return colors.size;
}
