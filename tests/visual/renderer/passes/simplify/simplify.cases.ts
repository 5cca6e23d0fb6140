/** Smoothed light on balls: shadows with known outlines, seen along the light. */
import { OrthographicCamera } from 'three';
import type { PuffShape } from '../../../../../src/renderer/puffs/shapes.ts';
import { parseStops } from '../../../../../src/renderer/palette.ts';
import type { Style } from '../../../../../src/renderer/style.ts';
import { Lab, type LabPicture, type LabPuff, type LabScene } from '../../../lab.ts';
import { random } from '../../../random.ts';
import { box } from '../../../solids.ts';
import { colors, differing } from '../puffs.cases.ts';

const [WIDTH, HEIGHT] = [200, 160];
const METRES_PER_PIXEL = 0.01;
const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];
/** Flat smoke: light for puffs without shadow. */
const STYLE: LabScene['style'] = { tones: 1, outlines: false };
const LARGE: LabPuff = { place: [0, 0, 0], radius: 0.7 };

/** Pixels in shadow under discs of these radii, which one large ball receives. @param deviation CSS pixels */
export function shadowAreas(radii: readonly number[], deviation: number, pixelRatio: number): number[] {
  return draws(radii.map((radius) => ({ puffs: [LARGE], casters: [disc(0, 0, radius)], deviation, pixelRatio }))).map(
    ({ smooth, plain }) => darkPixels(smooth) * Number(darkPixels(plain) > 0),
  );
}

/** The same on a surface. */
export function shadowAreasOnWall(radii: readonly number[], deviation: number): number[] {
  const surfaces: LabScene['surfaces'] = [
    { mesh: box([0, 0, -0.5], [0.7, 0.7, 0.1]), color: [250, 250, 250], name: 'wall', casts: false, inked: false },
  ];
  return draws(
    radii.map((radius) => ({ puffs: [], casters: [disc(0, 0, radius)], deviation, pixelRatio: 1 })),
    surfaces,
  ).map(({ smooth, bare }) => differing(smooth, bare));
}

/** Pixels in shadow under a disc at these distances from the middle along the diagonal, CSS pixels. */
export function shadowAreasAt(shifts: readonly number[], radius: number): { plain: number; smooth: number }[] {
  const at = shifts.map((shift) => METRES_PER_PIXEL * shift);
  return draws(at.map((x) => ({ puffs: [LARGE], casters: [disc(x, x, radius)], deviation: 8, pixelRatio: 1 }))).map(
    ({ smooth, plain }) => ({ plain: darkPixels(plain), smooth: darkPixels(smooth) }),
  );
}

/** What is beside a small ball in shadow, which touches a large ball in the light. */
export const NEIGHBOURS = {
  same: [{ place: [0, 0, 0.69], radius: 0.06 }],
  otherTint: [{ place: [0, 0, 0.69], radius: 0.06, tint: 1 }],
  nearer: [{ place: [0, 0, 1.6], radius: 0.06 }],
} satisfies Record<string, LabPuff[]>;

/** Pixels of the small ball's shadow that remain, as a share. */
export function shareLeft(name: keyof typeof NEIGHBOURS): number {
  const caster: LabPuff = { place: [0, 0, 2.4], radius: 0.06 };
  const [{ smooth, plain }] = draws([
    { puffs: [LARGE, ...NEIGHBOURS[name]], casters: [caster], deviation: 8, pixelRatio: 1 },
  ]);
  return darkPixels(smooth) / darkPixels(plain);
}

/** A row of balls in the light, with ink around them, before a large one in shadow. */
export function acrossInk(): { shadow: number; changed: number } {
  const front: LabPuff[] = [-2, -1, 0, 1, 2].map((column) => ({ place: [0.28 * column, 0, 3], radius: 0.1 }));
  const caster: LabPuff = { place: [0, 0, 2], radius: 0.71 };
  const lab = labFor([LARGE, ...front], [caster], 1);
  const style = { ...STYLE, outlines: true, innerLine: 0 };
  const [plain, smooth] = [0, 4].map((simplify) =>
    lab.draw(sceneOf([LARGE, ...front], [caster], 1, { ...style, simplify })),
  );
  lab.dispose();
  return { shadow: darkPixels(plain), changed: differing(plain, smooth) };
}

