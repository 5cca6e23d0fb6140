/** `npm run film -- LINK --frames 0-239 --out FOLDER`: renders a shot to files; docs/film.md has the options. */

import { readFileSync } from 'node:fs';
import { film } from './film/film.mjs';
import { readFilmOptions, USAGE } from './film/options.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude } from './lib/userError.mjs';
import * as filmPage from './setup/filmPage.mjs';
import { setUp, TESTS } from './setup/setup.mjs';

await conclude(async () => {
  const words = process.argv.slice(2);
  if (words.includes('--help')) return console.log(`Usage: ${USAGE.replace('cartoon-smoke film', 'npm run film --')}`);
  // Before the set-up, which can take minutes.
  readFilmOptions(words);
  await setUp([...TESTS, filmPage]);
  const { version } = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));
  return film(words, { page: inRoot(filmPage.FOLDER), wasm: inRoot('src/simulator/wasm') }, version);
});
