/**
 * `npm run bench -- site`: Lighthouse's scores of a guide and of a page with live examples in the built documentation.
 * Fails below the limits.
 */

import { inRoot } from '../../scripts/lib/paths.mjs';
import * as site from '../../scripts/setup/site.mjs';
import { INDEX_OF_PHONE, lighthouseFigures } from './load/lighthouse.mjs';

/** @typedef {import('../../scripts/bench/table.mjs').Figure} Figure */

const ALL = 95;

/** The lowest scores by category. A live example draws while it is measured. */
const PAGES = {
  guide: { path: 'docs/film.html', limits: { performance: ALL, accessibility: ALL, practices: ALL, seo: ALL } },
  live: { path: 'docs/style.html', limits: { performance: 90, accessibility: ALL, practices: ALL, seo: ALL } },
};

/** @param {import('./support/page.mjs').Choice} choice @returns {Promise<Figure[]>} */
export async function run({ quick, say }) {
  if (!site.isFresh()) await site.bring(say);
  return lighthouseFigures(inRoot('dist'), PAGES, quick ? 1 : 3, say);
}

/** @param {Figure[]} figures @returns {string[]} a sentence for each score that is too low */
export function failures(figures) {
  const valueOf = (/** @type {string} */ name) => figures.find((figure) => figure.name === name)?.value ?? 0;
  return Object.entries(PAGES).flatMap(([page, { limits }]) =>
    Object.entries(limits).flatMap(([category, limit]) => {
      const name = `lighthouse.${page}.${category}`;
      if (valueOf(name) >= limit) return [];
      const index = valueOf(`lighthouse.${page}.index`);
      const isSlow = category === 'performance' && index < INDEX_OF_PHONE;
      const why = isSlow ? `, on a machine slower than a phone: run it again while nothing else runs` : '';
      return [`${name} is ${valueOf(name)}, below ${limit}${why}.`];
    }),
  );
}
