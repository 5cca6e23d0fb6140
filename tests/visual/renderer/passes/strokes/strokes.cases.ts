/** Strokes on puffs with a small lobe before a large one, whose outline is a known circle or ellipse. */
import { OrthographicCamera } from 'three';
import type { PuffShape } from '../../../../../src/renderer/puffs/shapes.ts';
import { Lab, type LabPicture, type LabPuff, type LabScene } from '../../../lab.ts';
import { random } from '../../../random.ts';
import { box } from '../../../solids.ts';
import { differing } from '../puffs.cases.ts';

/** CSS pixels. */
const SIZE = 240;
const METRES_PER_PIXEL = 0.01;
/** The small lobe, in puff radii. Its outline is 0.5 before the large one. */
export const LOBE = { x: 0.1, y: -0.05, radius: 0.45 };
const SHAPES: readonly PuffShape[] = [
  {
    name: 'two',
    lobes: [
      { center: [0, 0, -0.5], radius: 0.95 },
      { center: [LOBE.x, LOBE.y, 0.9], radius: LOBE.radius },
    ],
  },
];
const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];
const TOWARDS_LIGHT = [-0.6, 0.6, 0.53] as const;
const AWAY = [Math.SQRT1_2, -Math.SQRT1_2] as const;
/** A puff without fading. */
const PUFF: LabPuff = { place: [0, 0, 0], radius: 1, age: 0.5 };
const SEEDS = 200;

/** A pixel of ink that strokes add, in CSS pixels from the middle of the picture, and its opacity. */
export interface InkPixel {
  x: number;
  y: number;
  opacity: number;
}

export interface Drawing {
  puffs: readonly LabPuff[];
  style?: LabScene['style'];
  pixelRatio?: number;
  surfaces?: LabScene['surfaces'];
  shapes?: readonly PuffShape[];
}

/** The ink that strokes add to a puff with a seed. @param radius metres */
export function inkOf(radius: number, seed: number, pixelRatio: number, style: LabScene['style'] = {}): InkPixel[] {
  return strokesOf({ puffs: [{ ...PUFF, radius, seed }], pixelRatio, style }).ink;
}

/** The first seed whose small lobe has a stroke and whose large lobe has none that is visible. */
export function seedWithStroke(): number {
  for (let seed = 0; seed < SEEDS; seed++) if (inkOf(1, seed, 1).length > 0) return seed;
  return -1;
}

/** The same, stretched upwards by 2. */
export function inkOfStretched(seed: number): InkPixel[] {
  const deformation = { stretchU: 127, stretchV: 254, stretch: 85 };
  const style = { isDeformed: true, stretch: 2 };
  return strokesOf({ puffs: [{ ...PUFF, radius: 0.8, seed, deformation }], pixelRatio: 2, style }).ink;
}

/** Ink on the side of the lobe that faces away from the light, and on the other side, over puffs with every other seed. */
export function sides(): { shaded: number; lit: number; puffs: number } {
  const sums = { shaded: 0, lit: 0, puffs: 0 };
  withLab({ puffs: [PUFF] }, (draw) => {
    for (let seed = 0; seed < SEEDS; seed += 2) {
      const { ink } = draw({ puffs: [{ ...PUFF, seed }] });
      sums.puffs += Number(ink.length > 0);
      for (const { x, y, opacity } of ink) {
        const along = (x - 100 * LOBE.x) * AWAY[0] + (y - 100 * LOBE.y) * AWAY[1];
        sums[along > 0 ? 'shaded' : 'lit'] += opacity;
      }
    }
  });
  return sums;
}

/** Ink of many puffs by number of strokes, and pixels of ink that a larger number loses. */
export function amounts(numbers: readonly number[]): { ink: number[]; lost: number; atZero: number } {
  const puffs = crowd(4);
  return withLab({ puffs, shapes: undefined }, (draw) => {
    const drawn = numbers.map((strokes) => draw({ puffs, style: { strokes } }));
    const lost = drawn
      .slice(1)
      .map(({ with: more }, index) => losses(drawn[index].with, more, drawn[index].without))
      .reduce((sum, each) => sum + each, 0);
    const none = draw({ puffs, style: { strokes: 0 } });
    return { ink: drawn.map(({ ink }) => ink.length), lost, atZero: differing(none.with, none.without) };
  });
}

/** Pixels that change with the order of the particles. */
export function changedByOrder(): { changed: number; ink: number } {
  const puffs = crowd(9);
  return withLab({ puffs, shapes: undefined }, (draw) => {
    const forwards = draw({ puffs });
    const backwards = draw({ puffs: puffs.toReversed() });
    return { changed: differing(forwards.with, backwards.with), ink: forwards.ink.length };
  });
}

/** Ink of a lobe before the sky, before a wall, and of one whose lines are off. */
export function inkWithoutSmokeBehind(): number[] {
  const wall = {
    mesh: box([0, 0, -1.1], [3, 3, 0.1]),
    color: [200, 200, 200],
    name: 'wall',
    casts: false,
    inked: false,
  } as const;
  const puffs = Array.from({ length: 12 }, (_, seed): LabPuff => ({ ...PUFF, seed: 21 * seed, radius: 0.9 }));
  return [
    strokesOf({ puffs, shapes: BALL }).ink.length,
    // Beyond a thin line, the samples of the depth meet the wall.
    strokesOf({ puffs, shapes: BALL, surfaces: [wall], style: { outlineWidth: 1 } }).ink.length,
    strokesOf({ puffs, style: { outlines: false } }).ink.length,
  ];
}

