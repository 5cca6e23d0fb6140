/** Puff sheets: what is written is what is read, whatever else artists save is read or refused with a reason. */
import { createHash } from 'node:crypto';
import { beforeAll, describe, expect, test } from 'vitest';
import { ShapeError } from '../../../../src/base/errors.ts';
import { finished } from '../../../../src/base/work.ts';
import { bakingBillboards } from '../../../../src/renderer/billboards.ts';
import {
  bakePuffs,
  rasterisingShape,
  samplePuff,
  type PuffLayers,
} from '../../../../src/renderer/puffs/billboards/layers.ts';
import { PUFF_PAD } from '../../../../src/renderer/puffs/billboards/rasterise.ts';
import { billboardShapes } from '../../../../src/renderer/puffs/billboards/sides.ts';
import { fitPuff } from '../../../../src/renderer/puffs/fit/fitPuff.ts';
import { reachOf, requireShapes } from '../../../../src/renderer/puffs/lobes.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { keyOf, type PixelImage, type PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { readPuffSheet } from '../../../../src/renderer/puffs/sheet/readPuffSheet.ts';
import type { PackedPuffs, PuffTextures } from '../../../../src/renderer/puffs/sheet/sheet.ts';
import { writePuffSheet } from '../../../../src/renderer/puffs/sheet/writePuffSheet.ts';
import { halves, torus } from '../../../visual/puffMeshes.ts';

type Pixel = readonly [red: number, green: number, blue: number, alpha: number];

function image(width: number, pixelAt: (x: number, y: number) => Pixel, height = width): PixelImage {
  const data = new Uint8ClampedArray(4 * width * height);
  for (let at = 0; at < width * height; at++) data.set(pixelAt(at % width, Math.floor(at / width)), 4 * at);
  return { width, height, data };
}

/** Pixels from 0 to 1 of a disc in the middle of each of the tiles. */
const outFrom = (tile: number, radius: number) => (x: number, y: number) =>
  Math.hypot((x % tile) + 0.5 - tile / 2, (y % tile) + 0.5 - tile / 2) / radius;

/** As hashes, because comparing arrays of this length takes seconds. */
function bytesOf({ normalDepth, colorCoverage }: PuffLayers): string[] {
  return [normalDepth, colorCoverage].map((each) => createHash('sha256').update(each).digest('hex'));
}

/** A sheet of discs that face the viewer, at depth 0. */
function discs(tile: number, tiles: 1 | 2, radius = tile / 3): PuffTextures {
  const out = outFrom(tile, radius);
  return {
    normalDepth: image(tile * tiles, () => [128, 128, 255, 128]),
    colorCoverage: image(tile * tiles, (x, y) => [255, 255, 255, out(x, y) < 1 ? 255 : 0]),
  };
}

let shapes: PuffShape[];
beforeAll(async () => {
  const painted = await fitPuff(halves([1, 0.8, 0.2], [0.2, 0.4, 1]), { lobes: 3 });
  const ring = await fitPuff(torus(), { lobes: 8 });
  shapes = [...LOBE_SHAPES.slice(0, 2), painted.shape, ring.shape];
});

