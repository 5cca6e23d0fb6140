/** Lines of puffs that touch surfaces: closed on a floor, hidden behind a wall. */
import { PerspectiveCamera } from 'three';
import type { PuffForm } from '../../../../src/renderer/gpu/puffTextures.ts';
import type { SurfaceDescription } from '../../../../src/renderer/passes/surface.ts';
import { Lab, PLAIN_STYLE, type LabPicture, type LabPuff } from '../../lab.ts';
import { box, ground } from '../../solids.ts';

const [WIDTH, HEIGHT] = [240, 180];
const FLOOR = 0;
const WALL_COLOR = [90, 160, 120] as const;

type Position = [number, number, number];

function cameraAt(elevation: number, distance: number, height = 0.3): PerspectiveCamera {
  const camera = new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 100);
  const angle = (elevation * Math.PI) / 180;
  camera.position.set(0, height + distance * Math.sin(angle), distance * Math.cos(angle));
  camera.lookAt(0, height, 0);
  camera.updateMatrixWorld();
  return camera;
}

function is(picture: LabPicture, pixel: number, color: readonly number[]): boolean {
  return color.every((channel, index) => picture.pixels[4 * pixel + index] === channel);
}

/** The 4-neighbours of a pixel, and with `corners` the 8-neighbours. */
function neighbours(pixel: number, corners: boolean): number[] {
  const [x, y] = [pixel % WIDTH, Math.floor(pixel / WIDTH)];
  const steps = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) => [dx, dy]));
  return steps
    .filter(([dx, dy]) => (corners ? dx !== 0 || dy !== 0 : Math.abs(dx) + Math.abs(dy) === 1))
    .filter(([dx, dy]) => x + dx >= 0 && x + dx < WIDTH && y + dy >= 0 && y + dy < HEIGHT)
    .map(([dx, dy]) => pixel + dx + dy * WIDTH);
}

/** Flood fill: all `open` pixels connected to the first one. */
function flood(first: number, open: (pixel: number) => boolean, corners: boolean): Set<number> {
  const reached = new Set([first]);
  const waiting = [first];
  for (let pixel = waiting.pop(); pixel !== undefined; pixel = waiting.pop()) {
    for (const next of neighbours(pixel, corners)) {
      if (reached.has(next) || !open(next)) continue;
      reached.add(next);
      waiting.push(next);
    }
  }
  return reached;
}

export interface Outline {
  /** Puff and view. */
  name: string;
  fill: number;
  ink: number;
  /** Pixels of the puff's fill that a flood from outside reaches. */
  leaked: number;
  /** Pixels of the largest connected ink area. */
  connected: number;
}

/** Puffs on a floor, from resting on their lobes to half inside it, in several views. */
export function onFloor(form: PuffForm): Outline[] {
  return resting(form).map(({ picture, name }) => outlineOf(picture, name));
}

/** The pictures of {@link onFloor}. */
export function resting(form: PuffForm): { picture: LabPicture; name: string }[] {
  const scene = { width: WIDTH, height: HEIGHT, puffs: [], surfaces: [ground(FLOOR, 30)] };
  const lab = new Lab(scene);
  const pictures = [8, 16, 30].flatMap((elevation) =>
    [0.3, 0.62, 0.8, 0.95, 1.05].map((height, variation) => {
      const puff: LabPuff = {
        place: [0, height * 0.5, 0],
        radius: 0.5,
        variation: variation % 4,
        seed: 40 * variation,
      };
      const camera = cameraAt(elevation, 2.6);
      const style = { form, tones: 1, shadows: false, innerLine: 0.3 } as const;
      const picture = lab.draw({ ...scene, puffs: [puff], camera, style });
      return { picture, name: `${height} radii, ${elevation} degrees` };
    }),
  );
  lab.dispose();
  return pictures;
}

function outlineOf(picture: LabPicture, name: string): Outline {
  const all = Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixel);
  const isInk = (pixel: number): boolean => is(picture, pixel, PLAIN_STYLE.inkColor);
  const fill = all.filter((pixel) => is(picture, pixel, PLAIN_STYLE.smokeColor));
  const ink = all.filter(isInk);
  const outside = flood(WIDTH * HEIGHT - 1, (pixel) => !isInk(pixel), false);
  const leaked = fill.filter((pixel) => outside.has(pixel)).length;
  const connected = ink.length > 0 ? flood(ink[ink.length >> 1], isInk, true).size : 0;
  return { name, fill: fill.length, ink: ink.length, leaked, connected };
}

/** A puff close behind a low wall, or close in front of it: pixels of ink on the wall, and all ink pixels. */
export function atWall(form: PuffForm, side: 'behind' | 'before', gap: number): { onWall: number; ink: number } {
  const [top, depth] = [0.45, 0.05];
  const mesh = box([0, 0, 0], [3, top, depth]);
  const surfaces: SurfaceDescription[] = [{ name: 'wall', mesh, color: WALL_COLOR, casts: false, inked: false }];
  const away = (side === 'behind' ? -1 : 1) * (depth + 0.62 + gap);
  const place: Position = [0, top, away];
  const scene = {
    width: WIDTH,
    height: HEIGHT,
    surfaces,
    puffs: [{ place, radius: 0.5 }],
    camera: cameraAt(0, 4, top),
  };
  const lab = new Lab(scene);
  const style = { form, shadows: false, tones: 1 } as const;
  const [empty, full] = [[], scene.puffs].map((puffs) => lab.draw({ ...scene, puffs, style }));
  lab.dispose();
  const ink = Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixel).filter((pixel) =>
    is(full, pixel, PLAIN_STYLE.inkColor),
  );
  return { onWall: ink.filter((pixel) => empty.pixels[4 * pixel + 3] > 0).length, ink: ink.length };
}