/** Every tone at once. `added`: colours that only the smoothed picture has. */
export function allTones(): { changed: number; added: string[] } {
  const next = random(11);
  const puffs = Array.from({ length: 60 }, (): LabPuff => ({
    place: [1.6 * next() - 0.8, 1.2 * next() - 0.6, next() - 0.5],
    radius: 0.08 + 0.2 * next(),
    roll: 6 * next(),
    variation: Math.floor(4 * next()),
    seed: Math.floor(256 * next()),
    tint: Math.floor(3 * next()),
    age: next(),
  }));
  const style: LabScene['style'] = {
    tones: 3,
    fill: 0.4,
    rim: 0.5,
    shadowSteps: 2,
    shadowDepth: 3,
    ageColors: parseStops('0:ffffff,.5:ffd0a0'),
  };
  const scene = { ...sceneOf(puffs, puffs, 1, {}), towardsLight: [-0.5, 0.8, 0.4] as const, shapes: undefined };
  const lab = new Lab({ ...scene, capacity: puffs.length });
  const [plain, smooth] = [0, 3].map((simplify) => lab.draw({ ...scene, style: { ...style, simplify } }));
  lab.dispose();
  const known = colors(plain);
  return { changed: differing(plain, smooth), added: Object.keys(colors(smooth)).filter((color) => !(color in known)) };
}

/** Distance from the nearest border of a tone from which a pixel is in the middle of it, pixels. */
const MIDDLE = 10;

/**
 * A ball that is lit from the side, with a shadow on it: in the middle of the tones, the largest difference of a channel
 * between smoothed light and plain light.
 * @returns also the number of these pixels by the tone that they have without a gradient
 */
export function inMiddleOfTones(style: Partial<Style>): { largest: number; pixels: Record<string, number> } {
  const scene = { ...sceneOf([LARGE], [disc(0.3, 0.3, 25)], 1, {}), towardsLight: [0.4, 0.5, 0.7] as const };
  const lab = new Lab({ ...scene, puffs: [LARGE, LARGE] });
  const given = { outlines: false, ...style };
  const [tones, plain, smooth] = [{ ...given, gradient: 'none' } as const, given, { ...given, simplify: 3 }].map(
    (drawn) => lab.draw({ ...scene, style: drawn }).pixels,
  );
  lab.dispose();
  const color = (pixel: number) => tones.subarray(4 * pixel, 4 * pixel + 4).join();
  const result = { largest: 0, pixels: {} as Record<string, number> };
  for (let pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
    if (tones[4 * pixel + 3] === 0 || around(pixel, MIDDLE).some((other) => color(other) !== color(pixel))) continue;
    result.pixels[color(pixel)] = (result.pixels[color(pixel)] ?? 0) + 1;
    for (let at = 4 * pixel; at < 4 * pixel + 4; at++) {
      result.largest = Math.max(result.largest, Math.abs(plain[at] - smooth[at]));
    }
  }
  return result;
}

/** The pixels of the picture within a distance along both axes. */
function around(pixel: number, distance: number): number[] {
  const steps = Array.from({ length: 2 * distance + 1 }, (_, step) => step - distance);
  const [x, y] = [pixel % WIDTH, Math.floor(pixel / WIDTH)];
  const isInside = (i: number, j: number) => i >= 0 && j >= 0 && i < WIDTH && j < HEIGHT;
  return steps.flatMap((j) => steps.flatMap((i) => (isInside(x + i, y + j) ? [(y + j) * WIDTH + x + i] : [])));
}

/** Pixels that differ between a picture and the same one after another frame. */
export function repeated(): number {
  const lab = labFor([LARGE, LARGE], [disc(0, 0, 30)], 1);
  const there: LabPuff = { ...LARGE, place: [0.3, 0.2, 0] };
  const [first, , again] = [
    { puffs: [LARGE], caster: disc(0, 0, 20) },
    { puffs: [there, LARGE], caster: disc(0.2, 0.1, 30) },
    { puffs: [LARGE], caster: disc(0, 0, 20) },
  ].map(({ puffs, caster }) => lab.draw(sceneOf(puffs, [caster], 1, { ...STYLE, simplify: 4, plumeForm: 0.6 })));
  lab.dispose();
  return differing(first, again);
}

/**
 * Pixels that change if every tile is smoothed, not only those of smoke and of its shadow; and those that smoothing changes.
 * The picture ends within a tile on both sides.
 */
