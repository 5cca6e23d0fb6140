import { expect, test } from '../../../../support/fixtures.ts';
import type { InkPixel } from './strokes.cases.ts';

type Cases = typeof import('./strokes.cases.ts');
type Seek = typeof import('./seek.cases.ts');
type Steadiness = typeof import('./steadiness.cases.ts');
const CASES = '/tests/visual/renderer/passes/strokes/strokes.cases.ts';
/** Width of lines, CSS pixels. */
const WIDTH = 4;
/** The lobe of the cases: centre and radius in puff radii; 100 CSS pixels are a metre. */
const LOBE = { x: 0.1, y: -0.05, radius: 0.45 };
/** Parts that a stroke is measured in. */
const PARTS = 9;

/** Angle of a pixel about the middle of a stroke, radians, and its place across it. */
interface PolarPixel {
  angle: number;
  across: number;
  opacity: number;
}

/** @param outline distance of a pixel from the outline, CSS pixels, positive outside */
function placesOf(ink: readonly InkPixel[], outline: (x: number, y: number) => number, radius = 1): PolarPixel[] {
  const [x, y] = [100 * radius * LOBE.x, 100 * radius * LOBE.y];
  const vectors = ink.map((pixel) => ({ x: pixel.x - x, y: pixel.y - y, opacity: pixel.opacity }));
  const sum = vectors.reduce((all, each) => ({ x: all.x + each.x, y: all.y + each.y, opacity: 0 }));
  const middle = Math.atan2(sum.y, sum.x);
  return vectors.map((at) => {
    const angle = Math.atan2(at.y, at.x) - middle;
    return { angle: Math.atan2(Math.sin(angle), Math.cos(angle)), across: outline(at.x, at.y), opacity: at.opacity };
  });
}

const circle = (radius: number) => (x: number, y: number) => Math.hypot(x, y) - 100 * radius * LOBE.radius;

/** Length of a stroke, CSS pixels, and mean width and place of each of its parts. */
function measure(places: readonly PolarPixel[], radius: number, pixelRatio: number) {
  const angles = places.map(({ angle }) => angle);
  const [from, to] = [Math.min(...angles), Math.max(...angles)];
  const length = (to - from) * 100 * radius * LOBE.radius;
  const parts = Array.from({ length: PARTS }, (_, part) => {
    const inside = places.filter(({ angle }) => Math.floor((PARTS * (angle - from)) / (to - from + 1e-9)) === part);
    const area = inside.reduce((sum, { opacity }) => sum + opacity, 0) / pixelRatio ** 2;
    const across = inside.reduce((sum, place) => sum + place.across, 0) / inside.length;
    return { width: (PARTS * area) / length, across };
  });
  return { length, parts };
}

test('a stroke lies on the outline of its lobe, has the width of lines in the middle and tapers to both ends', async ({
  load,
}) => {
  const cases = await load<Cases>(CASES);
  const seed = await cases.evaluate((module) => module.seedWithStroke());
  expect(seed).toBeGreaterThanOrEqual(0);
  const lengths: number[] = [];
  for (const pixelRatio of [1, 2]) {
    const ink = await cases.evaluate((module, given) => module.inkOf(...given), [1, seed, pixelRatio] as const);
    const places = placesOf(ink, circle(1));
    for (const { across } of places) expect(Math.abs(across)).toBeLessThan(WIDTH / 2 + 0.75 / pixelRatio);
    const { length, parts } = measure(places, 1, pixelRatio);
    for (const { across } of parts.slice(1, -1)) expect.soft(Math.abs(across)).toBeLessThan(0.5);
    const widths = parts.map(({ width }) => width);
    expect.soft(widths[4]).toBeGreaterThan(0.9 * WIDTH);
    expect.soft(widths[4]).toBeLessThan(1.1 * WIDTH);
    for (const part of [0, 1, 2, 3]) {
      expect.soft(widths[part]).toBeLessThan(widths[part + 1] + 0.05 * WIDTH);
      expect.soft(widths[8 - part]).toBeLessThan(widths[7 - part] + 0.05 * WIDTH);
    }
    expect.soft(Math.max(widths[0], widths[8])).toBeLessThan(0.5 * WIDTH);
    lengths.push(length);
  }
  expect(Math.abs(lengths[0] - lengths[1])).toBeLessThan(2);
});

test('a stroke is at least 12 CSS pixels long, or there is none @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const seed = await cases.evaluate((module) => module.seedWithStroke());
  for (const pixelRatio of [1, 2]) {
    const lengths: number[] = [];
    for (let radius = 0.1; radius < 0.8; radius += 0.05) {
      const ink = await cases.evaluate((module, given) => module.inkOf(...given), [radius, seed, pixelRatio] as const);
      const places = ink.length > 0 ? placesOf(ink, circle(radius), radius) : [];
      lengths.push(places.length > 0 ? measure(places, radius, pixelRatio).length : 0);
    }
    expect.soft(lengths[0]).toBe(0);
    expect.soft(lengths.at(-1)).toBeGreaterThan(30);
    expect.soft(Math.min(...lengths.filter((length) => length > 0))).toBeGreaterThan(12);
    expect.soft(lengths).toEqual(lengths.toSorted((a, b) => a - b));
  }
});

