/** The built site in dist/, and whether it was built from the sources that lie here. */

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { run } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { publishedAt } from '../site/published.mjs';
import { digestOf } from './sources.mjs';

export const title = 'Site';

const SOURCES = [
  'embed.html',
  'examples',
  'index.html',
  'package-lock.json',
  'paper.html',
  'public',
  'scripts/package',
  'scripts/site',
  'shaders',
  'src',
  'vite.config.ts',
];
// Not in dist/, where it would be published.
const STAMP = '.cache/site.txt';

/** Whether dist/ holds what a build of the present sources, the WASM included, would write. */
export function isFresh() {
  if (!existsSync(inRoot('dist/index.html')) || !existsSync(inRoot(STAMP))) return false;
  return readFileSync(inRoot(STAMP), 'utf8') === digest();
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  rmSync(inRoot(STAMP), { force: true });
  const before = digest();
  await build(inRoot('dist'), say);
  mkdirSync(inRoot('.cache'), { recursive: true });
  // Sources that were edited meanwhile may or may not be in: then no stamp matches, and the next call builds again.
  writeFileSync(inRoot(STAMP), before);
}

/**
 * Writes the site to another folder than dist/, which stays as it is.
 *
 * @param {string} folder @param {(line: string) => void} say
 */
export async function build(folder, say) {
  // Only here are there packages for certain.
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
 * @param {string} config @param {string} folder @param {(line: string) => void} say
 * @param {import('../site/elementScript.mjs').ElementScript} [script] that the page's code for the element names
 */
async function bundle(config, folder, say, script) {
  const vite = inRoot('node_modules/vite/bin/vite.js');
  const parameters = [vite, 'build', '--config', inRoot(config), '--outDir', folder];
  const base = publishedAt() ?? '';
  const environment = {
    CARTOON_SMOKE_BASE: base,
    VITE_ELEMENT_SCRIPT: script ? base + script.path : '',
    VITE_ELEMENT_INTEGRITY: script?.integrity ?? '',
  };
  const { status, output } = await run(process.execPath, parameters, { environment, onLine: say });
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
