/** The npm package in package/, its tarball, and whether both were built from the current sources. */

import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { inRoot, root } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { runNpm } from './packages.mjs';
import { digestOf } from './sources.mjs';

export const title = 'Package';
export const FOLDER = 'package';
const FILM_PAGE = `${FOLDER}/film/page`;
/**
 * The tarball for `npm install`. Installing the folder would create a symlink, and bundlers reject files outside a
 * project.
 */
export const ARCHIVE = `cartoon-smoke-${JSON.parse(readFileSync(inRoot('package.json'), 'utf8')).version}.tgz`;

const SOURCES = [
  'LICENSE',
  'docs',
  'package-lock.json',
  'package.json',
  'scripts/film',
  'scripts/lib',
  'scripts/package',
  'scripts/patches',
  'shaders',
  'src',
  'tsconfig.json',
];
const STAMP = '.cache/package.txt';

export function isFresh() {
  if (![`${FOLDER}/package.json`, ARCHIVE, STAMP].every((path) => existsSync(inRoot(path)))) return false;
  return readFileSync(inRoot(STAMP), 'utf8') === digestOf(SOURCES);
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  rmSync(inRoot(STAMP), { force: true });
  rmSync(inRoot(FOLDER), { recursive: true, force: true });
  for (const file of readdirSync(root)) if (/^cartoon-smoke-.*\.tgz$/.test(file)) rmSync(inRoot(file));
  const before = digestOf(SOURCES);
  // Imported late: these modules read the parameter table and require packages that may not have been installed before.
  const [
    { bundleAll, bundleCommand, bundleFilmPage },
    { sourceMaps, writeLicenses },
    { removeUnused, writeTypes },
    { writeDocuments },
    { customElements, htmlCustomData, webTypes },
    { manifest },
  ] = await Promise.all([
    import('../package/bundle.mjs'),
    import('../package/licenses.mjs'),
    import('../package/types.mjs'),
    import('../package/documents.mjs'),
    import('../package/customElements.mjs'),
    import('../package/manifest.mjs'),
  ]);
  say('bundling');
  await bundleAll(inRoot(`${FOLDER}/dist`));
  await bundleFilmPage(inRoot(FILM_PAGE));
  await bundleCommand(inRoot(`${FOLDER}/film`));
  const bundles = [inRoot(`${FOLDER}/dist`), inRoot(FILM_PAGE)];
  await writeLicenses(bundles[0], bundles);
  for (const map of bundles.flatMap(sourceMaps)) rmSync(map);
  say('writing declarations');
  await writeTypes(inRoot(`${FOLDER}/types`), say);
  const entries = Object.values(manifest.exports).flatMap((each) => (typeof each === 'object' ? [each.types] : []));
  removeUnused(
    inRoot(`${FOLDER}/types`),
    entries.map((path) => inRoot(`${FOLDER}/${path}`)),
  );
  writeFileSync(inRoot(`${FOLDER}/package.json`), `${JSON.stringify(manifest, null, 2)}\n`);
  const elements = customElements();
  for (const [file, content] of Object.entries({
    'custom-elements.json': elements,
    'html-custom-data.json': htmlCustomData(elements),
    'web-types.json': webTypes(elements, manifest.version),
  })) {
    writeFileSync(inRoot(`${FOLDER}/${file}`), JSON.stringify(content));
  }
  copyFileSync(inRoot('LICENSE'), inRoot(`${FOLDER}/LICENSE`));
  writeDocuments(inRoot(FOLDER));
  say('packing');
  const { status, output } = await runNpm(['pack', '--pack-destination', root], { folder: inRoot(FOLDER) });
  if (status !== 0) throw new UserError(`npm pack failed: ${output.split('\n').at(-1)}`);
  mkdirSync(inRoot('.cache'), { recursive: true });
  writeFileSync(inRoot(STAMP), before);
}
