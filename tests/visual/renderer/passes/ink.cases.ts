/** Ink lines around puffs: width in pixels, near and far, and the lines of the smallest puffs. */
import { OrthographicCamera, type PerspectiveCamera } from 'three';
import type { PuffForm } from '../../../../src/renderer/gpu/puffTextures.ts';
import { middleOf } from '../../../../src/renderer/puffs/normals.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { orientationOf, rotatedLobes } from '../../../../src/renderer/puffs/orientation.ts';
import { frontCamera, Lab, PLAIN_STYLE, takePicture, type LabPuff } from '../../lab.ts';
import { random } from '../../random.ts';
import { roundedRoll, seenOf } from './puffs.cases.ts';

const SIZE = 200;
const RADIUS = 0.5;
/** Of the perspective camera, degrees. */
const FIELD_OF_VIEW = 40;

export type Projection = 'perspective' | 'orthographic';

/** A lone puff and its expected line. */
export interface LineCase {
  form: PuffForm;
  projection: Projection;
  /** Distance of the camera, metres. */
  distance: number;
  /** Pixels of the picture per CSS pixel. */
  pixelRatio: number;
  /** CSS pixels. */
  outlineWidth: number;
  inkSwell?: number;
  boil?: number;
}

/** Largest distance of a pixel from the line's border if it is on the wrong side of it, and the pixels of ink. */
export interface LineReport {
  worst: number;
  ink: number;
  expectedWidth: number;
  radius: number;
  /** Where the line's colour differs most from the expected colour: its position between smoke (0) and ink (1). */
  share: number;
  expectedShare: number;
}

/**
 * A pixel at least this far inside the line's borders is always line, also in a form that samples its distances,
 * pixels.
 */
const SURELY = 0.5;

const TOWARDS_LIGHT = [0.48, 0.64, 0.6] as const;

/** Line width around a puff of a radius, all in pixels. The formula of shaders/lib/ink.glsl. */
function lineWidth(fullWidth: number, radius: number): number {
  return fullWidth * smoothStep(1, 3.5, radius / fullWidth);
}

/** Ink share of the line's colour. The formula of shaders/lib/ink.glsl. */
function inkShare(width: number, fullWidth: number, radius: number): number {
  return smoothStep(0.5, 1, width) * smoothStep(1.5, 3, radius / fullWidth);
}

function smoothStep(from: number, to: number, value: number): number {
  const t = Math.min(1, Math.max(0, (value - from) / (to - from)));
  return t * t * (3 - 2 * t);
}

/** Factor on the line width at a direction of the image plane around the puff. */
function swelling(swell: number, x: number, y: number): number {
  return 2 ** ((-swell * (x * TOWARDS_LIGHT[0] + y * TOWARDS_LIGHT[1])) / Math.hypot(x, y));
}

/** Number of the pictures' drawing; there are twelve drawings per second. */
const DRAWING = 7;

/** Factor of the boil on the line width, at a direction around the puff. */
function trembling(boil: number, seed: number, x: number, y: number): number {
  const hashed = Math.imul(seed, 747796405) + Math.imul(DRAWING, 2891336453);
  const bits = Math.imul(hashed ^ (hashed >>> 16), 73244475) >>> 0;
  const phase = ((bits >>> 8) & 0xffff) * ((2 * Math.PI) / 65536);
  const angle = Math.atan2(y, x);
  return 1 - boil * (0.25 + 0.125 * (Math.sin(3 * angle + phase) + Math.sin(8 * angle - 2.7 * phase)));
}

/** Compares the lines of lone puffs, pixel by pixel, with silhouette distances that the CPU computes. */
export function measureLines(cases: readonly LineCase[]): LineReport[] {
  const lab = new Lab({ width: SIZE, height: SIZE, puffs: [] });
  const reports = cases.map((line, index) => measureLine(lab, line, index % 4));
  lab.dispose();
  return reports;
}

