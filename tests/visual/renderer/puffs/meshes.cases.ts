/** Billboards of closed meshes: their colours, their own shadow, and what their culling hides. */
import { rampOf } from '../../../../src/renderer/palette.ts';
import type { Color } from '../../../../src/renderer/gpu/ramps.ts';
import { fitPuff } from '../../../../src/renderer/puffs/fit/fitPuff.ts';
import { readPuffSheet } from '../../../../src/renderer/puffs/sheet/readPuffSheet.ts';
import { writePuffSheet } from '../../../../src/renderer/puffs/sheet/writePuffSheet.ts';
import type { PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import type { Style } from '../../../../src/renderer/style.ts';
import { frontCamera, PLAIN_STYLE, takePicture } from '../../lab.ts';
import { defaultPreset, presetValues } from '../../../../src/parameters/presets.ts';
import { createStage } from '../../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../../support/plainLook.ts';
import { CARDS, face, halves, heart, popcorn, rings, torus } from '../../puffMeshes.ts';
import { comparePlume, type Comparison } from '../culling.cases.ts';
import { selfMasked } from '../passes/lonePuffs.cases.ts';

const MESHES = { face, heart, popcorn, rings, torus, ...CARDS } as const;
const SIZE = 240;
const [UPPER, LOWER] = [[1, 0.8, 0.2], [0.4, 0.6, 1]] as const; // prettier-ignore

type Name = keyof typeof MESHES | 'sheet';

/** Those of a sheet are pictures of a heart, of popcorn and of a face. */
async function shapesOf(names: readonly Name[]): Promise<PuffShape[]> {
  const shapes = await Promise.all(
    names.map(async (name) => {
      if (name !== 'sheet') return [(await fitPuff(MESHES[name](), { lobes: 8 })).shape];
      return readPuffSheet(await writePuffSheet(await shapesOf(['heart', 'popcorn', 'face'])));
    }),
  );
  return shapes.flat();
}

/** See `selfMasked`. */
export async function masked(
  names: readonly Name[],
  light: 'sun' | 'lamp',
  trials: number,
): Promise<{ lit: number; masked: number }> {
  return selfMasked('billboards', light, trials, await shapesOf(names));
}

/**
 * A ball with a colour in its upper half and another in its lower one, without ink: pixels by colour in each half, and
 * the tones of the ramp times these colours.
 */
export async function paintedTones(style: Partial<Style>): Promise<{ found: string[][]; expected: string[][] }> {
  const { shape } = await fitPuff(halves(UPPER, LOWER), { lobes: 1 });
  const { pixels } = takePicture({
    width: SIZE,
    height: SIZE,
    shapes: [shape],
    puffs: [{ place: [0, 0, 0], radius: 0.9 }],
    camera: frontCamera(SIZE, SIZE, 4, 30),
    style: { form: 'billboards', outlines: false, shadows: false, ...style },
  });
  const found = [new Set<string>(), new Set<string>()];
  for (let at = 0; at < SIZE * SIZE; at++) {
    const row = Math.floor(at / SIZE) - SIZE / 2;
    // Texels at the border of the halves have a mean of their colours.
    if (pixels[4 * at + 3] > 0 && Math.abs(row) > SIZE / 15) {
      found[row > 0 ? 0 : 1].add(pixels.subarray(4 * at, 4 * at + 3).join());
    }
  }
  const { lit } = rampOf(PLAIN_STYLE.smokeColor, { tones: 2, shading: true });
  const times = (color: Color, factor: readonly number[]) =>
    color.map((value, channel) => Math.round((value * Math.round(255 * factor[channel])) / 255)).join();
  const expected = [UPPER, LOWER].map((factor) => [...new Set(lit.map(({ color }) => times(color, factor)))].sort());
  return { found: found.map((colors) => [...colors].sort()), expected };
}

/**
 * A row of puffs of meshes, and below it the same puffs from a sheet of them: covered pixels of both, and pixels that
 * differ by more than a step of a tone.
 */
export async function besideSheet(): Promise<{ covered: number; different: number }> {
  const own = await shapesOf(['heart', 'popcorn', 'face', 'torus']);
  const [upper, lower] = [own, await readPuffSheet(await writePuffSheet(own))].map((shapes) => {
    const puffs = shapes.map((_, variation) => ({
      place: [2.1 * variation - 3.15, 0, 0] as const,
      radius: 1,
      variation,
    }));
    const style = { form: 'billboards', shadows: false } as const;
    return takePicture({
      width: 4 * SIZE,
      height: SIZE,
      shapes,
      puffs,
      camera: frontCamera(4 * SIZE, SIZE, 4.5, 30),
      style,
    });
  });
  let [covered, different] = [0, 0];
  for (let at = 0; at < upper.pixels.length; at += 4) {
    if (upper.pixels[at + 3] > 0) covered++;
    const off = [0, 1, 2, 3].map((channel) => Math.abs(upper.pixels[at + channel] - lower.pixels[at + channel]));
    if (Math.max(...off) > 40) different++;
  }
  return { covered, different };
}

/** Pictures of a plume of meshes with and without culling. */
export async function culled(names: readonly Name[], sides: number, style: Partial<Style> = {}): Promise<Comparison[]> {
  const shown = { form: 'billboards', ...style } as const;
  return comparePlume(1000, shown, ['scene', 'inside', 'orthographic'], await shapesOf(names), sides);
}

/**
 * Smoke of balls with a warm front and a cold back, drawn from a number of sides: pixels that are mainly red and mainly
 * blue, and the hash of the simulator.
 */
export async function sidesShown(views: 1 | 8): Promise<{ warm: number; cold: number; hash: string }> {
  const mesh = halves([1, 0.4, 0.3], [0.3, 0.4, 1]);
  const turned = Float32Array.from(mesh.positions, (_, at) => mesh.positions[at - (at % 3) + [0, 2, 1][at % 3]]);
  const { shape } = await fitPuff({ ...mesh, positions: turned, normals: undefined }, { lobes: 1 });
  const stage = await createStage(new OffscreenCanvas(SIZE, SIZE), {
    values: { ...presetValues(defaultPreset), ...PLAIN_LOOK, 'puff.form': 'billboards', 'puff.views': views },
    width: SIZE,
    height: SIZE,
    pixelRatio: 1,
  });
  stage.setPuffs([shape]);
  stage.step(180);
  const picture = await createImageBitmap(await stage.picture());
  const copy = new OffscreenCanvas(SIZE, SIZE).getContext('2d')!;
  copy.drawImage(picture, 0, 0);
  const { data } = copy.getImageData(0, 0, SIZE, SIZE);
  const shown = { warm: 0, cold: 0, hash: stage.hash() };
  for (let at = 0; at < data.length; at += 4) {
    if (data[at] > 2 * data[at + 2] && data[at + 3] > 0) shown.warm++;
    if (data[at + 2] > 2 * data[at] && data[at + 3] > 0) shown.cold++;
  }
  stage.dispose();
  return shown;
}
