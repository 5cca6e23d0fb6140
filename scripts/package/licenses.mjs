/** Writes the licences of the third-party code in a built folder: `third-party-licenses.txt`. */

import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { cargo } from '../setup/toolchain.mjs';

export const FILE = 'third-party-licenses.txt';

/** The innermost package in a path. */
const PACKAGE = /node_modules\/(.*\/node_modules\/)?(@[^/]+\/)?[^/]+(?=\/)/;
const LICENCE_FILE = /^(licen[cs]e|notice|copying)([-_.].*)?$/i;
const WASM = ['-p', 'bindings', '--features', 'rigids', '--target', 'wasm32-unknown-unknown'];

/**
 * @typedef {object} Work
 * @property {string} name
 * @property {string} version
 * @property {string} license SPDX expression
 * @property {string} source URL of its source code
 * @property {string} folder
 */

/**
 * @param {string} folder that gets the file
 * @param {readonly string[]} [bundles] folders of built scripts with source maps, which list the bundled files
 */
export async function writeLicenses(folder, bundles = [folder]) {
  write(folder, [...packagesIn(bundles, '.'), ...(await crates())]);
}

/**
 * The same without the WASM.
 *
 * @param {string} folder
 * @param {string} home folder in the repository that has the packages
 */
export function writeScriptLicenses(folder, home) {
  write(folder, packagesIn([folder], home));
}

/** @param {string} folder @param {Work[]} works */
function write(folder, works) {
  const sorted = works.sort((a, b) => a.name.localeCompare(b.name, 'en'));
  writeFileSync(join(folder, FILE), `${[INTRODUCTION, ...describeAll(sorted)].join('\n\n')}\n`);
}

const INTRODUCTION = `Cartoon Smoke contains third-party work under the licences below. The work was bundled and minified, and unused
code was removed. It is otherwise unchanged. Each entry says where to find the source code.`;

/** @param {string} folder @returns {string[]} paths of the source maps in it */
export function sourceMaps(folder) {
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' });
  return files.filter((name) => name.endsWith('.map')).map((name) => join(folder, name));
}

/**
 * @param {readonly string[]} bundles
 * @param {string} home
 * @returns {Work[]}
 */
function packagesIn(bundles, home) {
  const folders = new Set(bundles.flatMap(sourceMaps).flatMap((map) => packageFolders(map, home)));
  return [...folders].map((place) => {
    const { name, version, license, repository } = JSON.parse(readFileSync(join(place, 'package.json'), 'utf8'));
    const address = typeof repository === 'string' ? repository : repository?.url;
    const source = address?.includes('://') ? address : `https://www.npmjs.com/package/${name}`;
    return { name, version, license, source: source.replace(/^git(\+\w+)?:/, 'https:'), folder: place };
  });
}

/**
 * Folders of the packages in a source map, independent of the output folder.
 * @param {string} map
 * @param {string} home
 */
function packageFolders(map, home) {
  /** @type {{ sources: string[] }} */
  const { sources } = JSON.parse(readFileSync(map, 'utf8'));
  return sources.flatMap((source) => PACKAGE.exec(source)?.[0] ?? []).map((path) => inRoot(`${home}/${path}`));
}

/**
 * The crates linked into the WASM.
 * @returns {Promise<Work[]>}
 */
async function crates() {
  const tree = await ask([
    'tree',
    ...WASM,
    '-e',
    'normal,no-proc-macro',
    '--prefix',
    'none',
    '--format',
    '{p}|{l}|{r}',
  ]);
  const described = await ask(['metadata', '--format-version', '1', '--all-features']);
  /** @type {{ packages: { name: string, version: string, manifest_path: string }[] }} */
  const { packages } = JSON.parse(described.find((line) => line.startsWith('{')) ?? '{"packages":[]}');
  const lines = new Set(tree.filter((line) => line.includes('|')).map((line) => line.replace(/ \(\*\)$/, '')));
  return [...lines].flatMap((line) => {
    const [, name, version, ours, license, source] = /^(\S+) v(\S+)( \(.+\))?\|(.*)\|(.*)$/.exec(line) ?? [];
    const found = packages.find((each) => each.name === name && each.version === version);
    return ours || !found ? [] : [{ name, version, license, source, folder: dirname(found.manifest_path) }];
  });
}

/** @param {string[]} parameters */
async function ask(parameters) {
  const { status, output } = await cargo([...parameters, '--locked']);
  if (status !== 0) throw new UserError('cargo could not list the crates in the WASM build.', output);
  return output.split('\n');
}

/** A line with the owner of a work, which differs between works with the same licence. */
const OWNER = /^\s*copyright (\(c\)|©|\[|\d)/i;

/**
 * Repeats no text that an earlier work has in the same words, apart from the owners.
 * @param {readonly Work[]} works
 */
function describeAll(works) {
  /** @type {Map<string, string>} */
  const holders = new Map();
  return works.map(({ name, version, license, source, folder }) => {
    const texts = licenceFiles(folder, license).map((file) => {
      const text = readFileSync(join(folder, file), 'utf8').trim();
      const lines = text.split('\n');
      const words = lines
        .filter((line) => !OWNER.test(line))
        .join(' ')
        .replace(/\s+/g, ' ')
        .trim();
      const owners = lines.flatMap((line) => (OWNER.test(line) ? line.trim() : []));
      const holder = holders.get(words);
      if (holder) return [...owners, `The rest of the licence text is the same as that of ${holder}.`].join('\n');
      holders.set(words, `${name} ${version}`);
      return text;
    });
    const none = `The package contains no licence text. See https://spdx.org/licenses/ for the licence named above.`;
    const work = `${name} ${version} (${license})\n${source}`;
    return ['-'.repeat(80), work, ...(texts.length > 0 ? texts : [none])].join('\n\n');
  });
}

/**
 * Selects MIT where the licence expression offers a choice with it.
 * @param {string} folder
 * @param {string} license
 */
function licenceFiles(folder, license) {
  const files = readdirSync(folder).filter((file) => LICENCE_FILE.test(file));
  const isChoice = /\bMIT\b/.test(license) && /\bOR\b|\//.test(license);
  return isChoice && files.length > 1 ? files.filter((file) => !/apache|zlib|unlicense/i.test(file)) : files;
}
