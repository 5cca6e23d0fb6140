/**
 * A contact sheet of puffs of lobes: a row per shape, in several orientations, with light from the upper left and with
 * ink, computed as in the body shader. First the hand-picked variations, then the minimum and maximum of each
 * parameter.
 */
import { writeFileSync } from 'node:fs';
import { PNG } from 'pngjs';
import { meetLobes } from '../../src/renderer/puffs/lobes.ts';
import { sampleLobes } from '../../src/renderer/puffs/billboards/channelSheet.ts';
import { DEFAULT_DESIGN, designedShapes } from '../../src/renderer/puffs/lobeShapes.ts';
import { orientationOf, rotatedLobes } from '../../src/renderer/puffs/orientation.ts';
import type { Lobe, PuffShape } from '../../src/renderer/puffs/shapes.ts';
import { dot, normalized } from '../../src/renderer/puffs/vector.ts';

type Color = readonly [red: number, green: number, blue: number];

/** Number of hand-picked variations. */
const CHOSEN = 12;
const TILE = 140;
const COLUMNS = 9;
/** Half the width of a tile, and the line width, in particle radii. */
const PAD = 1.1;
const RING = 0.045;
const TOWARDS_LIGHT = normalized([-0.5, 0.7, 0.55]);
const [PAPER, INK]: Color[] = [[255, 255, 255], [29, 23, 32]]; // prettier-ignore
/** The tones from shadow to light, and the N . L at which each begins. */
const TONES: readonly (readonly [number, Color])[] = [[-1, [144, 131, 173]], [0.3, [206, 189, 205]], [0.66, [246, 239, 226]]]; // prettier-ignore

function sheetShapes(): PuffShape[] {
  const ends = [
    { lumpiness: 0 },
    { lumpiness: 1 },
    { flatness: 1 },
    { roughness: 0 },
    { roughness: 1 },
    { lobes: 5 },
    { lobes: 12 },
    { seed: 1 },
  ];
  const varied = ends.flatMap((end) => designedShapes({ ...DEFAULT_DESIGN, ...end }, 1));
  return [...designedShapes(DEFAULT_DESIGN, CHOSEN), ...varied];
}

/** Writes the sheet as a PNG. */
export function writeSheet(file: string, shapes = sheetShapes()): void {
  const png = new PNG({ width: COLUMNS * TILE, height: shapes.length * TILE });
  shapes.forEach(({ lobes }, row) => {
    for (let column = 0; column < COLUMNS; column++) {
      const view = rotatedLobes(orientationOf((53 * column) % 256, column * 0.9), lobes);
      for (let pixel = 0; pixel < TILE * TILE; pixel++) {
        const [i, j] = [pixel % TILE, Math.floor(pixel / TILE)];
        const at = (row * TILE + j) * png.width + column * TILE + i;
        png.data.set([...pixelColor(view, i, j), 255], 4 * at);
      }
    }
  });
  writeFileSync(file, PNG.sync.write(png));
}

/** The mean of four samples per pixel. */
function pixelColor(view: readonly Lobe[], i: number, j: number): Color {
  const colors = [0, 1, 2, 3].map((corner) => {
    const x = i + 0.25 + 0.5 * (corner & 1);
    const y = j + 0.25 + 0.5 * (corner >> 1);
    return colorAt(view, PAD * ((2 * x) / TILE - 1), PAD * (1 - (2 * y) / TILE));
  });
  const mean = (channel: 0 | 1 | 2): number => Math.round(colors.reduce((sum, color) => sum + color[channel], 0) / 4);
  return [mean(0), mean(1), mean(2)];
}

function colorAt(view: readonly Lobe[], x: number, y: number): Color {
  const { distance } = meetLobes(view, x, y);
  if (distance > RING) return PAPER;
  if (distance > 0) return INK;
  const facing = dot(sampleLobes(view, x, y).normal, TOWARDS_LIGHT);
  return TONES.findLast(([from]) => facing >= from)?.[1] ?? TONES[0][1];
}