describe('what is written is read', () => {
  for (const size of [64, 128, 200, 256]) {
    test(`N, d, C and coverage, to half a step of a byte, from tiles of ${size} pixels`, async () => {
      const read = await readPuffSheet(await writePuffSheet(shapes, { size }));
      expect(read).toHaveLength(4);
      for (const [index, shape] of billboardShapes(shapes).entries()) {
        const raster = finished(rasterisingShape(shape, size));
        const { normals, depths, mask, colors, pad, size: side } = read[index].sheet!;
        expect([side, pad]).toEqual([size, PUFF_PAD]);
        // Only the ball is painted.
        expect(colors !== undefined).toBe(index === 2);
        const worst = { normal: 0, depth: 0, color: 0, mask: 0 };
        for (let texel = 0; texel < size * size; texel++) {
          const own = (size - 1 - Math.floor(texel / size)) * size + (texel % size);
          let covered = 0;
          for (let cell = 0; cell < 16; cell++) {
            const [x, y] = [4 * (own % size) + (cell % 4), 4 * Math.floor(own / size) + Math.floor(cell / 4)];
            covered += raster.coverage[4 * size * y + x] / 16;
          }
          worst.mask = Math.max(worst.mask, Math.abs(mask[texel] - covered));
          if (covered === 0) continue;
          worst.depth = Math.max(worst.depth, Math.abs(depths[texel] - raster.depths[own]));
          for (let axis = 0; axis < 3; axis++) {
            const off = Math.abs(normals[3 * texel + axis] - raster.normals[3 * own + axis]);
            worst.normal = Math.max(worst.normal, off);
            const color = colors ? Math.abs(colors[3 * texel + axis] - raster.colors![3 * own + axis]) : 0;
            worst.color = Math.max(worst.color, color);
          }
        }
        expect(worst.mask).toBeLessThan(0.502 / 255);
        expect(worst.depth).toBeLessThan(0.502 / 255);
        expect(worst.color).toBeLessThan(0.502 / 255);
        // A step of a component is 2 / 255; the unit length divides the rounding of all three.
        expect(worst.normal).toBeLessThan(1.8 / 255);
      }
    });
  }

  // Half a step of a byte is 0.0053 radii. Tiles of other sizes than the layers have other samples where a lobe ends in
  // front of another one, and tiles of the same size have one value of coverage where layers have 16 cells.
  for (const [size, height, distance] of [
    [128, 0.006, 0.9],
    [256, 0.02, 0.3],
  ]) {
    test(`the baked puffs from tiles of ${size} pixels`, async () => {
      const read = await readPuffSheet(await writePuffSheet(shapes, { size }));
      const [own, other] = [shapes, read].map((each) => bakePuffs(billboardShapes(each)));
      const texel = (2 * PUFF_PAD) / own.size;
      const found = { cosine: 1, height: 0, distance: 0, count: 0 };
      for (let layer = 0; layer < 4; layer++) {
        for (let at = 0; at < own.size ** 2; at++) {
          const [x, y] = [at % own.size, Math.floor(at / own.size)].map((cell) => (cell + 0.5) * texel - PUFF_PAD);
          const [a, b] = [own, other].map((layers) => samplePuff(layers, layer, x, y));
          found.distance = Math.max(found.distance, Math.abs(a.distance - b.distance));
          if (Math.max(a.distance, b.distance) > -texel) continue;
          found.count++;
          found.cosine = Math.min(
            found.cosine,
            a.normal.reduce((sum, n, axis) => sum + n * b.normal[axis], 0),
          );
          // Along the normal, because the surface is steep near a rim.
          found.height = Math.max(found.height, Math.abs(a.height - b.height) * a.normal[2]);
        }
      }
      console.log(
        `tiles of ${size}: cosine ${found.cosine.toFixed(4)}, height ${found.height.toFixed(4)}, distance ${(found.distance / texel).toFixed(2)} texels`,
      );
      expect(found.count).toBeGreaterThan(19_000);
      expect(found.cosine).toBeGreaterThan(0.998);
      expect(found.height).toBeLessThan(height);
      expect(found.distance).toBeLessThan(distance * texel);
    });
  }
});

test('a light-rim-depth-mask sheet has the normals of its depth', async () => {
  const radius = 90;
  const out = outFrom(256, radius);
  const ball = (x: number, y: number) => Math.sqrt(Math.max(0, 1 - out(x, y) ** 2));
  const sheet = { lightRimDepthMask: image(256, (x, y) => [9, 200, 255 * ball(x, y), out(x, y) < 1 ? 255 : 0]) };
  const [{ sheet: tile, lobes }] = await readPuffSheet(sheet);
  expect(tile!.colors).toBeUndefined();
  expect(lobes).toHaveLength(1);
  const covered = Array.from({ length: 256 * 256 }, (_, at) => [at % 256, Math.floor(at / 256)] as const).filter(
    ([x, y]) => out(x, y) < 1,
  );
  const far = Math.min(...covered.map(([x, y]) => ball(x, y)));
  let worst = 1;
  for (let texel = 0; texel < 256 * 256; texel++) {
    const [x, y] = [texel % 256, Math.floor(texel / 256)];
    if (out(x, y) > 0.9) continue;
    const exact = [(x - 127.5) / radius, (127.5 - y) / radius, ball(x, y)];
    worst = Math.min(
      worst,
      exact.reduce((sum, n, axis) => sum + n * tile!.normals[3 * texel + axis], 0),
    );
    // The farthest depth becomes the centre plane, and the nearest one is as high as the radius.
    const height = ((radius / 256) * (ball(x, y) - far)) / (1 - far);
    expect(Math.abs(tile!.depths[texel] - height)).toBeLessThan(0.002);
  }
  console.log(`worst normal of a ball by its depth: ${((Math.acos(worst) * 180) / Math.PI).toFixed(1)} degrees`);
  expect(worst).toBeGreaterThan(Math.cos((5 * Math.PI) / 180));
  const [flatter] = await readPuffSheet(sheet, { relief: 0.1 });
  expect(flatter.sheet!.depths[128 * 256 + 128]).toBeCloseTo(0.1, 2);
});

