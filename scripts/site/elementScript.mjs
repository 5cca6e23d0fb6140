/**
 * The site's own copy of the script for CDNs, with its simulator: what the share sheet's code for the element names. It
 * stands in a folder that is named after its content, so that a page that pins it by its hash never gets another one.
 */

import { cpSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { inRoot } from '../lib/paths.mjs';
import { bundleScript } from '../package/bundle.mjs';
import { writeLicenses } from '../package/licenses.mjs';
import { integrity } from '../package/measure.mjs';

const FILE = 'cartoon-smoke.min.js';
// Here and not in the site, whose bundler empties it first.
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
  const hash = integrity(join(made, FILE));
  const folder = `element/${nameOf(hash)}`;
  return {
    path: `${folder}/${FILE}`,
    integrity: hash,
    copyTo: (site) => cpSync(made, join(site, folder), { recursive: true }),
  };
}

/** Short, and fit for an address. @param {string} hash */
function nameOf(hash) {
  return hash
    .replace(/^sha384-/, '')
    .replace(/[^A-Za-z0-9]/g, '')
    .slice(0, 12);
}
