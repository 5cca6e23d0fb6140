/**
 * `npm run thumbnails [-- NAME...]`: renders the named presets, or all, as gallery thumbnails into public/thumbnails.
 * Run it after adding a preset or changing its appearance.
 */

import { mkdirSync, writeFileSync } from 'node:fs';
import { evaluateInPage } from '../tests/bench/support/page.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude } from './lib/userError.mjs';
import { PICTURES, setUp } from './setup/setup.mjs';

await conclude(async () => {
  await setUp(PICTURES);
  const names = process.argv.slice(2);
  const draw = `Promise.all([import('/tests/visual/app/thumbnails.cases.ts'), import('/src/preset/presets.ts')]).then(
    async ([{ thumbnail }, { presets }]) => {
      const given = ${JSON.stringify(names)};
      const made = {};
      for (const name of given.length > 0 ? given : presets.map((preset) => preset.name)) {
        await sayProgress(name);
        made[name] = await thumbnail(name);
      }
      return made;
    })`;
  const made = await evaluateInPage(draw, (name) => console.log(`Drawing ${name}`));
  mkdirSync(inRoot('public/thumbnails'), { recursive: true });
  for (const [name, picture] of Object.entries(/** @type {Record<string, string>} */ (made))) {
    writeFileSync(inRoot(`public/thumbnails/${name}.webp`), Buffer.from(picture, 'base64'));
  }
  console.log(`Wrote ${Object.keys(Object(made)).length} pictures to public/thumbnails.`);
});
