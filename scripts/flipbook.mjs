/** `npm run flipbook -- LINK --grid 8x8 --size 2048 --seconds 2 --out FOLDER`: a looped atlas; docs/film.md has the options. */

import { flipbook } from './film/flipbook.mjs';
import { FLIPBOOK_USAGE, readFlipbookOptions } from './film/options.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude } from './lib/userError.mjs';
import * as filmPage from './setup/filmPage.mjs';
import { setUp, TESTS } from './setup/setup.mjs';

await conclude(async () => {
  const words = process.argv.slice(2);
  if (words.includes('--help')) {
    return console.log(`Usage: ${FLIPBOOK_USAGE.replace('cartoon-smoke flipbook', 'npm run flipbook --')}`);
  }
  // Before the set-up, which can take minutes.
  readFlipbookOptions(words);
  await setUp([...TESTS, filmPage]);
  return flipbook(words, { page: inRoot(filmPage.FOLDER), wasm: inRoot('src/simulator/wasm') });
});