export function everyTile(width: number, height: number): { differing: number; smoothed: number } {
  const next = random(5);
  const puffs = Array.from({ length: 12 }, (): LabPuff => ({
    place: [0.9 * next() - 0.2, 0.8 * next() - 0.4, 0.3 * next()],
    radius: 0.08 + 0.1 * next(),
    variation: 0,
  }));
  const surfaces: LabScene['surfaces'] = [
    { mesh: box([-0.4, 0, -0.6], [0.5, 0.6, 0.1]), color: [230, 160, 90], name: 'wall', casts: false, inked: true },
    { mesh: box([-0.7, 0.5, 0.6], [0.1, 0.1, 0.1]), color: [90, 160, 230], name: 'block', casts: true, inked: true },
  ];
  const style: LabScene['style'] = { tones: 3, fill: 0.4, shadowSteps: 2, shadowDepth: 1, plumeForm: 0.3 };
  const scene = { ...sceneOf(puffs, puffs, 1, style, surfaces), width, height };
  const lab = new Lab({ ...scene, capacity: puffs.length });
  const front = [0.5, 0.4, 0.8] as const;
  const draw = (simplify: number, towardsLight: readonly [number, number, number] = front) =>
    lab.draw({ ...scene, towardsLight, style: { ...style, simplify } });
  const plain = draw(0);
  draw(6);
  const { material } = lab['smoke'].passes.extras.simplify!.meshes(true)[1];
  const { fragmentShader } = material;
  const choose = (shader: string) => Object.assign(material, { fragmentShader: shader, needsUpdate: true });
  const all = fragmentShader.replace(/void main[\s\S]*/, 'void main() { tile = vec4(0, 1, 0, 1); }');
  choose(all);
  // What the targets still hold of this frame must not matter.
  draw(6, [-0.5, -0.4, -0.8]);
  choose(fragmentShader);
  const some = draw(6);
  choose(all);
  const every = draw(6);
  lab.dispose();
  return { differing: differing(some, every), smoothed: differing(plain, some) };
}

interface Drawing {
  puffs: readonly LabPuff[];
  casters: readonly LabPuff[];
  deviation: number;
  pixelRatio: number;
}

/** Pictures with and without smoothing, and without shadows. */
function draws(drawings: readonly Drawing[], surfaces: LabScene['surfaces'] = []) {
  const [{ puffs, casters, pixelRatio }] = drawings;
  const lab = labFor(puffs, casters, pixelRatio, surfaces);
  const pictures = drawings.map((drawing) => {
    const scene = sceneOf(drawing.puffs, drawing.casters, pixelRatio, STYLE, surfaces);
    const styled = (style: LabScene['style']) => lab.draw({ ...scene, style: { ...STYLE, ...style } });
    return {
      plain: styled({}),
      smooth: styled({ simplify: drawing.deviation }),
      bare: styled({ shadows: false }),
    };
  });
  lab.dispose();
  return pictures;
}

function labFor(
  puffs: readonly LabPuff[],
  casters: readonly LabPuff[],
  pixelRatio: number,
  surfaces: LabScene['surfaces'] = [],
): Lab {
  return new Lab(sceneOf(puffs, casters, pixelRatio, STYLE, surfaces));
}

function sceneOf(
  puffs: readonly LabPuff[],
  casters: readonly LabPuff[],
  pixelRatio: number,
  style: LabScene['style'],
  surfaces: LabScene['surfaces'] = [],
): LabScene {
  const [width, height] = [WIDTH * pixelRatio, HEIGHT * pixelRatio];
  const [right, top] = [(WIDTH * METRES_PER_PIXEL) / 2, (HEIGHT * METRES_PER_PIXEL) / 2];
  const camera = new OrthographicCamera(-right, right, top, -top, 0.1, 20);
  camera.position.set(0, 0, 4);
  camera.updateMatrixWorld();
  const common = { width, height, pixelRatio, camera, shapes: BALL, surfaces, towardsLight: [0, 0, 1] as const };
  return { ...common, puffs, casters, style };
}

/** A ball between the receivers and the light. @param x, y metres @param radius CSS pixels */
function disc(x: number, y: number, radius: number): LabPuff {
  return { place: [x, y, 2], radius: radius * METRES_PER_PIXEL };
}

/** Pixels of smoke in shadow. */
function darkPixels({ pixels }: LabPicture): number {
  return pixels.filter((_, at) => at % 4 === 3 && pixels[at] > 0 && isDark(pixels.subarray(at - 3, at))).length;
}

function isDark(color: Uint8Array): boolean {
  const lightness = (Math.max(...color) + Math.min(...color)) / 2;
  return lightness > 60 && lightness < 190;
}
