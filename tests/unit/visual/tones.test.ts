import { expect, test } from 'vitest';
import {
  birthsBetween,
  borderOf,
  countCrumbs,
  countSmall,
  flipsBetween,
  NO_SMOKE,
  regionsOf,
  type Tones,
} from '../../visual/renderer/tones.ts';

/** A picture of lines of digits; a dot is no smoke. */
function picture(...lines: string[]): Tones {
  const tones = Int32Array.from(lines.join(''), (sign) => (sign === '.' ? NO_SMOKE : Number(sign)));
  return { width: lines[0].length, height: lines.length, tones };
}

test('regions are connected by sides, and end at other tones and where there is no smoke', () => {
  const regions = regionsOf(picture('11.1', '2211', '2.22'));
  expect(regions.map(({ tone, pixels }) => [tone, pixels.length])).toEqual([
    [1, 2],
    [1, 3],
    [2, 3],
    [2, 2],
  ]);
});

test('regions of 4 to 59 pixels are small', () => {
  const sized = (area: number) => ({ tone: 1, pixels: Array.from({ length: area }, (_, pixel) => pixel) });
  expect(countSmall([3, 4, 59, 60].map(sized))).toBe(2);
});

test('pieces of the silhouette of 4 to 499 pixels are crumbs, except for the largest piece', () => {
  const whole = ['12211111.', '1221111..', '.........', '11.......', '21...111.'];
  // The square of two tones is one piece; three pixels are too few.
  expect(countCrumbs(picture(...whole))).toBe(1);
  expect(countCrumbs(picture('1111.2222', '1111.2222'))).toBe(1);
  expect(countCrumbs(picture('1111', '1111'))).toBe(0);
  const line = (area: number) => `${'1'.repeat(600)}.${'1'.repeat(area)}.${'1'.repeat(area)}`;
  expect(countCrumbs(picture(line(499)))).toBe(2);
  expect(countCrumbs(picture(line(500)))).toBe(0);
});

test('the border counts sides between tones, not sides of the smoke', () => {
  expect(borderOf(picture('112.', '1.2.', '1112'))).toBe(3);
});

test('flips are a share of the pixels that are smoke in both pictures', () => {
  expect(flipsBetween(picture('1122.'), picture('1.212'))).toBe(1 / 3);
});

test('a region is born if its tone was nowhere near, in smoke that was there before', () => {
  const [none, some] = ['111111', '122221'];
  const before = picture(none, none, none, none, none, none);
  const now = picture(none, some, some, some, some, none);
  expect(birthsBetween(before, now, 1)).toBe(1);
  expect(birthsBetween(picture(none, none, none, none, '111112', none), now, 1)).toBe(0);
  const air = '......';
  expect(birthsBetween(picture(air, air, air, air, air, none), now, 1)).toBe(0);
  expect(birthsBetween(before, picture(none, '122211', '122211', '122211', '122211', none), 1)).toBe(0);
});
