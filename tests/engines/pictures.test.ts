/** Every preset looks the same in all engines, except for a few pixels. */
import { afterAll, beforeAll, expect, inject, test } from 'vitest';
import { presets } from '../../src/parameters/presets.ts';
import type { PresetName } from '../../src/parameters/valueTypes.ts';
import { compare } from '../support/goldens.ts';
import type { Driver } from './drivers/driver.ts';
import { start } from './engines.ts';
import { blankPage, inPage, type InPage } from './fixtures.ts';
import { colorsIn, pictureIn } from './pictures.ts';

type Page = typeof import('./page/stages.ts');

const [SECONDS, WIDTH, HEIGHT] = [3, 720, 480] as const;
/**
 * Share of the pixels that may differ, and tolerance of a channel: rasterizers place edges differently by fractions of
 * a pixel, and edges are a larger share of a smaller picture.
 */
const [MAX_SHARE, TOLERANCE] = [0.005, 16];
/** Dots, letters and cuts have more edges. */
const MORE_EDGES: Partial<Record<PresetName, number>> = {
  'airplane-manga': 0.03,
  'cloudscape-riso': 0.03,
  'cloudscape-woodcut': 0.01,
  'air-pow': 0.015,
};

const engines = inject('engines');
const browsers: Driver[] = [];
const pages: InPage<Page>[] = [];

beforeAll(async () => {
  for (const engine of engines) {
    const browser = await start(engine);
    browsers.push(browser);
    await browser.open(blankPage());
    pages.push(inPage<Page>(browser, '/tests/engines/page/stages.ts'));
  }
});

afterAll(async () => {
  for (const browser of browsers) await browser.close();
});

test.for(presets.map(({ name }) => name))('%s looks the same as in Chromium', async (preset, { task }) => {
  const drawn = await Promise.all(pages.map((page) => page.pictureOf(preset, SECONDS, WIDTH, HEIGHT)));
  const [wanted, ...others] = drawn.map(pictureIn);
  expect(colorsIn(wanted)).toBeGreaterThan(20);
  const shares = others.map((picture) => compare(picture, wanted, TOLERANCE).outliers / (WIDTH * HEIGHT));
  const notified = shares.map((share, at) => `${(100 * share).toFixed(2)} % in ${engines[at + 1].title}`);
  task.meta.note = `picture  ${preset}  differs from Chromium's in ${notified.join(', ')}`;
  expect(Math.max(...shares)).toBeLessThanOrEqual(MORE_EDGES[preset] ?? MAX_SHARE);
});
