/**
 * `npm run thumbnails [-- NAME...]`: renders the named presets, or all, as gallery thumbnails into public/thumbnails and
 * as posters of the page into src/demo/posters. Run it after adding a preset or changing its appearance.
 */

import { mkdirSync, writeFileSync } from 'node:fs';
import { evaluateInPage } from '../tests/bench/support/page.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude } from './lib/userError.mjs';
import { PICTURES, setUp } from './setup/setup.mjs';

const THUMBNAILS = 'public/thumbnails';
const POSTERS = 'src/demo/posters';

/** @typedef {{ thumbnail: string, posters: Record<string, string> }} Pictures base64 */

await conclude(async () => {
  await setUp(PICTURES);
  const names = process.argv.slice(2);
  const draw = `Promise.all([import('/tests/visual/demo/thumbnails.cases.ts'), import('/src/parameters/presets.ts')]).then(
    async ([{ thumbnail, posters }, { presets }]) => {
      const given = ${JSON.stringify(names)};
      const made = {};
      for (const name of given.length > 0 ? given : presets.map((preset) => preset.name)) {
        await sayProgress(name);
        made[name] = { thumbnail: await thumbnail(name), posters: await posters(name) };
      }
      return made;
    })`;
  const made = await evaluateInPage(draw, (name) => console.log(`Drawing ${name}`));
  for (const folder of [THUMBNAILS, POSTERS]) mkdirSync(inRoot(folder), { recursive: true });
  for (const [name, { thumbnail, posters }] of Object.entries(/** @type {Record<string, Pictures>} */ (made))) {
    write(`${THUMBNAILS}/${name}.webp`, thumbnail);
    for (const [suffix, picture] of Object.entries(posters)) write(`${POSTERS}/${name}.${suffix}.webp`, picture);
  }
  console.log(`Wrote pictures of ${Object.keys(Object(made)).length} presets to ${THUMBNAILS} and ${POSTERS}.`);
});

function write(/** @type {string} */ path, /** @type {string} */ picture) {
  writeFileSync(inRoot(path), Buffer.from(picture, 'base64'));
}
