/**
 * The site's own copy of the script for CDNs, with its simulator, which the share sheet's embed code references. The
 * name of its folder is a content hash, so that a page with an integrity hash never gets another version.
 */

import { cpSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { inRoot } from '../lib/paths.mjs';
import { bundleScript } from '../package/bundle.mjs';
import { sourceMaps, writeLicenses } from '../package/licenses.mjs';
import { integrity } from '../package/measure.mjs';

const FILE = 'cartoon-smoke.min.js';
// Not in the site's folder, because the bundler empties it first.
const MADE = '.cache/element';

/**
 * @typedef {object} ElementScript
 * @property {string} path in the site
 * @property {string} integrity for `<script integrity>`
 */

/** @returns {Promise<ElementScript & { copyTo(site: string): void }>} */
export async function buildElementScript() {
  const made = inRoot(MADE);
  rmSync(made, { recursive: true, force: true });
  await bundleScript(made);
  await writeLicenses(made);
  for (const map of sourceMaps(made)) rmSync(map);
  const hash = integrity(join(made, FILE));
  const folder = `element/${nameOf(hash)}`;
  return {
    path: `${folder}/${FILE}`,
    integrity: hash,
    copyTo: (site) => cpSync(made, join(site, folder), { recursive: true }),
  };
}

/**
 * Finds the script in a built site.
 *
 * @param {string} site folder
 * @returns {string} path in the site
 */
export function elementScriptIn(site) {
  const [folder] = readdirSync(join(site, 'element'));
  return `element/${folder}/${FILE}`;
}

/**
 * A short URL-safe name.
 * @param {string} hash
 */
function nameOf(hash) {
  return hash
    .replace(/^sha384-/, '')
    .replace(/[^A-Za-z0-9]/g, '')
    .slice(0, 12);
}
