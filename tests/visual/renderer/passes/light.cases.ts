/** A ball of smoke under lights of other colours and strengths, seen along the z axis. */
import { OrthographicCamera } from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { defaults } from '../../../../src/parameters/values.ts';
import type { PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { styleOf } from '../../../../src/renderer/style.ts';
import { takePicture, type LabScene } from '../../lab.ts';

const [WIDTH, HEIGHT] = [200, 160];
const METRES_PER_PIXEL = 0.01;
const RADIUS = 0.7;
const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];

export type Triple = readonly [number, number, number];

/** The normal at the middle of a pixel, and the colour of the pixel. */
export interface Sample {
  normal: Triple;
  color: readonly number[];
}

/**
 * The pixels at places of the ball.
 * @param places x and y in radii
 * @param values of the table, over its defaults
 */
export function sampled(
  places: readonly (readonly [number, number])[],
  towardsLight: Triple,
  values: Values,
): Sample[] {
  const { pixels } = takePicture(sceneOf(towardsLight, values));
  return places.map(([x, y]) => {
    const [column, row] = [pixelAt(x, WIDTH), pixelAt(y, HEIGHT)];
    const [across, up] = [placeOf(column, WIDTH), placeOf(row, HEIGHT)];
    const at = 4 * (row * WIDTH + column);
    const normal = [across, up, Math.sqrt(1 - across ** 2 - up ** 2)] as const;
    return { normal, color: [...pixels.subarray(at, at + 3)] };
  });
}

/** Pixels by colour `r,g,b,a`. */
export function colorsOf(towardsLight: Triple, values: Values): Record<string, number> {
  const { pixels } = takePicture(sceneOf(towardsLight, values));
  const found: Record<string, number> = {};
  for (let at = 0; at < pixels.length; at += 4) {
    const color = pixels.subarray(at, at + 4).join();
    found[color] = (found[color] ?? 0) + 1;
  }
  return found;
}

function sceneOf(towardsLight: Triple, values: Values): LabScene {
  const [right, top] = [(WIDTH * METRES_PER_PIXEL) / 2, (HEIGHT * METRES_PER_PIXEL) / 2];
  const camera = new OrthographicCamera(-right, right, top, -top, 0.1, 20);
  camera.position.set(0, 0, 4);
  camera.updateMatrixWorld();
  return {
    width: WIDTH,
    height: HEIGHT,
    camera,
    shapes: BALL,
    puffs: [{ place: [0, 0, 0], radius: RADIUS }],
    backdrop: { top: [60, 90, 200], bottom: [60, 90, 200] },
    towardsLight,
    style: styleOf({ ...defaults(), 'style.outlines': 0, 'style.shadows': 0, ...values }),
  };
}

function pixelAt(place: number, size: number): number {
  return Math.floor((place * RADIUS) / METRES_PER_PIXEL + size / 2);
}

/** The middle of a pixel, radii. */
function placeOf(pixel: number, size: number): number {
  return ((pixel + 0.5 - size / 2) * METRES_PER_PIXEL) / RADIUS;
}
