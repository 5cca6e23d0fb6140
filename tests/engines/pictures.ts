/** Pictures from a page, in base64, decoded in Node. */
import { PNG } from 'pngjs';

export function pictureIn(base64: string): PNG {
  return PNG.sync.read(Buffer.from(base64, 'base64'));
}

/** Number of colours of a picture; a blank one has a single colour. */
export function colorsIn({ data }: Pick<PNG, 'data'>): number {
  const colors = new Set<number>();
  for (let at = 0; at < data.length; at += 4) colors.add(data.readUInt32LE(at));
  return colors.size;
}
