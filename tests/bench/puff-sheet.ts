/**
 * A contact sheet of the baked puffs, after Fig. 3 of the paper: the colour and alpha channels of the two textures as
 * four panels (N, d, C, coverage), each with the first four variations in two rows, as the shaders sample them.
 */
import { writeFileSync } from 'node:fs';
import { PNG } from 'pngjs';
import { bakePuffs, samplePuff, type PuffSample } from '../../src/puffs/layers.ts';
import { PUFF_SHAPES } from '../../src/puffs/shapes.ts';

type Color = [red: number, green: number, blue: number];

/** Pixels along each side of a puff's tile, and between panels. */
const TILE = 256;
const GAP = 24;
const PANEL = 2 * TILE;
const PAPER: Color = [255, 255, 255];
/** Width of the ring of ink in the coverage panel, in particle radii. */
const RING = 0.12;

/** What a panel shows of a sample; channels 0..1. */
type Panel = (sample: PuffSample, pad: number) => Color;

const grey = (value: number): Color => [value, value, value];
const isInside = ({ distance }: PuffSample): boolean => distance <= 0;

const PANELS: readonly Panel[] = [
  ({ normal: [x, y, z] }) => [(x + 1) / 2, (y + 1) / 2, (z + 1) / 2],
  ({ height }, pad) => grey(height / (2 * pad) + 0.5),
  (sample) => grey(isInside(sample) ? 1 : 0),
  ({ distance }) => grey(distance <= RING ? 1 : 0),
];

/** Writes the sheet as a PNG. */
export function writeSheet(file: string): void {
  const layers = bakePuffs(PUFF_SHAPES);
  const width = PANELS.length * (PANEL + GAP) + GAP;
  const png = new PNG({ width, height: PANEL + 2 * GAP });
  for (let pixel = 0; pixel < width * png.height; pixel++) png.data.set([...PAPER, 255], 4 * pixel);
  PANELS.forEach((panel, index) => {
    for (let layer = 0; layer < Math.min(4, layers.count); layer++) {
      const left = GAP + index * (PANEL + GAP) + (layer % 2) * TILE;
      const top = GAP + Math.floor(layer / 2) * TILE;
      drawTile(png, left, top, (x, y) => {
        const sample = samplePuff(layers, layer, x * layers.pad, y * layers.pad);
        // Beyond the silhouette the first texture repeats its border, which the paper's figure leaves black.
        return index < 2 && !isInside(sample) ? grey(0) : panel(sample, layers.pad);
      });
    }
  });
  writeFileSync(file, PNG.sync.write(png));
}

/** Draws a tile from `colorAt(x, y)`, x and y in -1..1, y up; the mean of four samples a pixel. */
function drawTile(png: PNG, left: number, top: number, colorAt: (x: number, y: number) => Color): void {
  const offsets = [0.25, 0.75];
  for (let row = 0; row < TILE; row++) {
    for (let column = 0; column < TILE; column++) {
      const sum: Color = [0, 0, 0];
      for (const dy of offsets) {
        for (const dx of offsets) {
          const color = colorAt((2 * (column + dx)) / TILE - 1, 1 - (2 * (row + dy)) / TILE);
          color.forEach((channel, i) => (sum[i] += channel / 4));
        }
      }
      const bytes = sum.map((channel) => Math.round(255 * channel));
      png.data.set(bytes, 4 * ((top + row) * png.width + left + column));
    }
  }
}
