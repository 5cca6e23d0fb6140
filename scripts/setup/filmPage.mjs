/** The page that `npm run film` opens, and whether it was built from the current sources. */

import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';
import { digestOf } from './sources.mjs';

export const title = 'Film page';
export const FOLDER = '.cache/film';

const SOURCES = ['package-lock.json', 'scripts/package', 'scripts/patches', 'shaders', 'src'];
const STAMP = '.cache/film.txt';

export function isFresh() {
  if (!existsSync(inRoot(`${FOLDER}/page.js`)) || !existsSync(inRoot(STAMP))) return false;
  return readFileSync(inRoot(STAMP), 'utf8') === digestOf(SOURCES);
}

export async function bring() {
  const before = digestOf(SOURCES);
  rmSync(inRoot(FOLDER), { recursive: true, force: true });
  // Imported late, because the packages may not be installed when this module loads.
  const { bundleFilmPage } = await import('../package/bundle.mjs');
  await bundleFilmPage(inRoot(FOLDER));
  writeFileSync(inRoot(STAMP), before);
}
