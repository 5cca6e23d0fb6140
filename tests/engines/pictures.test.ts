/** Every scene looks the same as in Chromium, but for a few pixels. */
import { beforeAll, describe, expect } from 'vitest';
import { sceneEntries } from '../../src/scenes/scenes.ts';
import { compare } from '../support/goldens.ts';
import { findEngines, start } from './engines.ts';
import { blankPage, engine, inPage, test } from './fixtures.ts';
import { colorsIn, pictureIn } from './pictures.ts';

type Page = typeof import('./page/stages.ts');

const STAGES = '/tests/engines/page/stages.ts';
const [SECONDS, WIDTH, HEIGHT] = [3, 240, 160] as const;
/** The share of the pixels that may differ, in any channel by any amount. */
const MOST = 0.005;
/** Playwright draws with whatever the system has. */
const RENDERERS = { Chromium: /SwiftShader/, Firefox: /llvmpipe/, WebKit: /llvmpipe/ };

if (engine.title === 'Chromium' || !engine.isPlaywrights) {
  test('it draws in software', async ({ browser, task }) => {
    const renderer = await browser.renderer();
    task.meta.note = `renderer  ${engine.title}  ${renderer}`;
    expect(renderer).toMatch(RENDERERS[engine.title]);
  });
}

if (engine.title !== 'Chromium') {
  describe('pictures', () => {
    const expected = new Map<string, string>();
    const scenes = Object.keys(sceneEntries);

    beforeAll(async () => {
      const chromium = await start((await findEngines())[0]);
      await chromium.open(blankPage());
      const page = inPage<Page>(chromium, STAGES);
      for (const scene of scenes) expected.set(scene, await page.pictureOf(scene, SECONDS, WIDTH, HEIGHT));
      await chromium.close();
    });

    test.for(scenes)('%s', async (scene, { load, task }) => {
      const page = await load<Page>(STAGES);
      const found = pictureIn(await page.pictureOf(scene, SECONDS, WIDTH, HEIGHT));
      const wanted = pictureIn(expected.get(scene)!);
      expect(colorsIn(wanted)).toBeGreaterThan(20);
      const share = compare(found, wanted, 0).outliers / (WIDTH * HEIGHT);
      task.meta.note = `picture  ${scene}  ${engine.title}  ${(100 * share).toFixed(2)} % of the pixels differ from Chromium's`;
      expect(share).toBeLessThanOrEqual(MOST);
    });
  });
}
