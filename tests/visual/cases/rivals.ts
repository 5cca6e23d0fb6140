/** What the other renderers draw: Selle's lines, blended sprites, shadow by a depth map. */
import type { Color } from '../../../src/device/ramps.ts';
import { PLAIN_STYLE, takePicture, type LabPicture, type LabPuff } from '../lab.ts';
import { box } from '../solids.ts';

const WIDTH = 200;
const HEIGHT = 160;

/** Pixels of ink inside a puff's picture, where another stands before it by a share of the threshold. */
export function depthLines(share: number): { ink: number; thickest: number; colors: number } {
  const radii = [0.3, 0.9];
  const threshold = PLAIN_STYLE.innerLine * ((radii[0] + radii[1]) / 2);
  const picture = takePicture({
    width: WIDTH,
    height: HEIGHT,
    puffs: [
      { place: [0, 0, share * threshold], radius: radii[0] },
      { place: [0, 0, 0], radius: radii[1] },
    ],
    style: { renderer: 'selle' },
  });
  const middle = (x: number, y: number) => Math.hypot(x - WIDTH / 2, y - HEIGHT / 2) < 30;
  return { ...inkOf(picture, middle), colors: colorsOf(picture).size };
}

/** Ink pixels, and the side of the largest square that is all ink. */
function inkOf(picture: LabPicture, within: (x: number, y: number) => boolean): { ink: number; thickest: number } {
  const runs = new Int32Array(WIDTH * HEIGHT);
  let ink = 0;
  for (let at = WIDTH + 1; at < runs.length; at++) {
    if (!within(at % WIDTH, Math.floor(at / WIDTH)) || !equals(colorAt(picture, at), PLAIN_STYLE.inkColor)) continue;
    ink++;
    runs[at] = 1 + Math.min(runs[at - 1], runs[at - WIDTH], runs[at - WIDTH - 1]);
  }
  return { ink, thickest: Math.max(...runs) };
}

/** The middle pixel under two sprites of two tints, far one first, and what blending one over the other gives there. */
export function blendedSprites(): { drawn: number[]; expected: number[] } {
  const puffs: LabPuff[] = [
    { place: [0, 0, -0.5], radius: 0.5, tint: 1, age: 0.25 },
    { place: [0, 0, 0.5], radius: 0.5, tint: 2, age: 0.5 },
  ];
  const backdrop = { top: [10, 20, 30], bottom: [10, 20, 30] } as const;
  const picture = takePicture({ width: WIDTH, height: HEIGHT, puffs, backdrop, style: { renderer: 'sprites' } });
  const expected = puffs.reduce<number[]>(
    (below, { tint, age }) => mix(below, PLAIN_STYLE.tints[tint! - 1], 0.5 * (1 - age!)),
    [...backdrop.top],
  );
  return { drawn: colorAt(picture, (HEIGHT / 2) * WIDTH + WIDTH / 2), expected };
}

/** How opaque the middle of a sprite is at some radii before a wall; a share of what it is far from it. */
export function softness(gap: number): number {
  const radius = 0.5;
  const wall = {
    name: 'wall',
    mesh: box([0, 0, -1], [3, 3, 1]),
    color: [0, 0, 0],
    casts: false,
    inked: false,
  } as const;
  const picture = takePicture({
    width: WIDTH,
    height: HEIGHT,
    puffs: [{ place: [0, 0, gap * radius], radius }],
    surfaces: [wall],
    style: { renderer: 'sprites', smokeColor: [255, 255, 255] },
  });
  return colorAt(picture, (HEIGHT / 2) * WIDTH + WIDTH / 2)[0] / (0.5 * 255);
}

function colorAt({ pixels }: LabPicture, at: number): number[] {
  return [...pixels.subarray(4 * at, 4 * at + 3)];
}

function colorsOf({ pixels }: LabPicture): Set<number> {
  return new Set(new Uint32Array(pixels.buffer));
}

function equals(a: readonly number[], b: readonly number[]): boolean {
  return a.every((value, channel) => value === b[channel]);
}

function mix(below: readonly number[], above: Color, alpha: number): number[] {
  return below.map((value, channel) => value * (1 - alpha) + above[channel] * alpha);
}
