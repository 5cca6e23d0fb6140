/**
 * Images of puffs after Fig. 3 of McGuire and Fein (2006): the colour and alpha channels of the two textures, each with
 * four variations in two rows.
 */
import { samplePuff, type PuffLayers, type PuffSample } from './layers.ts';
import { meetLobes } from '../lobes.ts';
import { middleOf } from '../normals.ts';
import { softNormal } from '../softNormal.ts';
import { orientationOf, rotatedLobes } from '../orientation.ts';
import type { Lobe, PuffShape } from '../shapes.ts';

type Color = [red: number, green: number, blue: number];

/** An image in RGBA bytes, top row first. */
export interface ChannelPicture {
  /** Name of the channel: N, d, C or coverage. */
  readonly name: string;
  readonly size: number;
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
}

/** Width of the ink ring in the coverage image, in particle radii. */
const RING = 0.12;

/** Maps a sample to the colour of a channel, 0..1. */
interface Channel {
  readonly name: string;
  colorOf(sample: PuffSample, pad: number): Color;
}

const grey = (value: number): Color => [value, value, value];
const isInside = ({ distance }: PuffSample): boolean => distance <= 0;

// The first texture repeats its border outside the silhouette; the paper's figure shows black there.
const CHANNELS: readonly Channel[] = [
  {
    name: 'N',
    colorOf: (sample) => (isInside(sample) ? sample.normal.map((component) => (component + 1) / 2) : grey(0)) as Color,
  },
  {
    name: 'd',
    colorOf: (sample, pad) => grey(isInside(sample) ? sample.height / (2 * pad) + 0.5 : 0),
  },
  { name: 'C', colorOf: (sample) => grey(isInside(sample) ? 1 : 0) },
  { name: 'coverage', colorOf: ({ distance }) => grey(distance <= RING ? 1 : 0) },
];

/** A set of puffs to draw. */
interface Sampled {
  /** Number of variations. */
  readonly count: number;
  /** Half the width of a tile, in particle radii. */
  readonly pad: number;
  /** Samples a variation at a position in particle radii. */
  readonly sample: (variation: number, x: number, y: number) => PuffSample;
}

/**
 * Draws the channels of baked puffs.
 * @param tile pixels along each side of one puff; an image is two tiles wide and high
 */
export function channelSheet(layers: PuffLayers, tile: number): ChannelPicture[] {
  const { count, pad } = layers;
  return drawChannels({ count, pad, sample: (variation, x, y) => samplePuff(layers, variation, x, y) }, tile);
}

/**
 * Draws the same channels of lobe puffs, ray-traced per pixel.
 * @param roll rotation in radians about an axis that differs between variations
 * @param pad half the width of a tile, in particle radii
 * @param tile pixels along each side of one puff
 */
export function lobeSheet(shapes: readonly PuffShape[], roll: number, pad: number, tile: number): ChannelPicture[] {
  const views = shapes.map(({ lobes }, variation) => rotatedLobes(orientationOf(53 * variation + 20, roll), lobes));
  return drawChannels(
    { count: views.length, pad, sample: (variation, x, y) => sampleLobes(views[variation], x, y) },
    tile,
  );
}

function drawChannels(puffs: Sampled, tile: number): ChannelPicture[] {
  return CHANNELS.map((channel) => drawChannel(channel, puffs, tile));
}

function drawChannel(channel: Channel, { count, pad, sample }: Sampled, tile: number): ChannelPicture {
  const size = 2 * tile;
  const pixels = new Uint8ClampedArray(4 * size * size);
  for (let pixel = 0; pixel < size * size; pixel++) {
    const [column, row] = [pixel % size, Math.floor(pixel / size)];
    const variation = (Math.floor(column / tile) + 2 * Math.floor(row / tile)) % count;
    const color = meanColor((dx, dy) => {
      const x = (2 * ((column % tile) + dx)) / tile - 1;
      const y = 1 - (2 * ((row % tile) + dy)) / tile;
      return channel.colorOf(sample(variation, x * pad, y * pad), pad);
    });
    pixels.set([...color.map((value) => 255 * value), 255], 4 * pixel);
  }
  return { name: channel.name, size, pixels };
}

/** Mean colour of four samples per pixel. */
function meanColor(colorAt: (dx: number, dy: number) => Color): Color {
  const sum: Color = [0, 0, 0];
  for (const dy of [0.25, 0.75]) {
    for (const dx of [0.25, 0.75]) colorAt(dx, dy).forEach((value, index) => (sum[index] += value / 4));
  }
  return sum;
}

/** As {@link meetLobes}, with the unit shading normal. */
export function sampleLobes(lobes: readonly Lobe[], x: number, y: number): PuffSample {
  const hit = meetLobes(lobes, x, y);
  return { ...hit, normal: softNormal(lobes, middleOf(lobes), [x, y, hit.height]) };
}