function measureLine(lab: Lab, line: LineCase, variation: number): LineReport {
  const { form, distance, pixelRatio, outlineWidth, inkSwell = 0, boil = 0 } = line;
  const [seed, roll] = form === 'lobes' ? [61 * variation, 1 + variation] : [0, 0];
  const puff: LabPuff = { place: [0, 0, 0], radius: RADIUS, variation, seed, roll };
  const style = { form, outlineWidth, inkSwell, boil, shadows: false, tones: 1 } as const;
  const scene = { width: SIZE, height: SIZE, puffs: [puff], camera: cameraOf(line), towardsLight: TOWARDS_LIGHT };
  const { pixels } = lab.draw({ ...scene, style, pixelRatio, time: (DRAWING + 0.5) / 12 });
  const radius = (SIZE / 2 / Math.tan((FIELD_OF_VIEW / 2) * (Math.PI / 180))) * (RADIUS / distance);
  const fullWidth = outlineWidth * pixelRatio * 2 ** inkSwell;
  const expectedWidth = lineWidth(fullWidth, radius) / 2 ** inkSwell;
  const expectedShare = inkShare(expectedWidth, fullWidth, radius);
  const seen = seenOf(form, variation, seed, roundedRoll(roll));
  const middle =
    form === 'lobes' ? middleOf(rotatedLobes(orientationOf(seed, roll), LOBE_SHAPES[variation].lobes)) : [0, 0];
  const report = { worst: 0, ink: 0, expectedWidth, radius, share: expectedShare, expectedShare };
  for (let pixel = 0; pixel < SIZE * SIZE; pixel++) {
    const [x, y] = [pixel % SIZE, Math.floor(pixel / SIZE)].map((at) => (at + 0.5 - SIZE / 2) / radius);
    const outside = Math.max(Math.abs(x), Math.abs(y)) < 2 ? seen(x, y).distance * radius : 2 * radius;
    const isInk = pixels[4 * pixel + 3] > 0 && isDark(pixels, pixel);
    if (isInk) report.ink++;
    const [besideX, besideY] = [x - middle[0], y - middle[1]];
    const width = expectedWidth * swelling(inkSwell, besideX, besideY) * trembling(boil, seed, besideX, besideY);
    if (outside > SURELY && outside < width - SURELY) keepWorstShare(report, shareAt(pixels, pixel));
    if (isInk === (outside > 0 && outside <= width)) continue;
    report.worst = Math.max(report.worst, Math.min(Math.abs(outside), Math.abs(outside - width)));
  }
  return report;
}

function cameraOf({ projection, distance }: LineCase): PerspectiveCamera | OrthographicCamera {
  if (projection === 'perspective') return frontCamera(SIZE, SIZE, distance, FIELD_OF_VIEW);
  const half = distance * Math.tan((FIELD_OF_VIEW / 2) * (Math.PI / 180));
  const camera = new OrthographicCamera(-half, half, half, -half, 0.1, 100);
  camera.position.set(0, 0, distance);
  camera.updateMatrixWorld();
  return camera;
}

function keepWorstShare(report: LineReport, share: number): void {
  const error = (one: number): number => Math.abs(one - report.expectedShare);
  if (error(share) > error(report.share)) report.share = share;
}

/** Position of a pixel's colour between smoke (0) and ink (1). */
function shareAt(pixels: Uint8Array, pixel: number): number {
  const [red] = PLAIN_STYLE.inkColor;
  const [smokeRed] = PLAIN_STYLE.smokeColor;
  return (smokeRed - pixels[4 * pixel]) / (smokeRed - red);
}

/** Closer to ink than to smoke. */
function isDark(pixels: Uint8Array, pixel: number): boolean {
  return shareAt(pixels, pixel) > 0.5;
}

/**
 * Pixels of a boiling line that change between drawings, change within one drawing, and extend beyond a line without
 * boil.
 */
export function boiling(form: PuffForm): { between: number; within: number; beyond: number; ink: number } {
  const puffs: LabPuff[] = [{ place: [0, 0, 0], radius: 0.8, seed: 9 }];
  const lab = new Lab({ width: SIZE, height: SIZE, puffs });
  const draw = (boil: number, time: number): Uint8Array =>
    lab.draw({ width: SIZE, height: SIZE, puffs, time, style: { form, boil, outlineWidth: 4, shadows: false } }).pixels;
  const [still, first, again, next] = [draw(0, 1), draw(1, 1), draw(1, 1.05), draw(1, 1.1)];
  lab.dispose();
  const all = Array.from({ length: SIZE * SIZE }, (_, pixel) => pixel);
  const unlike = (a: Uint8Array, b: Uint8Array): number => all.filter((pixel) => a[4 * pixel] !== b[4 * pixel]).length;
  const beyond = all.filter((pixel) => first[4 * pixel + 3] > still[4 * pixel + 3]).length;
  const isInk = (pixel: number): boolean => first[4 * pixel + 3] > 0 && isDark(first, pixel);
  return { between: unlike(first, next), within: unlike(first, again), beyond, ink: all.filter(isInk).length };
}

/** A distant plume with puffs of one or two pixels: covered pixels, and those darker than smoke. */
export function farPlume(form: PuffForm): { covered: number; dark: number } {
  const next = random(8);
  const puffs = Array.from({ length: 600 }, (_, index): LabPuff => {
    const height = index / 600;
    const spread = 0.3 + height;
    return {
      place: [spread * (next() - 0.5), 3 * height - 1.5, spread * (next() - 0.5)],
      radius: 0.03 + 0.05 * next(),
      roll: next() * 2 * Math.PI,
      variation: index % 4,
      seed: Math.floor(256 * next()),
    };
  });
  const style = { form, shadows: false, tones: 1 } as const;
  const picture = takePicture({ width: SIZE, height: SIZE, puffs, camera: frontCamera(SIZE, SIZE, 9), style });
  const isCovered = (pixel: number): boolean => picture.pixels[4 * pixel + 3] > 0;
  const covered = Array.from({ length: SIZE * SIZE }, (_, pixel) => pixel).filter(isCovered);
  const smoke = PLAIN_STYLE.smokeColor;
  const dark = covered.filter((pixel) => picture.pixels[4 * pixel] < smoke[0]);
  return { covered: covered.length, dark: dark.length };
}
