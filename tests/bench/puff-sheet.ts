/** A contact sheet of the baked puffs: the four channels side by side on white paper. */
import { writeFileSync } from 'node:fs';
import { PNG } from 'pngjs';
import { channelSheet } from '../../src/renderer/puffs/billboards/channelSheet.ts';
import { bakePuffs } from '../../src/renderer/puffs/billboards/layers.ts';
import { LOBE_SHAPES } from '../../src/renderer/puffs/lobeShapes.ts';

/** Pixels: side of a puff's tile, and gap around the channels. */
const TILE = 256;
const GAP = 24;

/** Writes the sheet as a PNG. */
export function writeSheet(file: string): void {
  const channels = channelSheet(bakePuffs(LOBE_SHAPES), TILE);
  const panel = 2 * TILE;
  const sheet = new PNG({ width: channels.length * (panel + GAP) + GAP, height: panel + 2 * GAP });
  sheet.data.fill(255);
  channels.forEach(({ pixels, size }, index) => {
    const source = Object.assign(new PNG({ width: size, height: size }), { data: Buffer.from(pixels.buffer) });
    PNG.bitblt(source, sheet, 0, 0, size, size, GAP + index * (panel + GAP), GAP);
  });
  writeFileSync(file, PNG.sync.write(sheet));
}