test('what smoke in front leaves of a stroke is as long, or nothing @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const seed = await cases.evaluate((module) => module.seedWithStroke());
  const whole = await cases.evaluate((module, given) => module.inkOf(1, given, 1), seed);
  const sum = whole.reduce((all, { x, y }) => [all[0] + x - 100 * LOBE.x, all[1] + y - 100 * LOBE.y], [0, 0]);
  // Across the middle of the stroke, so that one of its ends is left.
  const toward = Math.atan2(sum[1], sum[0]) + Math.PI / 2;
  const shifts = Array.from({ length: 16 }, (_, step) => 2 * step);
  const amounts: number[][] = [];
  for (const pixelRatio of [1, 2]) {
    const given = [seed, toward, shifts, pixelRatio] as const;
    const left = await cases.evaluate((module, all) => module.leftByBall(...all), given);
    const lengths = left.map((ink) => (ink.length > 0 ? measure(placesOf(ink, circle(1)), 1, pixelRatio).length : 0));
    expect.soft(lengths[0]).toBe(0);
    expect.soft(lengths.at(-1)).toBeGreaterThan(20);
    expect.soft(Math.min(...lengths.filter((length) => length > 0))).toBeGreaterThan(12);
    // A weak stroke is thin, not pale.
    for (const ink of left.filter(({ length }) => length > 0))
      expect.soft(Math.max(...ink.map(({ opacity }) => opacity))).toBeGreaterThan(0.95);
    amounts.push(left.map((ink) => ink.reduce((all, { opacity }) => all + opacity, 0) / pixelRatio ** 2));
  }
  for (const [index, amount] of amounts[0].entries()) expect.soft(Math.abs(amount - amounts[1][index])).toBeLessThan(8);
});

test('strokes of stretched puffs lie on the ellipse of their lobe', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const seed = await cases.evaluate((module) => module.seedWithStroke());
  const ink = await cases.evaluate((module, given) => module.inkOfStretched(given), seed);
  expect(ink.length).toBeGreaterThan(100);
  const [a, b] = [Math.SQRT1_2, Math.SQRT2].map((factor) => 80 * factor * LOBE.radius);
  const [x, y] = [80 * Math.SQRT1_2 * LOBE.x, 80 * Math.SQRT2 * LOBE.y];
  const distances = ink.map((at) => {
    const [u, v] = [(at.x - x) / a, (at.y - y) / b];
    return (Math.hypot(u, v) - 1) / (Math.hypot(u / a, v / b) / Math.hypot(u, v));
  });
  expect.soft(Math.max(...distances.map(Math.abs))).toBeLessThan(WIDTH / 2 + 0.75);
  expect.soft(Math.abs(distances.reduce((sum, each) => sum + each, 0) / ink.length)).toBeLessThan(0.5);
});

test('strokes lie on the shaded side of their lobes', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { shaded, lit, puffs } = await cases.evaluate((module) => module.sides());
  expect.soft(puffs).toBeGreaterThan(75);
  expect.soft(shaded / (shaded + lit)).toBeGreaterThan(0.8);
});

test('more strokes keep those that are there, and none change nothing @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { ink, lost, atZero } = await cases.evaluate((module) => module.amounts([0.1, 0.3, 0.5, 0.7, 1]));
  expect.soft(atZero).toBe(0);
  expect.soft(lost).toBe(0);
  for (let index = 1; index < ink.length; index++) expect.soft(ink[index]).toBeGreaterThan(ink[index - 1]);
});

test('the order of particles changes no pixel', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { changed, ink } = await cases.evaluate((module) => module.changedByOrder());
  expect.soft(ink).toBeGreaterThan(200);
  expect.soft(changed).toBe(0);
});

test('strokes are drawn before smoke only, and are lines', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.inkWithoutSmokeBehind())).toEqual([0, 0, 0]);
});

test('smoke in front hides a stroke, and none is outside the silhouette', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const seed = await cases.evaluate((module) => module.seedWithStroke());
  const ink = await cases.evaluate((module, given) => module.inkOf(1, given, 1), seed);
  const { x, y } = ink[Math.floor(ink.length / 3)];
  // The second ball is smaller than the distance between samples of the arc.
  for (const radius of [0.16, 0.025]) {
    const seen = await cases.evaluate((module, given) => module.behindBall(...given), [seed, x, y, radius] as const);
    expect.soft(seen.covered).toBeGreaterThan(0);
    expect.soft(seen.covered).toBeLessThan(seen.bare);
    expect.soft(seen.over).toBe(0);
    expect.soft(seen.outside).toBe(0);
  }
});

test('the opacity of a stroke changes by at most 1/6 in 1/60 s @long', async ({ load }) => {
  const cases = await load<Steadiness>('/tests/visual/renderer/passes/strokes/steadiness.cases.ts');
  const changes = await cases.evaluate((module) => module.changesOfOpacity('lamp', [840], 24));
  expect.soft(changes.length).toBeGreaterThan(100);
  expect.soft(Math.max(...changes)).toBeGreaterThan(0.02);
  expect.soft(Math.max(...changes)).toBeLessThan(1 / 6);
});

test('a stroke that is reached by a seek equals that of playback to the bit @long', async ({ load }) => {
  const cases = await load<Seek>('/tests/visual/renderer/passes/strokes/seek.cases.ts');
  const { ink, ...differing } = await cases.evaluate((module) => module.seekToStrokes());
  expect.soft(ink).toBeGreaterThan(20);
  expect.soft(differing).toEqual({ back: 0, direct: 0 });
});