test('the normals of a slope are the same up to its outline, whatever the depth beyond it is', async () => {
  const out = outFrom(64, 25);
  // Rises to the right by two steps of a byte for each pixel.
  const lightRimDepthMask = image(64, (x, y) => [0, 0, out(x, y) < 1 ? 60 + 2 * x : 0, out(x, y) < 1 ? 255 : 0]);
  const [{ sheet }] = await readPuffSheet({ lightRimDepthMask }, { relief: 1 });
  const slope = (2 / 255) * 64;
  const exact = [-slope, 0, 1].map((axis) => axis / Math.hypot(slope, 1));
  for (let texel = 0; texel < 64 * 64; texel++) {
    if (sheet!.mask[texel] < 0.5) continue;
    exact.forEach((axis, at) => expect(Math.abs(sheet!.normals[3 * texel + at] - axis)).toBeLessThan(1e-3));
  }
});

describe('orientation', () => {
  test('tiles are in reading order, row 0 at the top; empty tiles are left out', async () => {
    const out = outFrom(32, 10);
    const colors = [[255, 0, 0], [0, 255, 0], [0, 0, 0], [0, 0, 255]]; // prettier-ignore
    const read = await readPuffSheet({
      normalDepth: image(64, () => [128, 128, 255, 128]),
      colorCoverage: image(64, (x, y) => {
        const tile = Math.floor(x / 32) + 2 * Math.floor(y / 32);
        return [...(colors[tile] as [number, number, number]), out(x, y) < 1 && tile !== 2 ? 255 : 0];
      }),
    });
    const middles = read.map(({ sheet }) => [...sheet!.colors!.subarray(3 * (16 * 32 + 16), 3 * (16 * 32 + 17))]);
    expect(middles).toEqual([[1, 0, 0], [0, 1, 0], [0, 0, 1]]); // prettier-ignore
  });

  test('green points as the slopes of the depth show, unless the sheet says otherwise', async () => {
    const { normalDepth, colorCoverage } = await writePuffSheet(shapes, { size: 64 });
    const flipped = normalDepth.data.map((byte, at) => (at % 4 === 1 ? 255 - byte : byte));
    const down = { normalDepth: { ...normalDepth, data: flipped }, colorCoverage };
    const [own, found, given] = await Promise.all([
      readPuffSheet({ normalDepth, colorCoverage }),
      readPuffSheet(down),
      readPuffSheet(down, { green: 'up' }),
    ]).then((sheets) => sheets.map((read) => bytesOf(bakePuffs(billboardShapes(read)))));
    expect(found).toEqual(own);
    expect(given).not.toEqual(own);
  });

  test('the upper half of a tile is baked at the top, where green points up unless the sheet says down', async () => {
    const { colorCoverage } = discs(32, 1);
    const normalDepth = image(32, (_, y) => (y < 16 ? [128, 230, 203, 160] : [128, 128, 255, 128]));
    for (const green of ['up', 'down'] as const) {
      const layers = bakePuffs(billboardShapes(await readPuffSheet({ normalDepth, colorCoverage }, { green })));
      const [above, below] = [0.4, -0.4].map((y) => samplePuff(layers, 0, 0, y));
      expect(Math.sign(above.normal[1])).toBe(green === 'up' ? 1 : -1);
      expect(Math.abs(above.normal[1])).toBeCloseTo(0.8, 1);
      expect(above.height).toBeCloseTo((160 / 255 - 0.5) * 2 * PUFF_PAD, 1);
      expect(below.normal[2]).toBeCloseTo(1);
      expect(below.height).toBeCloseTo(0, 1);
    }
  });

  test('one tile fills an image whose middle is covered, unless the caller says otherwise', async () => {
    expect(await readPuffSheet(discs(64, 1))).toHaveLength(1);
    expect(await readPuffSheet(discs(64, 2))).toHaveLength(4);
    expect(await readPuffSheet(discs(64, 2), { tiles: 1, name: 'whole' })).toMatchObject([{ name: 'whole 1' }]);
  });
});

