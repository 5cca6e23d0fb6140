/** The lines of the renderer `selle`. */
import type { PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { frontCamera, PLAIN_STYLE, takePicture, type LabPicture } from '../../lab.ts';

const WIDTH = 200;
const HEIGHT = 160;

/** Ink along the inner side of circles around the centre of the picture. */
export interface LineReport {
  /** Pixels that must be ink: inside a circle, with a 4-neighbour outside it. */
  line: number;
  /** `line` pixels without ink, and ink pixels elsewhere. */
  missing: number;
  extra: number;
  /** Side of the largest square of ink, pixels. */
  thickest: number;
  /** Whether every line is closed for 4-connected steps. */
  isClosed: boolean;
  colors: number;
}

/** Tolerance in pixels, because the silhouette is sampled from a texture. */
const SLACK = 0.25;
const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];

/**
 * The lines of a ball in front of a larger ball, for a share of the threshold: around both, or around the larger one
 * only.
 */
export function depthLines(share: number): LineReport {
  const radii = [0.3, 0.9];
  const threshold = PLAIN_STYLE.innerLine * ((radii[0] + radii[1]) / 2);
  const places = [share * threshold, 0];
  const camera = frontCamera(WIDTH, HEIGHT);
  const picture = takePicture({
    width: WIDTH,
    height: HEIGHT,
    puffs: radii.map((radius, index) => ({ place: [0, 0, places[index]], radius })),
    shapes: BALL,
    camera,
    style: { renderer: 'selle' },
  });
  const pixelsPerUnit = (HEIGHT / 2) * camera.projectionMatrix.elements[5];
  const circles = radii.map((radius, index) => (radius * pixelsPerUnit) / (camera.position.z - places[index]));
  const outlined = share > 1 ? circles : circles.slice(1);
  const isInk = Array.from({ length: WIDTH * HEIGHT }, (_, at) => equals(colorAt(picture, at), PLAIN_STYLE.inkColor));
  const report = { line: 0, missing: 0, extra: 0 };
  isInk.forEach((ink, at) => {
    const [least, most] = [-SLACK, SLACK].map((slack) => outlined.some((radius) => isLine(at, radius, slack)));
    if (least) report.line++;
    if (least && !ink) report.missing++;
    if (!most && ink) report.extra++;
  });
  return {
    ...report,
    thickest: thickestOf(isInk),
    isClosed: outlined.every((radius) => !leaksFrom(radius, isInk)),
    colors: colorsOf(picture).size,
  };
}

/** Whether a pixel is inside a circle and a 4-neighbour outside, each by at least `slack` pixels. */
function isLine(at: number, radius: number, slack: number): boolean {
  const beside = NEIGHBOURS.map((step) => fromMiddle(at + step));
  return fromMiddle(at) < radius + slack && Math.max(...beside) > radius - slack;
}

const NEIGHBOURS = [1, -1, WIDTH, -WIDTH];

/** Distance between the centre of a pixel and the centre of the picture, pixels. */
function fromMiddle(at: number): number {
  return Math.hypot((at % WIDTH) + 0.5 - WIDTH / 2, Math.floor(at / WIDTH) + 0.5 - HEIGHT / 2);
}

/** Side of the largest square of ink, pixels. */
function thickestOf(isInk: readonly boolean[]): number {
  const sides = new Int32Array(isInk.length);
  isInk.forEach((ink, at) => {
    if (ink) sides[at] = 1 + Math.min(sides[at - 1], sides[at - WIDTH], sides[at - WIDTH - 1]);
  });
  return Math.max(...sides);
}

/** Whether a 4-connected path from just inside a circle's line leaves the circle without crossing ink. */
function leaksFrom(radius: number, isInk: readonly boolean[]): boolean {
  const start = (HEIGHT / 2) * WIDTH + WIDTH / 2 + Math.floor(radius) - 3;
  const seen = new Set([start]);
  for (const at of seen) {
    if (fromMiddle(at) > radius + 2) return true;
    for (const step of NEIGHBOURS) if (!isInk[at + step]) seen.add(at + step);
  }
  return false;
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
