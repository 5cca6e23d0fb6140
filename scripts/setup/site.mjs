/** The built site in dist/, and whether it was built from the current sources. */

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { publishedAt } from '../site/published.mjs';
import * as docs from './docs.mjs';
import { digestOf } from './sources.mjs';

export const title = 'Site';

const SOURCES = [
  'costs.html',
  'embed.html',
  'examples',
  'examples.html',
  'index.html',
  'overlay.html',
  'package-lock.json',
  'paper.html',
  'public',
  'puff.html',
  'scripts/package',
  'scripts/patches',
  'scripts/site',
  'shaders',
  'src',
  'vite.config.ts',
];
// Not in dist/, where it would be published.
const STAMP = '.cache/site.txt';

/** Whether dist/ was built from the current sources, including the WASM. */
export function isFresh() {
  return areAppsFresh() && docs.isFresh();
}

/** The same without the documentation. */
function areAppsFresh() {
  if (!existsSync(inRoot('dist/index.html')) || !existsSync(inRoot(STAMP))) return false;
  return readFileSync(inRoot(STAMP), 'utf8') === digest();
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  if (!areAppsFresh()) await bringApps(say);
  await docs.bring(say);
}

/**
 * Builds everything, as it is published.
 *
 * @param {(line: string) => void} say
 */
export async function bringWhole(say) {
  await bringApps(say);
  await docs.bring(say, true);
}

/** @param {(line: string) => void} say */
async function bringApps(say) {
  rmSync(inRoot(STAMP), { force: true });
  const before = digest();
  await buildApps(inRoot('dist'), say);
  mkdirSync(inRoot('.cache'), { recursive: true });
  // The digest from before the build: if sources change during the build, it does not match and the next call rebuilds.
  writeFileSync(inRoot(STAMP), before);
}

/**
 * Builds the site into another folder and leaves dist/ unchanged.
 *
 * @param {string} folder
 * @param {(line: string) => void} say
 */
export async function build(folder, say) {
  await buildApps(folder, say);
  await docs.build(folder, say, true);
}

/** @param {string} folder @param {(line: string) => void} say */
async function buildApps(folder, say) {
  // Imported late, because the packages may not be installed when this module loads.
  const { buildElementScript } = await import('../site/elementScript.mjs');
  const script = await buildElementScript();
  await bundle('vite.config.ts', folder, say, script);
  await bundle('examples/vite.config.ts', folder, say);
  script.copyTo(folder);
  const { buildFrame } = await import('../site/frame.mjs');
  const { writeLicenses } = await import('../package/licenses.mjs');
  const { writeOembed } = await import('../site/oembed.mjs');
  await buildFrame(folder);
  await writeOembed(folder, publishedAt());
  await writeLicenses(folder);
}

/**
 * @param {string} config
 * @param {string} folder
 * @param {(line: string) => void} say
 * @param {import('../site/elementScript.mjs').ElementScript} [script] that the embed code of the page references
 */
async function bundle(config, folder, say, script) {
  const parameters = ['build', '--config', inRoot(config), '--outDir', folder];
  const base = publishedAt() ?? '';
  const environment = {
    CARTOON_SMOKE_BASE: base,
    VITE_ELEMENT_SCRIPT: script ? base + script.path : '',
    VITE_ELEMENT_INTEGRITY: script?.integrity ?? '',
  };
  const options = { environment, onLine: say };
  const { status, output } = await runScript('node_modules/vite/bin/vite.js', parameters, options);
  if (status === 0) return;
  throw new UserError('The site could not be built: see the bundler output above.', withoutStack(output));
}

function digest() {
  return `${digestOf(SOURCES)} ${publishedAt() ?? ''}`;
}

function withoutStack(/** @type {string} */ output) {
  return output
    .split('\n')
    .filter((line) => !/^\s+at .+\d+:\d+\)?$/.test(line))
    .join('\n');
}