test('what is transparent does not matter: black or noise there changes nothing', async () => {
  const { normalDepth, colorCoverage } = await writePuffSheet(shapes, { size: 96 });
  const hide = (
    { width, height, data }: PixelImage,
    value: (at: number) => number,
    keepAlpha: boolean,
  ): PixelImage => ({
    width,
    height,
    data: data.map((byte, at) => (colorCoverage.data[at | 3] > 0 || (keepAlpha && at % 4 === 3) ? byte : value(at))),
  });
  const [plain, ...others] = await Promise.all(
    [undefined, () => 0, (at: number) => (7919 * at) % 256].map(async (value) => {
      const sheet = value && {
        normalDepth: hide(normalDepth, value, false),
        colorCoverage: hide(colorCoverage, value, true),
      };
      return bakePuffs(billboardShapes(await readPuffSheet(sheet ?? { normalDepth, colorCoverage })));
    }),
  );
  for (const other of others) expect(bytesOf(other)).toEqual(bytesOf(plain));
});

test('a tile that is covered up to its corners shrinks into the unit ball, with its lobes and its relief', async () => {
  const full = {
    normalDepth: image(64, () => [128, 128, 255, 204]),
    colorCoverage: image(64, () => [200, 100, 50, 255]),
  };
  const [shape] = await readPuffSheet(full);
  const layers = bakePuffs(billboardShapes([shape]));
  const reach = 1 / Math.hypot(0.3, Math.SQRT1_2);
  expect(layers.figures[0].outerRadius).toBeCloseTo(reach * Math.SQRT1_2, 1);
  expect(samplePuff(layers, 0, 0, 0).height).toBeCloseTo(0.3 * reach, 2);
  expect(samplePuff(layers, 0, 0.45 * reach, 0.45 * reach).distance).toBeLessThan(0);
  expect(samplePuff(layers, 0, 0.55 * reach, 0).distance).toBeGreaterThan(0);
  expect(() => requireShapes([shape])).not.toThrow();
});

test('lobes are in the mask and in the unit ball, and cover most of it, of a ring less', async () => {
  const read = await readPuffSheet(await writePuffSheet(shapes));
  requireShapes(read);
  const layers = bakePuffs(billboardShapes(read));
  for (const [layer, { lobes }] of read.entries()) {
    expect(reachOf(lobes)).toBeLessThanOrEqual(1.0001);
    let [covered, met, beyond] = [0, 0, 0];
    for (let at = 0; at < 100 * 100; at++) {
      const [x, y] = [at % 100, Math.floor(at / 100)].map((cell) => (cell + 0.5) / 50 - 1);
      const isCovered = samplePuff(layers, layer, x, y).distance < 0;
      const isMet = lobes.some(({ center, radius }) => Math.hypot(x - center[0], y - center[1]) < radius);
      if (isCovered) covered++;
      if (isCovered && isMet) met++;
      if (isMet && !isCovered) beyond++;
    }
    console.log(`lobes cover ${((100 * met) / covered).toFixed(0)} % of layer ${layer}`);
    expect(beyond).toBe(0);
    expect(met).toBeGreaterThan((layer === 3 ? 0.7 : 0.9) * covered);
  }
});

test('all sides of a puff of a sheet are its front, and each sheet has a key of its own', async () => {
  const [shape] = await readPuffSheet(discs(64, 1));
  const [other] = await readPuffSheet(discs(64, 1));
  expect(billboardShapes([shape, LOBE_SHAPES[0]], 4).slice(0, 4)).toEqual([shape, shape, shape, shape]);
  expect(keyOf([shape])).toBe(keyOf([{ ...shape }]));
  expect(keyOf([shape])).not.toBe(keyOf([other]));
  expect(keyOf([shape])).not.toBe(keyOf([{ name: shape.name, lobes: shape.lobes }]));
  const clone = structuredClone(shape);
  expect(bytesOf(bakePuffs([clone]))).toEqual(bytesOf(bakePuffs([shape])));
  const { layers, startCaps, solids } = finished(bakingBillboards([shape], 16, 2));
  expect([layers.count, startCaps.count]).toEqual([1, 1]);
  expect(finished(bakingBillboards([shape, LOBE_SHAPES[0]], 16, 2)).layers.count).toBe(4);
  // The disc has a flat front, the ball has not, so the culling must allow for the difference.
  expect(solids.tolerance).toBeGreaterThan(0.1);
});

test('8,192 pixels are read in many slices', async () => {
  const width = 8192;
  const data = new Uint8Array(4 * width * width);
  for (let y = 1000; y < 3000; y++)
    for (let x = 1000; x < 3000; x++) data.set([0, 0, y % 256, 255], 4 * (y * width + x));
  let turns = 0;
  const timer = setInterval(() => turns++, 0);
  const read = await readPuffSheet({ lightRimDepthMask: { width, height: width, data } });
  clearInterval(timer);
  expect(read).toHaveLength(1);
  expect(read[0].sheet!.size).toBe(256);
  expect(turns).toBeGreaterThan(3);
});