/**
 * A ball before a part of a stroke: ink of the stroke with and without it, ink that is on the ball, and ink where there is
 * no smoke.
 * @param x, y place of the ball, CSS pixels
 * @param radius metres
 */
export function behindBall(
  seed: number,
  x: number,
  y: number,
  radius: number,
): Record<'bare' | 'covered' | 'over' | 'outside', number> {
  const place = [x * METRES_PER_PIXEL, y * METRES_PER_PIXEL, 2] as const;
  const shapes = [...SHAPES, ...BALL];
  const puff = { ...PUFF, seed };
  const ball: LabPuff = { place, radius, variation: 1, age: 0.5 };
  const bare = strokesOf({ puffs: [puff], shapes });
  const covered = strokesOf({ puffs: [puff, ball], shapes });
  const isOver = (at: InkPixel) => Math.hypot(at.x - x, at.y - y) < radius / METRES_PER_PIXEL;
  const outside = [bare, covered].flatMap(({ ink, without }) => ink.filter((at) => alphaAt(without, at) === 0));
  return {
    bare: bare.ink.length,
    covered: covered.ink.length,
    over: covered.ink.filter(isOver).length,
    outside: outside.length,
  };
}

/**
 * What a ball of the same size leaves of a stroke, as it moves off it along a direction.
 * @param shifts places of the ball, CSS pixels from the middle of the lobe
 */
export function leftByBall(seed: number, toward: number, shifts: readonly number[], pixelRatio: number): InkPixel[][] {
  const shapes = [...SHAPES, ...BALL];
  const drawings = shifts.map((shift): Drawing => {
    const x = LOBE.x + shift * METRES_PER_PIXEL * Math.cos(toward);
    const y = LOBE.y + shift * METRES_PER_PIXEL * Math.sin(toward);
    const ball: LabPuff = { place: [x, y, 2], radius: LOBE.radius + 0.05, variation: 1, age: 0.5 };
    return { puffs: [{ ...PUFF, seed }, ball], shapes, pixelRatio };
  });
  return withLab(drawings[0], (draw) => drawings.map((drawing) => draw(drawing).ink));
}

interface Drawn {
  with: LabPicture;
  without: LabPicture;
  ink: InkPixel[];
}

function strokesOf(drawing: Drawing): Drawn {
  return withLab(drawing, (draw) => draw(drawing));
}

function withLab<Result>(first: Drawing, use: (draw: (drawing: Drawing) => Drawn) => Result): Result {
  const lab = new Lab(sceneOf(first));
  try {
    return use((drawing) => {
      const scene = sceneOf({ ...first, ...drawing });
      const picture = lab.draw(scene);
      const without = lab.draw({ ...scene, style: { ...scene.style, strokes: 0 } });
      return { with: picture, without, ink: inkBetween(without, picture, drawing.pixelRatio ?? 1) };
    });
  } finally {
    lab.dispose();
  }
}

function sceneOf({ puffs, style, pixelRatio = 1, surfaces = [], ...others }: Drawing): LabScene {
  const half = (SIZE * METRES_PER_PIXEL) / 2;
  const camera = new OrthographicCamera(-half, half, half, -half, 0.1, 20);
  camera.position.set(0, 0, 6);
  camera.updateMatrixWorld();
  return {
    width: SIZE * pixelRatio,
    height: SIZE * pixelRatio,
    pixelRatio,
    camera,
    puffs,
    surfaces,
    shapes: 'shapes' in others ? others.shapes : SHAPES,
    towardsLight: TOWARDS_LIGHT,
    // White smoke in one tone: the opacity of ink follows from the colour.
    style: {
      strokes: 1,
      shadows: false,
      tones: 1,
      smokeColor: [255, 255, 255],
      inkColor: [0, 0, 0],
      outlineWidth: 4,
      ...style,
    },
  };
}

function inkBetween(without: LabPicture, picture: LabPicture, pixelRatio: number): InkPixel[] {
  const { width, pixels } = picture;
  const ink: InkPixel[] = [];
  for (let pixel = 0; pixel < pixels.length / 4; pixel++) {
    const [before, after] = [without.pixels[4 * pixel + 1], pixels[4 * pixel + 1]];
    if (before === after) continue;
    const [x, y] = [(pixel % width) + 0.5, Math.floor(pixel / width) + 0.5];
    ink.push({ x: (x - width / 2) / pixelRatio, y: (y - width / 2) / pixelRatio, opacity: 1 - after / before });
  }
  return ink;
}

function alphaAt({ width, pixels }: LabPicture, { x, y }: InkPixel): number {
  return pixels[4 * (Math.floor(x + width / 2) + width * Math.floor(y + width / 2)) + 3];
}

/** Pixels that are darkened by `fewer` and less so by `more`. */
function losses(fewer: LabPicture, more: LabPicture, without: LabPicture): number {
  return fewer.pixels.filter((value, at) => value < without.pixels[at] && more.pixels[at] > value).length;
}

function crowd(seed: number): LabPuff[] {
  const next = random(seed);
  return Array.from({ length: 40 }, () => ({
    place: [1.4 * next() - 0.7, 1.4 * next() - 0.7, 1.5 * next() - 0.7] as const,
    radius: 0.4 + 0.3 * next(),
    roll: 6 * next(),
    variation: Math.floor(4 * next()),
    seed: Math.floor(256 * next()),
    age: 0.3 + 0.4 * next(),
  }));
}
