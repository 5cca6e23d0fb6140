/** The documentation in dist/docs, and whether it was built from the current sources. */

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';
import { publishedAt } from '../site/published.mjs';
import { packagesIn } from './packages.mjs';
import { digestOf } from './sources.mjs';

const SOURCES = [
  'ARCHITECTURE.md',
  'CHANGELOG.md',
  'CONTRIBUTING.md',
  'SECURITY.md',
  'docs',
  'public/favicon.svg',
  'public/thumbnails',
  'scripts/site',
  'site/.vitepress',
  'site/package-lock.json',
  'site/typedoc.json',
  'site/typedoc.tsconfig.json',
  'src/demo/posters',
  'src/parameters',
];
const STAMP = '.cache/docs.txt';

/** Those of site/. */
export const packages = packagesIn('site', 'Packages of the documentation');

export function isFresh() {
  if (!existsSync(inRoot('dist/docs/index.html')) || !existsSync(inRoot(STAMP))) return false;
  return readFileSync(inRoot(STAMP), 'utf8') === digest();
}

/**
 * Builds it into dist/, which contains the pages of the site that it links to.
 *
 * @param {(line: string) => void} say
 * @param {boolean} [isWhole] whether to make what takes long, see `buildDocs`
 */
export async function bring(say, isWhole = false) {
  rmSync(inRoot(STAMP), { force: true });
  const before = digest();
  await build(inRoot('dist'), say, isWhole);
  mkdirSync(inRoot('.cache'), { recursive: true });
  writeFileSync(inRoot(STAMP), before);
}

/**
 * @param {string} folder of a built site
 * @param {(line: string) => void} say
 * @param {boolean} isWhole
 */
export async function build(folder, say, isWhole) {
  if (!packages.isFresh()) await packages.bring(say);
  // Imported late, because the packages may not be installed when this module loads.
  const { buildDocs } = await import('../site/docs.mjs');
  await buildDocs(folder, say, isWhole);
}

function digest() {
  return `${digestOf(SOURCES)} ${publishedAt() ?? ''}`;
}