test('reading and writing can be aborted', async () => {
  const signal = AbortSignal.abort(new Error('stop'));
  await expect(readPuffSheet(discs(64, 1), { signal })).rejects.toThrow('stop');
  await expect(writePuffSheet(shapes, { signal })).rejects.toThrow('stop');
});

const good = discs(64, 1);
const packed = (sheet: unknown): PackedPuffs => ({ lightRimDepthMask: sheet as PixelImage });
const bytes = new Uint8Array(4 * 64 * 64).fill(255);

const HOSTILE: readonly (readonly [string, unknown, RegExp, object?])[] = [
  ['nothing', undefined, /not a puff sheet/],
  ['a single image that is not named', good.normalDepth, /not a puff sheet/],
  ['no second image', { normalDepth: good.normalDepth }, /colorCoverage, is missing/],
  ['no first image', { colorCoverage: good.colorCoverage }, /normalDepth, is missing/],
  ['both layouts', { ...good, ...packed(good.normalDepth) }, /not a puff sheet/],
  ['images of different sizes', { ...good, colorCoverage: discs(32, 1).colorCoverage }, /64 x 64 and 32 x 32/],
  ['an image that is not square', packed(image(64, () => [0, 0, 0, 255], 32)), /64 x 32 pixels. It must be square/],
  ['a size of NaN', packed({ width: NaN, height: NaN, data: bytes }), /NaN x NaN pixels.*whole numbers/],
  ['a size that is not whole', packed({ width: 63.5, height: 63.5, data: bytes }), /whole numbers/],
  ['no pixels', packed({ width: 0, height: 0, data: new Uint8Array() }), /whole numbers/],
  ['8,193 pixels', packed({ width: 8193, height: 8193, data: bytes }), /limit is 8192 x 8192/],
  ['too few bytes', packed({ width: 64, height: 64, data: bytes.subarray(4) }), /16380 bytes.* has 16384/],
  [
    'numbers that are not bytes',
    packed({ width: 64, height: 64, data: new Float32Array(4 * 64 * 64).fill(NaN) }),
    /bytes/,
  ],
  ['an array instead of bytes', packed({ width: 64, height: 64, data: [1, 2, 3] }), /bytes/],
  ['an empty mask', packed(image(64, () => [255, 255, 255, 127])), /empty.*alpha of 128/],
  [
    'a mask of single pixels',
    packed(image(64, (x, y) => [0, 0, x + y, x % 8 === 0 && y % 8 === 0 ? 255 : 0])),
    /too thin/,
    { tiles: 1 },
  ],
  ['a depth of one value', packed(image(64, () => [9, 9, 77, 255])), /flat/],
  ['three tiles', good, /3 tiles.*use 1 or 2/, { tiles: 3 }],
  ['tiles that are too small', discs(20, 1), /20 pixels.*at least 32/, { tiles: 2 }],
  ['an odd size for two tiles', discs(33, 1), /multiple of 2/, { tiles: 2 }],
  ['a relief of NaN', good, /relief/, { relief: NaN }],
  ['a relief below 0', good, /relief/, { relief: -1 }],
  ['green to the left', good, /up or down/, { green: 'left' }],
];

for (const [name, sheet, message, options] of HOSTILE) {
  test(`${name} is a ShapeError`, async () => {
    const error = await readPuffSheet(sheet as PuffTextures, options).catch((thrown: unknown) => thrown);
    expect(error).toBeInstanceOf(ShapeError);
    expect(String(error)).toMatch(message);
  });
}

const UNWRITABLE: readonly (readonly [string, unknown, RegExp, object?])[] = [
  ['no array', LOBE_SHAPES[0], /array/],
  ['no shapes', [], /0 puff shapes/],
  ['five shapes', Array.from({ length: 5 }, () => LOBE_SHAPES[0]), /5 shapes: the limit is 4/],
  ['tiles of NaN pixels', LOBE_SHAPES, /NaN pixels.*16 to 512/, { size: NaN }],
  ['tiles of 513 pixels', LOBE_SHAPES, /16 to 512/, { size: 513 }],
];

for (const [name, given, message, options] of UNWRITABLE) {
  test(`${name} cannot be written`, async () => {
    const error = await writePuffSheet(given as PuffShape[], options).catch((thrown: unknown) => thrown);
    expect(error).toBeInstanceOf(ShapeError);
    expect(String(error)).toMatch(message);
  });
}
