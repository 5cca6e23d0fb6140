/** A ball of smoke under lights of other colours and strengths, seen along the z axis. */
import { OrthographicCamera } from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { defaults } from '../../../../src/parameters/values.ts';
import type { PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { styleOf } from '../../../../src/renderer/style.ts';
import { Lab, takePicture, type LabPicture, type LabScene } from '../../lab.ts';
import { box } from '../../solids.ts';

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
  return countsOf(takePicture(sceneOf(towardsLight, values)));
}

/** Balls of smoke in front of a white wall, by a lamp. Positions in metres. */
export interface LampScene {
  balls: readonly Triple[];
  radius: number;
  /** View depth of the wall is 4 - `wall`. */
  wall: number;
  lamp: Triple;
}

/** The middles of the pixels at places, metres, and their colours. */
export function sampledByLamp(scene: LampScene, places: readonly (readonly [number, number])[], values: Values) {
  const { pixels } = takePicture(lampScene(scene, values));
  return places.map((place) => {
    const sizes = [WIDTH, HEIGHT] as const;
    const [column, row] = place.map((metres, axis) => Math.floor(metres / METRES_PER_PIXEL + sizes[axis] / 2));
    const middle = [column, row].map((pixel, axis) => (pixel + 0.5 - sizes[axis] / 2) * METRES_PER_PIXEL);
    const at = 4 * (row * WIDTH + column);
    return { middle: middle as [number, number], color: [...pixels.subarray(at, at + 3)] };
  });
}

/** Pixels by colour `r,g,b,a`. */
export function colorsByLamp(scene: LampScene, values: Values): Record<string, number> {
  return countsOf(takePicture(lampScene(scene, values)));
}

/**
 * Pixels that two pictures of a scene have in the middle of their tones, and the largest difference of a channel there.
 * @param reach pixels around a pixel that have its tone
 */
export function compareTones(scene: LampScene, reach: number, one: Values, other: Values) {
  const [a, b] = [one, other].map((values) => takePicture(lampScene(scene, values)).pixels);
  const isMiddle = (column: number, row: number) => {
    const own = 4 * (row * WIDTH + column);
    for (let y = row - reach; y <= row + reach; ++y)
      for (let at = 4 * (y * WIDTH + column - reach); at < 4 * (y * WIDTH + column + reach + 1); at += 4)
        // The wall gets darker by less than this within reach.
        if ([0, 1, 2].some((channel) => Math.abs(a[at + channel] - a[own + channel]) > 12)) return false;
    return true;
  };
  let [pixels, worst] = [0, 0];
  for (let row = reach; row < HEIGHT - reach; ++row) {
    for (let column = reach; column < WIDTH - reach; ++column) {
      if (!isMiddle(column, row)) continue;
      const at = 4 * (row * WIDTH + column);
      pixels++;
      worst = Math.max(worst, ...[0, 1, 2, 3].map((channel) => Math.abs(a[at + channel] - b[at + channel])));
    }
  }
  return { pixels, worst };
}

/** The colour at a place for each position of the lamp. */
export function colorsAlong(
  scene: LampScene,
  lamps: readonly Triple[],
  place: readonly [number, number],
  values: Values,
) {
  const lab = new Lab(lampScene(scene, values));
  const colors = lamps.map((lamp) => {
    const { pixels } = lab.draw(lampScene({ ...scene, lamp }, values));
    const [column, row] = [place[0] / METRES_PER_PIXEL + WIDTH / 2, place[1] / METRES_PER_PIXEL + HEIGHT / 2];
    const at = 4 * (Math.floor(row) * WIDTH + Math.floor(column));
    return [...pixels.subarray(at, at + 3)];
  });
  lab.dispose();
  return colors;
}

function lampScene({ balls, radius, wall, lamp }: LampScene, values: Values): LabScene {
  const all: Values = { 'style.surfaceShadowColor': '#968cc4', 'light.kind': 'lamp', ...values };
  return {
    ...sceneOf([0, 0, 1], all),
    puffs: balls.map((place) => ({ place, radius })),
    surfaces: [
      { name: 'wall', mesh: box([0, 0, wall - 0.1], [3, 3, 0.1]), color: [255, 255, 255], casts: false, inked: false },
    ],
    lamp,
    falloff: { decay: values['light.decay'] ?? 0, scale: 1 / (values['light.distance'] ?? 1) },
  };
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

function countsOf({ pixels }: LabPicture): Record<string, number> {
  const found: Record<string, number> = {};
  for (let at = 0; at < pixels.length; at += 4) {
    const color = pixels.subarray(at, at + 4).join();
    found[color] = (found[color] ?? 0) + 1;
  }
  return found;
}

function pixelAt(place: number, size: number): number {
  return Math.floor((place * RADIUS) / METRES_PER_PIXEL + size / 2);
}

/** The middle of a pixel, radii. */
function placeOf(pixel: number, size: number): number {
  return ((pixel + 0.5 - size / 2) * METRES_PER_PIXEL) / RADIUS;
}
